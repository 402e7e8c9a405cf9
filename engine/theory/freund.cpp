#include "engine/theory/quadrature.hpp"
#include "engine/theory/rayleigh.hpp"
#include "engine/theory/references.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace rift::theory {
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

}  // namespace rift::theory
