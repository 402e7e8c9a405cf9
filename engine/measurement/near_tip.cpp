#include "engine/measurement/near_tip.hpp"

#include "engine/theory/wave_speeds.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace rift::measurement {

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

namespace {

std::vector<int> chosen(const std::vector<Eigen::Vector2d>& from_tip, const IntensityFit& fit) {
  std::vector<int> points;
  for (int i = 0; i < static_cast<int>(from_tip.size()); ++i) {
    const double r = from_tip[i].norm();
    const bool at_face = from_tip[i].x() < 0.0 && std::abs(from_tip[i].y()) < fit.beside_faces;
    if (r >= fit.inner && r <= fit.outer && !at_face) points.push_back(i);
  }
  return points;
}

}  // namespace

std::optional<StressIntensity> fit_intensity(const NearTip& field,
                                             const std::vector<Eigen::Vector2d>& from_tip,
                                             const std::vector<Eigen::Vector2d>& displacement,
                                             const IntensityFit& fit) {
  const std::vector<int> points = chosen(from_tip, fit);
  const int unknowns = 2 * (fit.terms + 1), rows = 2 * static_cast<int>(points.size());
  if (rows < 3 * unknowns) return std::nullopt;
  Eigen::MatrixXd basis(rows, unknowns);
  Eigen::VectorXd seen(rows);
  for (int p = 0; p < rows / 2; ++p) {
    seen.segment<2>(2 * p) = displacement[points[p]];
    // n = 0 of sliding and opening are the shifts; in radii, so that all terms are of one size.
    for (int n = 0; n <= fit.terms; ++n)
      for (const Mode mode : {Mode::opening, Mode::sliding})
        basis.block<2, 1>(2 * p, 2 * n + (mode == Mode::sliding)) =
            field.displacement(mode, n, from_tip[points[p]] / fit.outer);
  }
  const Eigen::VectorXd size = basis.colwise().norm();
  const Eigen::MatrixXd even = basis * size.cwiseInverse().asDiagonal();
  const Eigen::VectorXd part = even.colPivHouseholderQr().solve(seen);
  const Eigen::VectorXd shift = even.leftCols<2>() * part.head<2>();
  const Eigen::VectorXd fitted = even * part;
  // A displacement of K in metres goes with r^1/2, here in units of the outer radius.
  const double per_k = 1.0 / std::sqrt(fit.outer);
  StressIntensity k;
  k.opening = part[2] / size[2] * per_k;
  k.sliding = part[3] / size[3] * per_k;
  k.release_rate = field.release_rate(k.opening, k.sliding);
  k.misfit = (seen - fitted).norm() / (fitted - shift).norm();
  k.points = rows / 2;
  return k;
}

std::optional<StressIntensity> locate_intensity(const NearTip& field,
                                                const std::vector<Eigen::Vector2d>& from_tip,
                                                const std::vector<Eigen::Vector2d>& displacement,
                                                const IntensityFit& fit, const std::array<double, 2>& reach) {
  const auto with_tip_at = [&](double ahead) {
    std::vector<Eigen::Vector2d> places(from_tip);
    for (Eigen::Vector2d& p : places) p.x() -= ahead;
    std::optional<StressIntensity> k = fit_intensity(field, places, displacement, fit);
    if (k) k->ahead = ahead;
    return k;
  };
  constexpr int tries = 24;  // the misfit has one valley, with ripples where points enter and leave the ring
  const double apart = (reach[0] + reach[1]) / tries;
  std::array<std::optional<StressIntensity>, tries + 1> tried;
  int best = -1;
  for (int k = 0; k <= tries; ++k) {
    tried[k] = with_tip_at(-reach[0] + k * apart);
    if (tried[k] && (best < 0 || tried[k]->misfit < tried[best]->misfit)) best = k;
  }
  if (best <= 0 || best == tries || !tried[best - 1] || !tried[best + 1]) return std::nullopt;
  // The vertex of the parabola through the squares around the least.
  const auto square = [&](int k) { return tried[k]->misfit * tried[k]->misfit; };
  const double before = square(best - 1), at = square(best), after = square(best + 1);
  const double bend = before - 2.0 * at + after;
  return with_tip_at(tried[best]->ahead + (bend > 0.0 ? 0.5 * apart * (before - after) / bend : 0.0));
}

}  // namespace rift::measurement
