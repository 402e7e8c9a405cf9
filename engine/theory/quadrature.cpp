#include "engine/theory/quadrature.hpp"

#include <cmath>
#include <numbers>

namespace rift::theory {
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
