#pragma once

#include "engine/packing/packing.hpp"

namespace rift::packing {

/// How a packing is built: what tells one random packing from another.
struct PackingStructure {
  std::vector<int> coordination;  // elements with k contacts, by k
  Eigen::Matrix3d fabric =
      Eigen::Matrix3d::Zero();           // mean of n n^T over the contacts; 1/3 everywhere: isotropic
  double fabric_deviation = 0;           // largest difference of its eigenvalues from 1/3
  std::vector<double> distance;          // middles of the classes, in mean diameters
  std::vector<double> pair_correlation;  // g: pairs over those of points at random in the same space
};

/// The pair correlation by the ratio of pair counts (Peebles and Hauser 1974), with eight points an element
/// (50,000 at most) at random within the walls, so that these hardly bend it (5 % at ten elements across); up
/// to 2.5 diameters. Cost O(N).
PackingStructure structure_of(const Packing& packing, const Box& box);

}  // namespace rift::packing
