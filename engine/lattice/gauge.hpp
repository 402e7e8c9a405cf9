#pragma once

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

namespace rift::lattice {

/// The best plane through what is known at scattered points, u(p) = u_0 + grad u (p - p_0), as weights of the
/// points: least squares over those within a circle   [what a strain gauge or a camera's subset shows].
struct LocalPlane {
  std::vector<int> point;
  std::vector<Eigen::Vector3d> weight;  // of each point: in the value at the middle, in d/dx, in d/dy
};

/// Nothing where fewer than six points lie in the circle, or all about on a line.
/// @param[in] at      N places [m]
/// @param[in] middle  p_0
std::optional<LocalPlane> local_plane(const std::vector<Eigen::Vector2d>& at, const Eigen::Vector2d& middle,
                                      double radius);

/// Value and slopes of a motion in the plane.
struct PlaneMotion {
  Eigen::Vector3d u = Eigen::Vector3d::Zero();
  Eigen::Vector3d by_x = Eigen::Vector3d::Zero(), by_y = Eigen::Vector3d::Zero();
  double strain_xx() const { return by_x.x(); }
  double strain_yy() const { return by_y.y(); }
  double strain_xy() const { return 0.5 * (by_x.y() + by_y.x()); }
};

/// @param[in] motion  of a point, by its number
template <class Motion>
PlaneMotion motion_in(const LocalPlane& plane, const Motion& motion) {
  PlaneMotion sum;
  for (std::size_t k = 0; k < plane.point.size(); ++k) {
    const Eigen::Vector3d moved = motion(plane.point[k]);
    sum.u += plane.weight[k][0] * moved;
    sum.by_x += plane.weight[k][1] * moved;
    sum.by_y += plane.weight[k][2] * moved;
  }
  return sum;
}

/// A virtual strain gauge and velocity probe: what it shows is the best plane through the motions of the
/// elements under it, whatever their place through the thickness.
struct Gauge {
  std::array<double, 2> point{};  // [m]
  LocalPlane plane;
};

}  // namespace rift::lattice
