#include "viz/covered_cells.hpp"

#include <algorithm>
#include <cmath>

namespace rift::viz {

CoveredCells::CoveredCells(const std::vector<Disc>& discs, double cell) : cell_(cell) {
  double high_x = -1e30, high_y = -1e30;
  x0_ = y0_ = 1e30;
  for (const Disc& d : discs) {
    x0_ = std::min(x0_, d.x - d.radius), high_x = std::max(high_x, d.x + d.radius);
    y0_ = std::min(y0_, d.y - d.radius), high_y = std::max(high_y, d.y + d.radius);
  }
  x0_ -= 2 * cell_, y0_ -= 2 * cell_;  // a bare rim joins all that is outside
  columns_ = static_cast<int>((high_x - x0_) / cell_) + 3;
  rows_ = static_cast<int>((high_y - y0_) / cell_) + 3;
  taken_.resize(static_cast<std::size_t>(columns_) * rows_, false);
}

int CoveredCells::column_at(double x) const {
  return std::clamp(static_cast<int>((x - x0_) / cell_), 0, columns_ - 1);
}

int CoveredCells::row_at(double y) const {
  return std::clamp(static_cast<int>((y - y0_) / cell_), 0, rows_ - 1);
}

double CoveredCells::cover(const Disc& disc) {
  int all = 0, bare = 0;
  for (int row = row_at(disc.y - disc.radius); row <= row_at(disc.y + disc.radius); ++row)
    for (int column = column_at(disc.x - disc.radius); column <= column_at(disc.x + disc.radius); ++column) {
      const double dx = x0_ + (column + 0.5) * cell_ - disc.x, dy = y0_ + (row + 0.5) * cell_ - disc.y;
      if (dx * dx + dy * dy > disc.radius * disc.radius) continue;
      const std::size_t at = static_cast<std::size_t>(row) * columns_ + column;
      ++all;
      bare += taken_[at] ? 0 : 1;
      taken_[at] = true;
    }
  return all == 0 ? 1.0 : static_cast<double>(bare) / all;
}

std::vector<std::size_t> CoveredCells::group_of(std::size_t cell, std::vector<bool>& seen) const {
  std::vector<std::size_t> group{cell};
  seen[cell] = true;
  for (std::size_t next = 0; next < group.size(); ++next) {
    const auto column = static_cast<int>(group[next] % columns_),
               row = static_cast<int>(group[next] / columns_);
    const auto visit = [&](int c, int r) {
      if (c < 0 || r < 0 || c >= columns_ || r >= rows_) return;
      const std::size_t at = static_cast<std::size_t>(r) * columns_ + c;
      if (taken_[at] || seen[at]) return;
      seen[at] = true;
      group.push_back(at);
    };
    for (int r = row - 1; r <= row + 1; ++r)
      for (int c = column - 1; c <= column + 1; ++c) visit(c, r);
  }
  return group;
}

std::vector<std::vector<Disc>> CoveredCells::enclosed() const {
  std::vector<bool> seen(taken_.size(), false);
  (void)group_of(0, seen);  // the outside
  std::vector<std::vector<Disc>> groups;
  for (std::size_t cell = 0; cell < taken_.size(); ++cell) {
    if (taken_[cell] || seen[cell]) continue;
    std::vector<Disc>& group = groups.emplace_back();
    for (const std::size_t k : group_of(cell, seen))
      group.push_back({x0_ + (static_cast<double>(k % columns_) + 0.5) * cell_,
                       y0_ + (static_cast<double>(k / columns_) + 0.5) * cell_, 0.5 * cell_});
  }
  return groups;
}

}  // namespace rift::viz
