#include "engine/theory/references.hpp"

#include <cmath>
#include <limits>

namespace rift::theory {

Factor strip(double v_over_cr, double poisson_ratio, Plane plane) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (!(v_over_cr >= 0.0 && v_over_cr < 1.0)) return {nan, nan};
  return {1.0 / std::sqrt(release_rate_function(v_over_cr, poisson_ratio, plane)), 1.0};
}

}  // namespace rift::theory
