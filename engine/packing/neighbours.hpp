#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace rift::packing {

/// Pairs (i < j) of points no further apart than reach(i) + reach(j), ordered by i, then j; found by a cell
/// grid, O(N).
/// @param[in] points  N positions
/// @param[in] reach   N, the radius around each point (same unit)
std::vector<std::array<int, 2>> pairs_within_reach(const std::vector<Eigen::Vector3d>& points,
                                                   const std::vector<double>& reach);

/// The same in a periodic box [0, period], pairs through its faces counted too; each pair once, a period
/// being longer than twice what any pair reaches.
std::vector<std::array<int, 2>> pairs_through_faces(const std::vector<Eigen::Vector3d>& points,
                                                    const std::vector<double>& reach,
                                                    const Eigen::Vector3d& period);

/// An order of the points that keeps neighbours near: columns one `cell` wide along x, within a column along
/// y, then z.
std::vector<int> column_order(const std::vector<Eigen::Vector3d>& points, double cell);

}  // namespace rift::packing
