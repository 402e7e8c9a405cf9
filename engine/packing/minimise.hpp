#pragma once

#include "engine/packing/sphere_packing.hpp"

#include <functional>

namespace rift::packing {

/// Told the rounds (passes over all contacts) just spent; may throw to give up.
using RoundsSpent = std::function<void(int)>;

/// Moves the spheres by damped dynamics, x'' = f - c x', until the packing is
/// balanced to `tolerance` or `rounds` are spent; answers whether it is.
/// Inertia carries the packing through its rearrangements, where steepest
/// descent stalls and Newton's method meets saddles; it stays in `spheres.velocity` for the
/// next call.
/// @param[in] damping  c times the step: small settles softly and long, large
/// hastens the first moments
bool damped_relaxation(SpherePacking& spheres, base::ThreadPool& pool, double tolerance, double damping,
                       int rounds, const RoundsSpent& spent);

/// Brings a nearly balanced packing to rest: Newton's method, each step solved by
/// conjugate gradients over the present contacts and undone where it does not
/// help; dynamics in between. Ends with unbalance() below `tolerance`, or
/// by what `spent` throws.
void minimise_newton(SpherePacking& spheres, base::ThreadPool& pool, double tolerance, double damping,
                     const RoundsSpent& spent);

}  // namespace rift::packing
