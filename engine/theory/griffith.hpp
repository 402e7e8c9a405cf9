#pragma once

#include "engine/theory/plane.hpp"

namespace rift::theory {

/// Static release rate of a central crack in a pulled plate over its half length, G_I0(a) / a = pi sigma^2 /
/// E' [J/m3], from the energy per area G_strip [J/m2] that the plate stores as a clamped strip of height H
/// [m]:
///   G_I0(a) / a = 2 pi G_strip / (H (1 - nu'^2))   [Griffith 1921; physics.md §7]
/// The strip has no strain along the crack, so that its modulus M = E' / (1 - nu'^2) and, pulled by delta, it
/// has sigma = M delta / H and G_strip = M delta^2 / (2 H). nu' is Poisson's ratio in the plane: nu in plane
/// stress, nu / (1 - nu) in plane strain, where E' = E / (1 - nu^2). M itself does not appear: the formula
/// holds for the specimen's own modulus, whatever its beams are. The
/// plate has to be long against its height: free ends relieve the stress along the crack (by plane finite
/// elements the middle half of 300 x 200 mm stores 0.944 of a strip's energy, of 480 x 120 mm 0.988).
double griffith_slope(double strip_energy, double height, double poisson_ratio, Plane plane);

}  // namespace rift::theory
