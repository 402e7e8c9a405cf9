#include "engine/theory/references.hpp"

#include "engine/theory/wave_speeds.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace rift::theory {
namespace {

// sigma / (mu A) = d / b^2 int_0^inf R(eta) / (sqrt(a^2 + eta^2) (d^2 + eta^2)^(3/2)) d eta, with c_s = 1 / b
// = 1. eta = a sinh t takes the root into dt and leaves an even function, analytic for |Im t| < pi/2, which
// falls like exp(-t): the trapezoidal rule then errs by exp(-pi^2 / h) only. Points at half steps keep off
// eta = 0. With s = eta / d and R = eta^2 rayleigh_quotient(-1 / eta^2) nothing cancels and nothing
// overflows.
double remote_stress(double v, const Solid& solid) {
  constexpr double step = 0.125, negligible = 1e-18;
  const double a = std::sqrt(solid.a2);
  const double end = std::asinh(1.0 / (negligible * a * v));
  double sum = 0.0;
  for (double i = 0.5; i * step < end; i += 1.0) {
    const double eta = a * std::sinh(i * step);
    const double s = eta * v;
    sum += s * s * rayleigh_quotient(-1.0 / (eta * eta), solid) / std::pow(1.0 + s * s, 1.5);
  }
  return sum * step;
}

}  // namespace

Factor broberg(double v_over_cr, double poisson_ratio, Plane plane) {
  assert(plane == Plane::stress || poisson_ratio < 0.5);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (!(v_over_cr >= 0.0 && v_over_cr <= 1.0)) return {nan, nan};
  if (v_over_cr < 1e-20) return {1.0, 1.0};  // 1 - O(v^2 log v)
  const Solid s = solid(poisson_ratio, plane);
  const double v = std::sqrt(s.yr) * v_over_cr;
  const double alpha_d = std::sqrt(1.0 - s.a2 * v * v);
  const double sigma = remote_stress(v, s);
  const double k = rayleigh_quotient_of_velocity(v_over_cr, s) / (alpha_d * sigma);
  // A_I k^2 with the quotient, which is 0 at c_R, cancelled once: A_I = 2 (1 - a2) alpha_d / quotient.
  return {k, 2.0 * s.stiffening * k / sigma};
}

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// int_a^1 arctan[4 eta^2 sqrt((eta^2 - a^2)(1 - eta^2)) / (1 - 2 eta^2)^2] v d eta / (1 - v eta), with c_s =
// 1 / b = 1. Near nu = 0 the arctangent climbs from 0 to pi/2 in a layer at eta = a of width ~ (1 - 2 a^2)^4:
// hence tanh-sinh.
double arctan_integral(double v, const Solid& solid) {
  const double a = std::sqrt(solid.a2);
  const double width = solid.stiffening / (1.0 + a);  // 1 - a
  return width * tanh_sinh([&](double x, double one_minus_x) {
           const double eta = a + width * x;
           const double from_a = width * x * (eta + a);            // eta^2 - a^2
           const double to_b = width * one_minus_x * (1.0 + eta);  // 1 - eta^2
           const double root = 4.0 * eta * eta * std::sqrt(from_a * to_b);
           const double shear = to_b - eta * eta;  // 1 - 2 eta^2
           return std::atan2(root, shear * shear) * v / (1.0 - v * eta);
         });
}

}  // namespace

double release_rate_function(double v_over_cr, double poisson_ratio, Plane plane) {
  if (!(std::abs(v_over_cr) <= 1.0)) return nan;
  const Solid s = solid(poisson_ratio, plane);
  const double alpha_d = std::sqrt(1.0 - s.a2 * s.yr * v_over_cr * v_over_cr);
  return 2.0 * s.stiffening * alpha_d / rayleigh_quotient_of_velocity(v_over_cr, s);
}

double freund_k(double v_over_cr, double poisson_ratio, Plane plane) {
  if (!(std::abs(v_over_cr) <= 1.0)) return nan;
  const Solid s = solid(poisson_ratio, plane);
  const double v = std::sqrt(s.yr) * v_over_cr;
  return (1.0 - v_over_cr) / std::sqrt(1.0 - std::sqrt(s.a2) * v) *
         std::exp(arctan_integral(v, s) / std::numbers::pi);
}

Factor freund(double v_over_cr, double poisson_ratio, Plane plane) {
  if (!(v_over_cr >= 0.0 && v_over_cr <= 1.0)) return {nan, nan};
  if (v_over_cr == 1.0) return {0.0, 0.0};  // k^2 falls faster than A_I grows
  const double k = freund_k(v_over_cr, poisson_ratio, plane);
  return {k, release_rate_function(v_over_cr, poisson_ratio, plane) * k * k};
}

Factor strip(double v_over_cr, double poisson_ratio, Plane plane) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (!(v_over_cr >= 0.0 && v_over_cr < 1.0)) return {nan, nan};
  return {1.0 / std::sqrt(release_rate_function(v_over_cr, poisson_ratio, plane)), 1.0};
}

double griffith_slope(double strip_energy, double height, double poisson_ratio, Plane plane) {
  const double nu = plane == Plane::stress ? poisson_ratio : poisson_ratio / (1.0 - poisson_ratio);
  return 2.0 * std::numbers::pi * strip_energy / (height * (1.0 - nu * nu));
}

double echo_free_advance(double v, double height, double ahead, double c_d) {
  if (v >= c_d) return std::numeric_limits<double>::infinity();
  const double of_grips = height * v / std::sqrt((c_d - v) * (c_d + v));
  const double of_end = 2.0 * ahead * v / (c_d + v);
  return std::min(of_grips, of_end);
}

namespace {

// x(-4) = 1e-37: what lies beyond is lost in the last bit, even of integrands that grow like x^(-1/3) at an
// end.
constexpr double range = 4.0;

double weighted(const std::function<double(double, double)>& f, double t) {
  const double e = std::exp(-std::numbers::pi * std::sinh(std::abs(t)));
  const double near = e / (1.0 + e), far = 1.0 / (1.0 + e);
  const double slope = std::numbers::pi * std::cosh(t) * near * far;
  return slope * (t < 0.0 ? f(near, far) : f(far, near));
}

}  // namespace

double tanh_sinh(const std::function<double(double, double)>& f) {
  double step = 1.0 / 16.0;
  double sum = weighted(f, 0.0);
  for (int i = 1; i * step <= range; ++i) sum += weighted(f, i * step) + weighted(f, -i * step);
  for (double before = sum * step;; before = sum * step) {
    step *= 0.5;
    for (int i = 1; i * step <= range; i += 2) sum += weighted(f, i * step) + weighted(f, -i * step);
    const double now = sum * step;
    if (std::abs(now - before) <= 1e-14 * std::abs(now) || step <= 1.0 / 1024.0) return now;
  }
}

}  // namespace rift::theory
