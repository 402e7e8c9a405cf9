#include "engine/packing/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace rift::packing {
namespace {

struct CellGrid {
  Eigen::Vector3d origin;
  double cell;
  Eigen::Array3i size;

  Eigen::Array3i at(const Eigen::Vector3d& p) const {
    return ((p - origin) / cell).array().floor().cast<int>().max(0).min(size - 1);
  }
  int index(const Eigen::Array3i& c) const { return (c[0] * size[1] + c[1]) * size[2] + c[2]; }
};

CellGrid make_grid(const std::vector<Eigen::Vector3d>& points, double cell) {
  Eigen::Vector3d low = points.front(), high = points.front();
  for (const auto& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  // No more cells than about eight a point, however far apart the points lie.
  const double volume = ((high - low).array() + cell).prod();
  cell = std::max(cell, std::cbrt(volume / (8.0 * static_cast<double>(points.size()))));
  return {low, cell, ((high - low) / cell).array().floor().cast<int>() + 1};
}

}  // namespace

std::vector<std::array<int, 2>> pairs_within_reach(const std::vector<Eigen::Vector3d>& points,
                                                   const std::vector<double>& reach) {
  std::vector<std::array<int, 2>> pairs;
  if (points.empty()) return pairs;
  const CellGrid grid =
      make_grid(points, 2.0 * (1.0 + 1e-12) * *std::max_element(reach.begin(), reach.end()));

  std::vector<int> first(grid.size.prod() + 1, 0), member(points.size());
  for (const auto& p : points) ++first[grid.index(grid.at(p)) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<int> next(first.begin(), first.end() - 1);
  for (int i = 0; i < static_cast<int>(points.size()); ++i)
    member[next[grid.index(grid.at(points[i]))]++] = i;

  std::vector<int> found;
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    const Eigen::Array3i centre = grid.at(points[i]);
    const Eigen::Array3i low = (centre - 1).max(0), high = (centre + 1).min(grid.size - 1);
    found.clear();
    for (int x = low[0]; x <= high[0]; ++x)
      for (int y = low[1]; y <= high[1]; ++y)
        for (int cell = grid.index({x, y, low[2]}); cell <= grid.index({x, y, high[2]}); ++cell)
          for (int k = first[cell]; k < first[cell + 1]; ++k) {
            const int j = member[k];
            const double limit = reach[i] + reach[j];
            if (j > i && (points[j] - points[i]).squaredNorm() <= limit * limit) found.push_back(j);
          }
    std::sort(found.begin(), found.end());
    for (int j : found) pairs.push_back({i, j});
  }
  return pairs;
}

std::vector<std::array<int, 2>> pairs_through_faces(const std::vector<Eigen::Vector3d>& points,
                                                    const std::vector<double>& reach,
                                                    const Eigen::Vector3d& period) {
  std::vector<std::array<int, 2>> pairs;
  if (points.empty()) return pairs;
  // Images of what lies near a face stand beyond the opposite one, axis by axis, so that edges and corners
  // get theirs.
  std::vector<Eigen::Vector3d> all(points);
  std::vector<double> reach_of(reach);
  std::vector<int> original(points.size());
  std::iota(original.begin(), original.end(), 0);
  const double margin = 2.0 * *std::max_element(reach.begin(), reach.end());
  for (int c = 0; c < 3; ++c)
    for (std::size_t k = 0, n = all.size(); k < n; ++k)
      for (const double side : {1.0, -1.0}) {
        if (side > 0.0 ? all[k][c] > margin : all[k][c] < period[c] - margin) continue;
        all.push_back(all[k]);
        all.back()[c] += side * period[c];
        reach_of.push_back(reach_of[k]);
        original.push_back(original[k]);
      }
  for (const auto& [i, j] : pairs_within_reach(all, reach_of))
    if (i < static_cast<int>(points.size()))
      pairs.push_back({std::min(i, original[j]), std::max(i, original[j])});
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

std::vector<int> column_order(const std::vector<Eigen::Vector3d>& points, double cell) {
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int i) {
    return std::tuple(std::floor(points[i].x() / cell), points[i].y(), points[i].z(), i);
  };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
  return order;
}

}  // namespace rift::packing
