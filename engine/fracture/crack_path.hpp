#pragma once

#include "engine/lattice/lattice.hpp"

#include <optional>
#include <vector>

namespace rift {

/// The line that the crack follows in the x-y plane, extruded along z: a polyline [m].
struct CrackPath {
  std::vector<Eigen::Vector2d> point;
};

/// The straight path y = height from x = 0 to x = length [m].
CrackPath straight_path(double length, double height);

/// Where the path first crosses the segment from a to b, as arc length [m]; nothing where it does not.
/// Half-open: a point on the path counts to its left side, so that two beams meeting on the path never both
/// count.
std::optional<double> first_crossing(const CrackPath& path, const Eigen::Vector2d& a,
                                     const Eigen::Vector2d& b);

/// Distance of a point from the path [m].
double distance_to(const CrackPath& path, const Eigen::Vector2d& p);

/// A beam that the crack will release, at arc length `position` = s_b [m].
struct Crossing {
  int beam = 0;
  double position = 0;
};

/// The beams whose x-y segment the path crosses, in the order the crack meets them   [physics.md §6].
std::vector<Crossing> crossings(const CrackPath& path, const Lattice& lattice);

}  // namespace rift
