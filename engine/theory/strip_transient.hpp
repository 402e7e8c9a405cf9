#pragma once

#include <array>

namespace rift::theory {

/// Mean of G/G_I0 over a stretch of the advance of a crack that runs into a strip from its free end.
struct TransientStretch {
  double from = 0, to = 0;  // tip positions over the strip's length
  double over_g_i0 = 0;
};

/// What arrives at the tip of a crack that starts at once, with a constant velocity, from the free end of the
/// paper's plate: clamped, five times as long as high, the crack half way up. It tends to the steady strip's
/// 1, but waves of the start are still under way: 1.08 at 0.8 c_R over 0.2 to 0.4 of the length.
///   By an explicit finite-element computation (0.125 mm cells of a plate 200 mm x 40 mm, release over 1 mm,
///   plane stress, nu = 0.3) that shares nothing with this program; linear between its velocities
///   [tests/data/strip_fem.csv; model.md §9.4].
/// @param v_over_cr  [-]; below 0.1 it is that of 0.1, NaN outside (0, 1]
std::array<TransientStretch, 2> strip_transient(double v_over_cr);

/// The same over any stretch of the advance from 2 to 3.2 heights; NaN outside. At 0.3, 0.5 and 0.7 c_R (to
/// 0.01) by finite differences (H/240 cells, release over H/40, plane stress, nu = 0.28), which lose up to
/// 0.7 per cent to waves of their grid: scaled so that the mean from 2 to 3 heights is strip_transient()'s.
/// It is up to 5 per cent from 1 at 0.7 c_R. At other velocities strip_transient()'s mean itself
///   [tests/validation/strip_arrival.py, tests/data/strip_arrival.csv].
/// @param from, to  advance of the tip over the strip's height
double strip_arrival(double v_over_cr, double from, double to);

}  // namespace rift::theory
