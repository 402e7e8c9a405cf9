#include "engine/measurement/near_tip.hpp"

#include "engine/theory/wave_speeds.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace rift::measurement {

std::optional<LocalPlane> local_plane(const std::vector<Eigen::Vector2d>& at, const Eigen::Vector2d& middle,
                                      double radius) {
  constexpr std::size_t fewest = 6;
  constexpr double flattest = 0.05;  // of the spread across to that along
  LocalPlane plane;
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  const auto row = [&](int i) -> Eigen::Vector3d {  // in radii, so that all three are of one size
    return {1.0, (at[i].x() - middle.x()) / radius, (at[i].y() - middle.y()) / radius};
  };
  for (int i = 0; i < static_cast<int>(at.size()); ++i) {
    if ((at[i] - middle).squaredNorm() > radius * radius) continue;
    plane.point.push_back(i);
    normal += row(i) * row(i).transpose();
  }
  if (plane.point.size() < fewest) return std::nullopt;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> modes(normal);
  if (modes.eigenvalues()[0] < flattest * flattest * modes.eigenvalues()[2]) return std::nullopt;
  const Eigen::Matrix3d inverse = normal.inverse();
  for (const int i : plane.point) {
    Eigen::Vector3d weight = inverse * row(i);
    weight.tail<2>() /= radius;
    plane.weight.push_back(weight);
  }
  return plane;
}

NearTip::NearTip(const ElasticPlate& plate, double speed) {
  const theory::WaveSpeeds c =
      theory::wave_speeds(plate.young_modulus, plate.poisson_ratio, plate.density, plate.plane);
  assert(speed >= 0.0 && speed < c.rayleigh);
  const double v = std::max(speed, 0.05 * c.shear);
  beta1_ = std::sqrt(1.0 - v * v / (c.dilatational * c.dilatational));
  beta2_ = std::sqrt(1.0 - v * v / (c.shear * c.shear));
  shear_modulus_ = 0.5 * plate.young_modulus / (1.0 + plate.poisson_ratio);
  const double s = 1.0 + beta2_ * beta2_;
  rayleigh_ = 4.0 * beta1_ * beta2_ - s * s;
}

Eigen::Vector2d NearTip::displacement(Mode mode, int term, const Eigen::Vector2d& from_tip) const {
  const double s = 1.0 + beta2_ * beta2_;
  const auto half_angle = [&](double beta) {
    const double x = from_tip.x(), y = beta * from_tip.y();
    const double size = std::pow(std::hypot(x, y), 0.5 * term), angle = 0.5 * term * std::atan2(y, x);
    return Eigen::Vector2d(size * std::cos(angle), size * std::sin(angle));
  };
  const Eigen::Vector2d one = half_angle(beta1_), two = half_angle(beta2_);
  const bool opening = mode == Mode::opening, odd = term % 2 != 0;
  const double h = opening == odd ? 2.0 * beta1_ * beta2_ / s : 0.5 * s;
  const double per_k = std::sqrt(2.0 / std::numbers::pi) / (shear_modulus_ * rayleigh_);
  if (opening)
    return per_k * s * Eigen::Vector2d(one.x() - h * two.x(), -beta1_ * one.y() + h / beta2_ * two.y());
  return per_k * 2.0 * beta2_ *
         Eigen::Vector2d(one.y() - h * two.y(), beta1_ * one.x() - h / beta2_ * two.x());
}

// A_I / E' = v^2 beta_1 / (2 mu c_s^2 D), A_II with beta_2: both by (v / c_s)^2 = 1 - beta_2^2.
double NearTip::release_rate(double k_opening, double k_sliding) const {
  const double per_square = (1.0 - beta2_ * beta2_) / (2.0 * shear_modulus_ * rayleigh_);
  return per_square * (beta1_ * k_opening * k_opening + beta2_ * k_sliding * k_sliding);
}

}  // namespace rift::measurement
