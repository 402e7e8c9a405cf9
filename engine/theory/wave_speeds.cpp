#include "engine/theory/wave_speeds.hpp"

#include <cassert>
#include <cmath>

namespace rift::theory {
namespace {

double cubic(double y, const Solid& s) {
  return 16.0 * s.stiffening + y * (16.0 * s.a2 - 24.0 + y * (8.0 - y));
}

// P is convex and falls from 16 (1 - a2) > 0 at y = 0 to -1 at y = 1: Newton's steps from 0 rise to the root
// and stop rising when rounding takes over.
double rayleigh_root(const Solid& s) {
  double y = 0.0;
  for (;;) {
    const double slope = 16.0 * s.a2 - 24.0 + y * (16.0 - 3.0 * y);
    const double next = y - cubic(y, s) / slope;
    if (!(next > y)) return y;
    y = next;
  }
}

double conjugate(double y, const Solid& s) {
  return 4.0 * std::sqrt((1.0 - s.a2 * y) * (1.0 - y)) + (2.0 - y) * (2.0 - y);
}

}  // namespace

Solid solid(double poisson_ratio, Plane plane) {
  assert(poisson_ratio > -1.0 && poisson_ratio <= 0.5);
  const double nu = poisson_ratio;
  Solid s;
  if (plane == Plane::stress) {
    s.a2 = 0.5 * (1.0 - nu);
    s.stiffening = 0.5 * (1.0 + nu);
  } else {
    s.a2 = 0.5 * (1.0 - 2.0 * nu) / (1.0 - nu);
    s.stiffening = 0.5 / (1.0 - nu);
  }
  s.yr = rayleigh_root(s);
  return s;
}

double rayleigh_quotient(double y, const Solid& s) { return cubic(y, s) / conjugate(y, s); }

double rayleigh_quotient_of_velocity(double v_over_cr, const Solid& s) {
  const double y = s.yr * v_over_cr * v_over_cr;
  const double root_minus_y = s.yr * (1.0 - v_over_cr) * (1.0 + v_over_cr);
  const double rest = 16.0 * s.stiffening / s.yr + y * (s.yr - 8.0 + y);  // P = (yr - y) rest
  return root_minus_y * rest / conjugate(y, s);
}

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
