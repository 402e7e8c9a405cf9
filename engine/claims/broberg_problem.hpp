#pragma once

#include "engine/claims/claims.hpp"

#include <vector>

/// Broberg's own problem: a crack that opens from zero in the middle of a large plate, before any echo. What
/// arrives at its tips is Broberg's factor, and the lattice efficiency is the share of it that the damage
/// zone takes. That of the very beams which the crack breaks follows from cracks that run through the same
/// packing as through a strip, along the same line, one to the right and one to the left   [model.md §9.5].
namespace rift::claims {

// Fixed before the run that docs/beyond.md shows.

/// Half lengths that are read, over the echo-free one: from here to 1.
inline constexpr double window_from = 0.4;
/// The shortest half length that is read, in lengths of the damage zone.
inline constexpr double least_zones = 2.0;
/// Velocities at which the claim is decided [c_R]; at others one per cent of c_R is several of the factor.
inline constexpr double decided_velocities[] = {0.3, 0.5, 0.7};
/// |limit / Broberg - 1| at most this, with a standard uncertainty of at most that.
inline constexpr double broberg_margin = 0.02, broberg_uncertainty = 0.015;
/// Standard uncertainty of what arrives at the tips of the strips, relative (theory::strip_arrival).
inline constexpr double arrival_uncertainty = 0.005;

/// One velocity, zone and number of elements; a number for each packing in the order of `seed`.
struct BrobergProblem {
  double v = 0, zone = 0, elements = 0;  // v nominal [c_R]
  double radius_over_half_length = 0;    // half length in the middle of what is read
  double own_v = 0, broberg = 0;         // v over the specimens' own c_R, Broberg's factor there; means
  double per_cent_of_speed = 0;          // relative change of the factor where c_R is one per cent higher
  std::vector<long> seed;
  std::vector<double> ratio;        // G_ID / G_I0
  std::vector<double> efficiency;   // of the same beams, weighted with what arrives at each
  std::vector<double> over_theory;  // ratio / (efficiency Broberg)
};

/// Those packings that have both strips, velocities ascending, then zones, then elements. Empty without
/// series or own constants in the evidence.
std::vector<BrobergProblem> broberg_problem(const Evidence& evidence);

/// ratio / (efficiency Broberg) for R -> 0 at one velocity: L of the least squares
///   L + (c + d r_l) R / a
/// over the means of all zones and sizes, which share the limit; with one zone, L + c R / a.
/// The uncertainty is what the scatter of the packings makes of it, Student's factor counted in, and that of
/// the strips' arrival. A packing counts with all its zones, which share its beams.
struct BrobergLimit {
  double v = 0, limit = 0, uncertainty = 0, per_cent_of_speed = 0;
};

/// None for a velocity with fewer means than unknowns, or fewer than two packings of a size.
std::vector<BrobergLimit> broberg_limits(const std::vector<BrobergProblem>& points);

Judgement judge_broberg(const Evidence& evidence);

}  // namespace rift::claims
