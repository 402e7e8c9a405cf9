#pragma once

namespace rift::theory {

/// Which plane elasticity the material constants and the references are read in.
enum class Plane { stress, strain };

/// A solid in units of its shear wave speed: all that the references need of it.
struct Solid {
  double a2 = 0.0;          // (c_s / c_d)^2
  double stiffening = 0.0;  // 1 - a2 = 1 / (2 (1 - nu)), nu that of plane strain
  double yr = 0.0;          // (c_R / c_s)^2
};

/// The solid of a Poisson's ratio in (-1, 0.5] (asserted).
Solid solid(double poisson_ratio, Plane plane);

/// D / y with y = (v/c_s)^2 < 1 and D = 4 alpha_d alpha_s - (1 + alpha_s^2)^2, free of the cancellation in D
/// itself:
///   D / y = P(y) / (4 alpha_d alpha_s + (1 + alpha_s^2)^2),  P = 16 (1 - a2) + (16 a2 - 24) y + 8 y^2 - y^3
/// (D times its conjugate is y P, Rayleigh's cubic). On y = -1/eta^2 it is R(eta) / eta^2 of Broberg's
/// integral, where every term of P is positive.   [model.md §8]
double rayleigh_quotient(double y, const Solid& solid);

/// The same at y = yr v_over_cr^2, the root of P divided out, so that it keeps its digits up to v = c_R.
double rayleigh_quotient_of_velocity(double v_over_cr, const Solid& solid);

/// Speeds of an isotropic solid in the given plane elasticity [m/s], or in units of c_s where E, rho are not
/// at hand.
struct WaveSpeeds {
  double dilatational = 0.0;
  double shear = 0.0;
  double rayleigh = 0.0;
};

/// c_R / c_s: the root of D(v) = 4 alpha_d alpha_s - (1 + alpha_s^2)^2 in (0, c_s)   [model.md §8; Rayleigh
/// 1885]
/// @param poisson_ratio  of the material, in (-1, 0.5] (asserted); true to the last bits of a double
double rayleigh_over_shear(double poisson_ratio, Plane plane);

/// c_d / c_s: sqrt(2 / (1 - nu)) in plane stress, sqrt(2 (1 - nu) / (1 - 2 nu)) in plane strain   [model.md
/// §8]
/// @param poisson_ratio  of the material, in (-1, 0.5] (asserted); infinite for 0.5 in plane strain
double dilatational_over_shear(double poisson_ratio, Plane plane);

/// Speeds of a solid with Young's modulus [Pa] and density [kg/m3], both positive (asserted).
///   c_s = sqrt(E / (2 (1 + nu) rho))   [model.md §5]
WaveSpeeds wave_speeds(double young_modulus, double poisson_ratio, double density, Plane plane);

}  // namespace rift::theory
