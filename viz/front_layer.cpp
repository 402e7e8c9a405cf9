#include "viz/front_layer.hpp"

#include "viz/covered_cells.hpp"

#include <algorithm>
#include <numeric>

namespace rift::viz {
namespace {

constexpr double cells_per_element = 4;  // over its radius
constexpr double least_share = 0.01;     // of its disc that must be seen

}  // namespace

std::vector<std::int32_t> front_layer(const results::Geometry& geometry) {
  std::vector<std::int32_t> order(geometry.position.size());
  std::iota(order.begin(), order.end(), 0);
  if (order.empty()) return order;
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return geometry.position[a][2] > geometry.position[b][2];
  });
  std::vector<bool> seen(order.size(), false);
  std::vector<Disc> discs;
  for (std::size_t i = 0; i < order.size(); ++i)
    discs.push_back({geometry.position[i][0], geometry.position[i][1], geometry.radius[i]});
  CoveredCells cells(discs,
                     *std::min_element(geometry.radius.begin(), geometry.radius.end()) / cells_per_element);
  for (const std::int32_t i : order) seen[i] = cells.cover(discs[i]) >= least_share;
  for (const std::int32_t b : geometry.crossing)
    for (const std::int32_t i : geometry.beam[b]) seen[i] = true;
  std::vector<std::int32_t> shown;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(seen.size()); ++i)
    if (seen[i]) shown.push_back(i);
  return shown;
}

}  // namespace rift::viz
