#include "engine/theory/griffith.hpp"

#include <numbers>

namespace rift::theory {

double griffith_slope(double strip_energy, double height, double poisson_ratio, Plane plane) {
  const double nu = plane == Plane::stress ? poisson_ratio : poisson_ratio / (1.0 - poisson_ratio);
  return 2.0 * std::numbers::pi * strip_energy / (height * (1.0 - nu * nu));
}

}  // namespace rift::theory
