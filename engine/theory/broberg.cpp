#include "engine/theory/rayleigh.hpp"
#include "engine/theory/references.hpp"

#include <cassert>
#include <cmath>
#include <limits>

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

}  // namespace rift::theory
