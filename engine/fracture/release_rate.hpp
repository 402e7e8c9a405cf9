#pragma once

#include "engine/results/schema.hpp"

#include <array>
#include <vector>

namespace rift::fracture {

/// What a release rate is measured against: G_I0(a) = g_i0 + g_i0_slope a at each tip, for tip positions
/// a >= 0. A strip has no slope; a central crack has nothing else, and a is its half length   [model.md
/// §7].
struct RateScale {
  double thickness = 0;   // b [m]
  double g_i0 = 0;        // [J/m2]
  double length = 0;      // L of the specimen [m]
  double g_i0_slope = 0;  // [J/m3]
  int tips = 1;           // that advance together
};

/// Mean of G_I0 over tip positions from one to another [J/m2].
double mean_g_i0(const RateScale& scale, double from, double to);

/// Release rates over G_I0 between two rows of the energy balance   [model.md §7; paper eq. (7)]:
///   ratio = (dW_ext - dW_elas - dK + dC - dW_numerical - dW_contact) / (b da G_I0), K with rotation: damping
///     counts in
///   ratio_fracture = fracture energy / (b da G_I0)
///   ratio_paper = as ratio, K without rotation
///   ratio_difference = ratio - dW_damping / (b da G_I0) - ratio_fracture: the two ways to one quantity
/// where b da G_I0 is b times the integral of G_I0(a) da, summed over the tips.
/// tip_m is the middle of the two.
results::RatePoint rate_between(const results::Sample& from, const results::Sample& to,
                                const RateScale& scale);

/// Release rate around a tip position, over `width` [m]; NaN where that reaches beyond the first or the last
/// row.
results::RatePoint rate_around(const std::vector<results::Sample>& lane, double tip, double width,
                               const RateScale& scale);

/// Release rate against tip position: centred difference over 0.01 L around each row of the balance, between
/// neighbouring rows interpolated; none where that reaches beyond the first or the last row, or, with a
/// slope, before a = 0, where there is no crack to refer to.
/// @param[in] lane  rows of one lane in the fracture phase, in time
std::vector<results::RatePoint> rate_curve(const std::vector<results::Sample>& lane, const RateScale& scale);

/// The plateau: rates over the window, and their scatter.
struct Plateau {
  results::RatePoint mean;
  double scatter = 0;                // standard deviation of ratio over ten equal sub-windows
  double trend = 0;                  // ratio of the window's second half less that of its first
  std::array<double, 2> window_m{};  // tip positions of the rows nearest to the window's ends
  bool reached = false;              // false where the run stopped before the window's end
};

inline constexpr int sub_windows = 10;

/// @param[in] window  tip positions [m]; the rows nearest to its ends and sub-divisions are used
Plateau plateau_of(const std::vector<results::Sample>& lane, const std::array<double, 2>& window,
                   const RateScale& scale);

}  // namespace rift::fracture
