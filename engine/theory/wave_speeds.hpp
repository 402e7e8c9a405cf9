#pragma once

#include "engine/theory/plane.hpp"

namespace rift::theory {

/// Speeds of an isotropic solid in the given plane elasticity [m/s], or in units of c_s where E, rho are not
/// at hand.
struct WaveSpeeds {
  double dilatational = 0.0;
  double shear = 0.0;
  double rayleigh = 0.0;
};

/// c_R / c_s: the root of D(v) = 4 alpha_d alpha_s - (1 + alpha_s^2)^2 in (0, c_s)   [physics.md §8; Rayleigh
/// 1885]
/// @param poisson_ratio  of the material, in (-1, 0.5] (asserted); true to the last bits of a double
double rayleigh_over_shear(double poisson_ratio, Plane plane);

/// c_d / c_s: sqrt(2 / (1 - nu)) in plane stress, sqrt(2 (1 - nu) / (1 - 2 nu)) in plane strain   [physics.md
/// §8]
/// @param poisson_ratio  of the material, in (-1, 0.5] (asserted); infinite for 0.5 in plane strain
double dilatational_over_shear(double poisson_ratio, Plane plane);

/// Speeds of a solid with Young's modulus [Pa] and density [kg/m3], both positive (asserted).
///   c_s = sqrt(E / (2 (1 + nu) rho))   [physics.md §5]
WaveSpeeds wave_speeds(double young_modulus, double poisson_ratio, double density, Plane plane);

}  // namespace rift::theory
