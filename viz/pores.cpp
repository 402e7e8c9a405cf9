#include "viz/pores.hpp"

#include "viz/covered_cells.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace rift::viz {
namespace {

constexpr double cells_per_radius = 8;
constexpr double margin = 0.1;        // of a filler, in mean radii: elements around a pore move apart
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

/// A pore by its cells: how wide it is, and what lies around it.
struct Pore {
  Disc around;                                          // from the middle of its cells over all of them
  std::vector<std::pair<std::size_t, double>> nearest;  // to each cell: a disc and its distance

  Pore(const std::vector<Disc>& cells, const NearDiscs& near) {
    for (const Disc& cell : cells) {
      around.x += cell.x / static_cast<double>(cells.size());
      around.y += cell.y / static_cast<double>(cells.size());
      nearest.push_back(near.nearest(cell.x, cell.y));
    }
    for (const Disc& cell : cells)
      around.radius =
          std::max(around.radius, std::hypot(cell.x - around.x, cell.y - around.y) + 2 * cell.radius);
  }
  [[nodiscard]] bool has_room_for(double radius) const {
    return std::any_of(nearest.begin(), nearest.end(), [&](const auto& n) { return n.second > radius; });
  }
  /// Whether elements on both sides of the crack lie around it.
  [[nodiscard]] bool is_cut(const std::set<std::pair<std::size_t, std::size_t>>& across) const {
    std::set<std::size_t> beside;
    for (const auto& [disc, away] : nearest) beside.insert(disc);
    for (auto one = beside.begin(); one != beside.end(); ++one)
      for (auto other = std::next(one); other != beside.end(); ++other)
        if (across.contains({*one, *other})) return true;
    return false;
  }
};

}  // namespace

std::vector<Ball> pore_fillers(const results::Geometry& geometry, const std::vector<std::int32_t>& shown,
                               float scale, double stretch) {
  std::vector<Ball> fillers;
  std::vector<Disc> discs;  // of the loaded plate
  double least = INFINITY, mean = 0, behind = INFINITY;
  for (const std::int32_t i : shown) {
    const double radius = scale * geometry.radius[i];
    discs.push_back({geometry.position[i][0] * slack, geometry.position[i][1] * slack * stretch, radius});
    least = std::min(least, radius), mean += radius / static_cast<double>(shown.size());
    behind = std::min(behind, geometry.position[i][2] - radius);
  }
  if (discs.empty()) return fillers;
  CoveredCells cells(discs, least / cells_per_radius);
  for (const Disc& disc : discs) (void)cells.cover(disc);
  const NearDiscs near(discs, 2.0 * (1.0 + largest_pore) * mean);
  const auto across = pairs_across_crack(geometry, shown);
  for (const std::vector<Disc>& cells_of_pore : cells.enclosed()) {
    const Pore pore(cells_of_pore, near);
    if (pore.has_room_for(largest_pore * mean) || pore.is_cut(across)) continue;
    const auto [x, y, size] = pore.around;
    const std::size_t k = near.nearest(x, y).first;
    const double radius = size + margin * mean;
    const auto& beside = geometry.position[shown[k]];
    fillers.push_back(
        {shown[k],
         {static_cast<float>(beside[0] + (x - discs[k].x)), static_cast<float>(beside[1] + (y - discs[k].y)),
          static_cast<float>(behind - radius)},
         static_cast<float>(radius)});
  }
  return fillers;
}

}  // namespace rift::viz
