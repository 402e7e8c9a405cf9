#include "engine/theory/wave_speeds.hpp"

#include "engine/theory/rayleigh.hpp"

#include <cassert>
#include <cmath>

namespace rift::theory {

double rayleigh_over_shear(double poisson_ratio, Plane plane) {
  return std::sqrt(solid(poisson_ratio, plane).yr);
}

double dilatational_over_shear(double poisson_ratio, Plane plane) {
  return 1.0 / std::sqrt(solid(poisson_ratio, plane).a2);
}

WaveSpeeds wave_speeds(double young_modulus, double poisson_ratio, double density, Plane plane) {
  assert(young_modulus > 0.0 && density > 0.0);
  // The shear modulus is the material's own in either plane.
  const double shear = std::sqrt(young_modulus / (2.0 * (1.0 + poisson_ratio) * density));
  return {.dilatational = shear * dilatational_over_shear(poisson_ratio, plane),
          .shear = shear,
          .rayleigh = shear * rayleigh_over_shear(poisson_ratio, plane)};
}

}  // namespace rift::theory
