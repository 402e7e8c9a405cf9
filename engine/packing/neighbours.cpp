#include "engine/packing/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace rift::packing {

void Cells::choose_counts(const Eigen::Vector3d& extent, double width, int points) {
  for (double total = std::numeric_limits<double>::infinity(); total > 8.0 * (points + 1); width *= 1.5) {
    total = 1.0;
    for (int c = 0; c < 3; ++c) total *= std::max(1.0, std::floor(extent[c] / width));
    for (int c = 0; c < 3; ++c) per_unit_[c] = std::max(1.0, std::floor(extent[c] / width)) / extent[c];
  }
  for (int c = 0; c < 3; ++c) count_[c] = static_cast<int>(std::lround(per_unit_[c] * extent[c]));
}

void Cells::sort(const std::vector<int>& cell) {
  first_.assign(count_[0] * count_[1] * count_[2] + 1, 0);
  for (const int c : cell) ++first_[c + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  std::vector<int> next(first_.begin(), first_.end() - 1);
  member_.resize(cell.size());
  for (int i = 0; i < static_cast<int>(cell.size()); ++i) member_[next[cell[i]]++] = i;
}

std::vector<std::array<int, 2>> pairs_within_reach(const std::vector<Eigen::Vector3d>& points,
                                                   const std::vector<double>& reach) {
  std::vector<std::array<int, 2>> pairs;
  if (points.empty()) return pairs;
  const double width = 2.0 * (1.0 + 1e-12) * *std::max_element(reach.begin(), reach.end());
  Eigen::Vector3d low = points.front(), high = points.front();
  for (const auto& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  const auto count = static_cast<int>(points.size());
  const Cells cells((high - low).cwiseMax(width), width, count, [&](int i) { return points[i] - low; });

  std::vector<int> found;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d at = points[i] - low;
    found.clear();
    cells.visit_near<false>(at.x(), at.y(), at.z(), [&](int first, int last) {
      for (int k = first; k < last; ++k) {
        const int j = cells.members()[k];
        const double limit = reach[i] + reach[j];
        if (j > i && (points[j] - points[i]).squaredNorm() <= limit * limit) found.push_back(j);
      }
    });
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
