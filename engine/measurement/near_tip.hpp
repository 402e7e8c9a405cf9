#pragma once

#include "engine/theory/wave_speeds.hpp"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace rift::measurement {

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

/// An isotropic plate as what is around a tip that runs through it sees it.
struct ElasticPlate {
  double young_modulus = 0, poisson_ratio = 0;  // [Pa]
  double density = 0;                           // [kg/m3]
  theory::Plane plane = theory::Plane::stress;
};

enum class Mode { opening, sliding };

/// The n-th term of the displacement around a tip that runs steadily along x with free faces, u ~ r^(n/2)
/// [Nishioka and Atluri 1983, from the potentials of Freund 1990, ch. 4]. With beta_1^2 = 1 - (v/c_d)^2,
/// beta_2^2 = 1 - (v/c_s)^2, r_k e^(i theta_k) = x + i beta_k y and
/// c_k, s_k = r_k^(n/2) (cos, sin)(n theta_k / 2), it is of opening
///
///   u_x = B (c_1 - h c_2),  u_y = B (- beta_1 s_1 + (h / beta_2) s_2),  h = h_I for odd n, h_II for even n
///
/// and of sliding
///
///   u_x = B (s_1 - h s_2),  u_y = B (beta_1 c_1 - (h / beta_2) c_2),  h = h_II for odd n, h_I for even n
///
/// with h_I = 2 beta_1 beta_2 / (1 + beta_2^2), h_II = (1 + beta_2^2) / 2, scaled so that n = 1 is the
/// displacement [m] per K_I or K_II = 1 Pa m^1/2. n = 0 is a shift, 2 in sliding a turn, 2 in opening the
/// stress along the crack.
class NearTip {
 public:
  /// @param[in] speed  of the tip [m/s], below the Rayleigh speed (asserted). Below 0.05 c_s the field is
  /// that of 0.05 c_s, which differs by some 1e-3 of it: at rest the two potentials fall together.
  NearTip(const ElasticPlate& plate, double speed);

  Eigen::Vector2d displacement(Mode mode, int term, const Eigen::Vector2d& from_tip) const;

  /// G of the stress intensities [J/m2, Pa m^1/2]: (A_I K_I^2 + A_II K_II^2) / E'   [Freund 1990, 5.3]
  double release_rate(double k_opening, double k_sliding) const;

 private:
  double beta1_, beta2_, shear_modulus_, rayleigh_;  // the last: D = 4 beta1 beta2 - (1 + beta2^2)^2
};

}  // namespace rift::measurement
