#include "viz/front_layer.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rift::viz {
namespace {

constexpr double cells_per_radius = 4;
constexpr double least_share = 0.01;  // of its disc that must be seen

/// Discs laid down from the front: each cell belongs to the first that covers it.
class CoveredCells {
 public:
  explicit CoveredCells(const results::Geometry& geometry)
      : cell_(*std::min_element(geometry.radius.begin(), geometry.radius.end()) / cells_per_radius) {
    float low[2] = {1e30F, 1e30F}, high[2] = {-1e30F, -1e30F};
    for (std::size_t i = 0; i < geometry.position.size(); ++i)
      for (int axis = 0; axis < 2; ++axis) {
        low[axis] = std::min(low[axis], geometry.position[i][axis] - geometry.radius[i]);
        high[axis] = std::max(high[axis], geometry.position[i][axis] + geometry.radius[i]);
      }
    x0_ = low[0];
    y0_ = low[1];
    columns_ = static_cast<int>((high[0] - x0_) / cell_) + 1;
    taken_.resize(static_cast<std::size_t>(columns_) * (static_cast<int>((high[1] - y0_) / cell_) + 1),
                  false);
  }

  /// The share of the disc that nothing covers yet; it is covered then.
  double cover(double x, double y, double radius) {
    int all = 0, seen = 0;
    for (int row = index(y - radius - y0_); row <= index(y + radius - y0_); ++row)
      for (int column = index(x - radius - x0_); column <= index(x + radius - x0_); ++column) {
        const double dx = x0_ + (column + 0.5) * cell_ - x, dy = y0_ + (row + 0.5) * cell_ - y;
        if (dx * dx + dy * dy > radius * radius) continue;
        const std::size_t at = static_cast<std::size_t>(row) * columns_ + column;
        ++all;
        seen += taken_[at] ? 0 : 1;
        taken_[at] = true;
      }
    return all == 0 ? 1.0 : static_cast<double>(seen) / all;
  }

 private:
  [[nodiscard]] int index(double distance) const { return std::max(0, static_cast<int>(distance / cell_)); }

  double cell_, x0_ = 0, y0_ = 0;
  int columns_ = 0;
  std::vector<bool> taken_;
};

}  // namespace

std::vector<std::int32_t> front_layer(const results::Geometry& geometry) {
  std::vector<std::int32_t> order(geometry.position.size());
  std::iota(order.begin(), order.end(), 0);
  if (order.empty()) return order;
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return geometry.position[a][2] > geometry.position[b][2];
  });
  std::vector<bool> seen(order.size(), false);
  CoveredCells cells(geometry);
  for (const std::int32_t i : order)
    seen[i] =
        cells.cover(geometry.position[i][0], geometry.position[i][1], geometry.radius[i]) >= least_share;
  for (const std::int32_t b : geometry.crossing)
    for (const std::int32_t i : geometry.beam[b]) seen[i] = true;
  std::vector<std::int32_t> shown;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(seen.size()); ++i)
    if (seen[i]) shown.push_back(i);
  return shown;
}

}  // namespace rift::viz
