#include "engine/measurement/camera.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rift::measurement {

Camera::Camera(std::vector<Eigen::Vector2d> at, std::vector<Eigen::Vector2d> point, double radius,
               const PartedAt& parted_at)
    : at_(std::move(at)), point_(std::move(point)), radius_(radius), subset_(point_.size()) {
  std::vector<int> by_x(at_.size());
  for (int i = 0; i < static_cast<int>(by_x.size()); ++i) by_x[i] = i;
  const auto before = [&](int i, double x) { return at_[i].x() < x; };
  std::sort(by_x.begin(), by_x.end(), [&](int i, int j) { return at_[i].x() < at_[j].x(); });
  for (std::size_t p = 0; p < point_.size(); ++p) {
    Subset& s = subset_[p];
    const Eigen::Vector2d middle = point_[p];
    for (auto i = std::lower_bound(by_x.begin(), by_x.end(), middle.x() - radius, before);
         i != by_x.end() && at_[*i].x() <= middle.x() + radius; ++i) {
      if ((at_[*i] - middle).squaredNorm() > radius * radius) continue;
      s.element.push_back(*i);
      s.parted_at.push_back(parted_at(middle, at_[*i]));
      s.first = std::min(s.first, s.parted_at.back());
    }
    s.whole = held(p, -std::numeric_limits<double>::infinity());
  }
}

std::optional<lattice::LocalPlane> Camera::held(std::size_t p, double tip) const {
  const Subset& s = subset_[p];
  std::vector<Eigen::Vector2d> at;
  std::vector<int> element;
  for (std::size_t k = 0; k < s.element.size(); ++k)
    if (s.parted_at[k] > tip) at.push_back(at_[s.element[k]]), element.push_back(s.element[k]);
  std::optional<lattice::LocalPlane> plane = lattice::local_plane(at, point_[p], radius_);
  if (plane)
    for (int& i : plane->point) i = element[i];
  return plane;
}

Grid grid_over(double length, double height, double apart) {
  Grid grid;
  grid.columns = std::max(1, static_cast<int>(std::lround(length / apart)));
  grid.rows = std::max(1, static_cast<int>(std::lround(height / apart)));
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i)
      grid.point.emplace_back(length * (i + 0.5) / grid.columns, height * (j + 0.5) / grid.rows);
  return grid;
}

}  // namespace rift::measurement
