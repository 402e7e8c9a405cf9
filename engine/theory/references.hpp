#pragma once

#include "engine/theory/wave_speeds.hpp"

#include <functional>

namespace rift::theory {

/// Dynamic correction of a reference problem: K/K_static and G_ID/G_I0 [-].
struct Factor {
  double k = 0.0;
  double g = 0.0;
};

/// Self-similar crack expanding from zero in an infinite plate (Broberg 1960).
///   k = D / (alpha_d (v/c_s)^2) mu A / sigma,   g = A_I k^2   [model.md §8]
/// @param v_over_cr      [-] in [0, 1]: 1 at rest, 0 at c_R (both limits); NaN outside, where no such
/// solution exists
/// @param poisson_ratio  of the material in (-1, 0.5], in plane strain below 0.5, where c_d is finite
/// (asserted) Relative error below 1e-13; some hundred evaluations of the integrand.
Factor broberg(double v_over_cr, double poisson_ratio, Plane plane);

/// Semi-infinite crack in an infinite plate (Freund 1990, ch. 6): k = freund_k, g = A_I k^2. Arguments as
/// above.
Factor freund(double v_over_cr, double poisson_ratio, Plane plane);

/// Steady crack in a clamped strip (Nilsson 1972): all the energy stored ahead arrives, g = 1 at every v <
/// c_R, so k = 1 / sqrt(A_I). Arguments as above; NaN from c_R on, where the argument of the steady state
/// ends.
Factor strip(double v_over_cr, double poisson_ratio, Plane plane);

/// A_I, which turns a stress intensity factor into a release rate: G = (1 - nu) / (2 mu) A_I K^2 (nu of plane
/// strain).
///   A_I = v^2 alpha_d / ((1 - nu) c_s^2 D)   [model.md §8]
/// @param v_over_cr  [-] in [-1, 1]; even in it, 1 at rest, infinite at c_R
double release_rate_function(double v_over_cr, double poisson_ratio, Plane plane);

/// Freund's universal function of the crack velocity, by which a static K becomes a dynamic one.
///   k(v) = (1 - v/c_R) / sqrt(1 - v/c_d) exp(1/pi int_a^b arctan[4 eta^2 sqrt((eta^2 - a^2)(b^2 - eta^2))
///          / (b^2 - 2 eta^2)^2] d eta / (1/v - eta)),   A_I(v) k(v) k(-v) = 1   [model.md §8]
/// @param v_over_cr  [-] in [-1, 1]; negative ones serve the identity
double freund_k(double v_over_cr, double poisson_ratio, Plane plane);

/// Static release rate of a central crack in a pulled plate over its half length, G_I0(a) / a = pi sigma^2 /
/// E' [J/m3], from the energy per area G_strip [J/m2] that the plate stores as a clamped strip of height H
/// [m]:
///   G_I0(a) / a = 2 pi G_strip / (H (1 - nu'^2))   [Griffith 1921; model.md §7]
/// The strip has no strain along the crack, so that its modulus M = E' / (1 - nu'^2) and, pulled by delta, it
/// has sigma = M delta / H and G_strip = M delta^2 / (2 H). nu' is Poisson's ratio in the plane: nu in plane
/// stress, nu / (1 - nu) in plane strain, where E' = E / (1 - nu^2). M itself does not appear: the formula
/// holds for the specimen's own modulus, whatever its beams are. The
/// plate has to be long against its height: free ends relieve the stress along the crack (by plane finite
/// elements the middle half of 300 x 200 mm stores 0.944 of a strip's energy, of 480 x 120 mm 0.988).
double griffith_slope(double strip_energy, double height, double poisson_ratio, Plane plane);

/// How far a tip of constant velocity advances before the first echo of its start is back [m]. The
/// dilatational wave that it sent out when it started returns
///   from the grips after t = H / sqrt(c_d^2 - v^2):  (c_d t)^2 = H^2 + (v t)^2, mirrored at half of H
///   from an end ahead after t = 2 W / (c_d + v):     c_d t = W + (W - v t)   [model.md §9.4-9.5]
/// @param[in] v       of the tip [m/s]; infinity from c_d on, where no wave catches up with it
/// @param[in] height  H [m], twice the distance from the path to the nearer grip
/// @param[in] ahead   W [m], from the start to the end of the plate
/// @param[in] c_d     dilatational speed [m/s]
double echo_free_advance(double v, double height, double ahead, double c_d);

/// Integral of f over (0, 1) by the tanh-sinh rule, which takes end points with singularities or boundary
/// layers.
///   int_0^1 f(x) dx = int f(x(t)) x'(t) dt,   x = 1 / (1 + exp(-pi sinh t))   [Takahasi and Mori 1974]
/// @param f  integrand of x and 1 - x, given both so that neither end loses digits; smooth inside
/// The step is halved until two sums agree to 1e-14 of the second (each halving squares the error, so the
/// second is then true to rounding), at most down to 1/1024.
double tanh_sinh(const std::function<double(double x, double one_minus_x)>& f);

}  // namespace rift::theory
