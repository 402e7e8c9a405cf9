#pragma once

#include "engine/base/cache.hpp"
#include "engine/base/interrupted.hpp"
#include "engine/packing/geometry.hpp"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace rift::packing {

enum class Radii : std::uint8_t { uniform, log_normal };

/// What a packing depends on; two equal requests give the same packing, bit for bit, on one instruction set.
struct PackingRequest {
  Box box;
  int elements = 0;
  double radius_spread = 0;  // uniform: within +- this fraction of their mean; log-normal: deviation of ln r
  double coordination = 0;   // 2 contacts / N over all elements, walls not counted
  std::uint64_t seed = 0;
  Radii radii = Radii::uniform;
  double solid_fraction = 0;  // in place of the coordination where it is above 0
};

/// Overlapping spheres at rest against each other and the walls of their box.
struct Packing {
  std::vector<Eigen::Vector3d> centre;  // N [m], in rows along y that follow each other along x
  std::vector<double> radius;           // N [m]
};

/// How dense and how overlapping a packing is.
struct PackingStatistics {
  double coordination = 0;
  double solid_fraction = 0;  // sum of the spheres' volumes over the box's
  double mean_overlap = 0;    // mean of 1 - distance / (r_i + r_j) over the contacts
  double mean_radius = 0;     // [m]
};

/// A packing that cannot be made, or one that makes no specimen: why, in a sentence.
struct PackingError : std::runtime_error {
  explicit PackingError(const std::string& why, std::optional<double> reached = {})
      : std::runtime_error(why), nearest(reached) {}
  /// Where the coordination asked for is out of reach of a packing that is dense enough and not pressed too
  /// hard: that of the packing which came nearest.
  std::optional<double> nearest;
};

/// Random compact packing: spheres grow from a loose random start while their overlap energy
///   U = 1/2 sum (r_i + r_j - d_ij)^2 + sum (r_i - d_i,wall)^2
/// (a wall counts as half a contact with the sphere's mirror image; walls half as stiff make a plate of the
/// same coordination 7 % softer) is brought to a minimum by damped dynamics and, at the end, Newton's method,
/// until the coordination number at a minimum converged to 1e-6 of the mean contact force reaches the request
///   [model.md §1]. Throws PackingError where that takes a mean overlap above
///   4 %, or the packing finds no rest.
/// @param[in] threads  0 for one per core; the packing does not depend on it
/// Cost O(N): about 2,000 passes over the contacts for a plate two elements thick, several times that for a
/// block, which is near jamming at a coordination of 6.
Packing pack(const PackingRequest& request, const base::ProgressCallback& progress = {}, int threads = 0);

/// Pairs (i < j) at a distance of at most tolerance x (r_i + r_j), ordered by i, then j; in a periodic box
/// through its faces as well. Cost O(N).
std::vector<std::array<int, 2>> contacts(const Packing& packing, const Box& box, double tolerance);

PackingStatistics statistics(const Packing& packing, const Box& box);

/// Names all that a packing depends on.
std::string key_of(const PackingRequest& request);

/// The packing from the cache, or made and remembered. @param[out] from_cache  set where it was there
Packing cached_packing(const PackingRequest& request, base::Cache& cache, bool& from_cache,
                       const base::ProgressCallback& progress = {}, int threads = 0);

}  // namespace rift::packing
