#pragma once

#include "engine/theory/plane.hpp"

namespace rift::theory {

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
/// integral, where every term of P is positive.   [physics.md §8]
double rayleigh_quotient(double y, const Solid& solid);

/// The same at y = yr v_over_cr^2, the root of P divided out, so that it keeps its digits up to v = c_R.
double rayleigh_quotient_of_velocity(double v_over_cr, const Solid& solid);

}  // namespace rift::theory
