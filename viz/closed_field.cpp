#include "viz/closed_field.hpp"

#include "viz/covered_cells.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace rift::viz {
namespace {

constexpr double cells_per_radius = 8;
constexpr double slack = 1.03;        // waves draw the lattice more than the load does
constexpr double largest_pore = 1.5;  // of its middle from the nearest element, in mean radii

/// The discs around a place, without asking all of them.
class NearDiscs {
 public:
  NearDiscs(const std::vector<Disc>& discs, double reach) : discs_(discs), reach_(reach) {
    for (std::size_t k = 0; k < discs.size(); ++k) bins_[bin_of(discs[k].x, discs[k].y)].push_back(k);
  }

  /// The disc whose edge is nearest and how far it is; the number of discs where none is near.
  [[nodiscard]] std::pair<std::size_t, double> nearest(double x, double y) const {
    std::pair<std::size_t, double> best{discs_.size(), INFINITY};
    const auto [column, row] = bin_of(x, y);
    for (int r = row - 1; r <= row + 1; ++r)
      for (int c = column - 1; c <= column + 1; ++c)
        if (const auto bin = bins_.find({c, r}); bin != bins_.end())
          for (const std::size_t k : bin->second)
            if (const double away = std::hypot(discs_[k].x - x, discs_[k].y - y) - discs_[k].radius;
                away < best.second)
              best = {k, away};
    return best;
  }

 private:
  [[nodiscard]] std::pair<int, int> bin_of(double x, double y) const {
    return {static_cast<int>(std::floor(x / reach_)), static_cast<int>(std::floor(y / reach_))};
  }

  const std::vector<Disc>& discs_;
  double reach_;
  std::map<std::pair<int, int>, std::vector<std::size_t>> bins_;
};

/// Which of the shown elements a crossing beam joins, by pairs.
std::set<std::pair<std::size_t, std::size_t>> pairs_across_crack(const results::Geometry& geometry,
                                                                 const std::vector<std::int32_t>& shown) {
  std::map<std::int32_t, std::size_t> place;
  for (std::size_t k = 0; k < shown.size(); ++k) place[shown[k]] = k;
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  for (const std::int32_t b : geometry.crossing) {
    const auto first = place.find(geometry.beam[b][0]), second = place.find(geometry.beam[b][1]);
    if (first != place.end() && second != place.end())
      pairs.insert(std::minmax(first->second, second->second));
  }
  return pairs;
}

/// The cells of a pore and the disc that is nearest to each, with its distance from it.
struct Pore {
  const std::vector<Disc>& cells;
  std::vector<std::pair<std::size_t, double>> nearest;

  [[nodiscard]] bool has_room_for(double radius) const {
    return std::any_of(nearest.begin(), nearest.end(), [&](const auto& n) { return n.second > radius; });
  }
  /// Whether elements on both sides of the crack lie around it.
  [[nodiscard]] bool is_cut(const std::set<std::pair<std::size_t, std::size_t>>& across) const {
    std::set<std::size_t> around;
    for (const auto& [disc, away] : nearest) around.insert(disc);
    for (auto one = around.begin(); one != around.end(); ++one)
      for (auto other = std::next(one); other != around.end(); ++other)
        if (across.contains({*one, *other})) return true;
    return false;
  }
};

}  // namespace

std::vector<float> radii_without_pores(const results::Geometry& geometry,
                                       const std::vector<std::int32_t>& shown, float scale, double stretch) {
  std::vector<float> radii;
  std::vector<Disc> discs;
  for (const std::int32_t i : shown) {
    radii.push_back(scale * geometry.radius[i]);
    discs.push_back(
        {geometry.position[i][0] * slack, geometry.position[i][1] * slack * stretch, radii.back()});
  }
  if (discs.empty()) return radii;
  const float least = *std::min_element(radii.begin(), radii.end());
  const double mean = std::accumulate(radii.begin(), radii.end(), 0.0) / static_cast<double>(radii.size());
  CoveredCells cells(discs, least / cells_per_radius);
  for (const Disc& disc : discs) (void)cells.cover(disc);
  const NearDiscs near(discs, 2.0 * (1.0 + largest_pore) * mean);
  const auto across = pairs_across_crack(geometry, shown);
  for (const std::vector<Disc>& cells_of_pore : cells.enclosed()) {
    Pore pore{cells_of_pore, {}};
    for (const Disc& cell : pore.cells) pore.nearest.push_back(near.nearest(cell.x, cell.y));
    if (pore.has_room_for(largest_pore * mean) || pore.is_cut(across)) continue;
    for (std::size_t k = 0; k < pore.cells.size(); ++k) {
      const auto [disc, away] = pore.nearest[k];
      const double needed = discs[disc].radius + away + std::sqrt(2.0) * pore.cells[k].radius;
      radii[disc] = std::max(radii[disc], static_cast<float>(needed));
    }
  }
  return radii;
}

}  // namespace rift::viz
