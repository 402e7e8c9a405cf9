#pragma once

#include "engine/base/interrupted.hpp"
#include "engine/simulation/prepare.hpp"

namespace rift::simulation {

/// G / G_I0 of the first lane's crack, run through a window infinitely slowly: what two plates at rest, cut
/// and softened as with the tip at the window's ends, differ by in energy
///   (U(a_0) - U(a_1)) / (b times the integral of G_I0 da)
/// A crack that releases beams at once radiates the same share however slow it is, and has no such limit.
/// Cost: two static solutions. Throws StaticsError, Interrupted.
/// @param[in] window  tip positions [m]
double quasi_static_ratio(const Prepared& prepared, const std::array<double, 2>& window,
                          const base::FractionTold& told = {});

/// -dU/da of a slow crack between each two neighbours of these tip positions [m], in J/m2: one less than
/// positions. Cost: a static solve for each.
std::vector<double> quasi_static_rates(const Prepared& prepared, const std::vector<double>& tip,
                                       const base::FractionTold& told = {});

}  // namespace rift::simulation
