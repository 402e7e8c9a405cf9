#include "engine/theory/echo.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift::theory {

double echo_free_advance(double v, double height, double ahead, double c_d) {
  if (v >= c_d) return std::numeric_limits<double>::infinity();
  const double of_grips = height * v / std::sqrt((c_d - v) * (c_d + v));
  const double of_end = 2.0 * ahead * v / (c_d + v);
  return std::min(of_grips, of_end);
}

}  // namespace rift::theory
