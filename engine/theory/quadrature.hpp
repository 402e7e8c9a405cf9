#pragma once

#include <functional>

namespace rift::theory {

/// Integral of f over (0, 1) by the tanh-sinh rule, which takes end points with singularities or boundary
/// layers.
///   int_0^1 f(x) dx = int f(x(t)) x'(t) dt,   x = 1 / (1 + exp(-pi sinh t))   [Takahasi and Mori 1974]
/// @param f  integrand of x and 1 - x, given both so that neither end loses digits; smooth inside
/// The step is halved until two sums agree to 1e-14 of the second (each halving squares the error, so the
/// second is then true to rounding), at most down to 1/1024.
double tanh_sinh(const std::function<double(double x, double one_minus_x)>& f);

}  // namespace rift::theory
