#pragma once

#include "engine/packing/pile.hpp"

#include <functional>

namespace rift::packing {

/// Told the rounds (passes over all contacts) just spent; may throw to give up.
using RoundsSpent = std::function<void(int)>;

/// Moves the spheres by damped dynamics, x'' = f - c x', until the pile is
/// balanced to `tolerance` or `rounds` are spent; answers whether it is.
/// Inertia carries the pile through its rearrangements, where steepest ways
/// stall and Newton's method meets saddles; it stays in `pile.velocity` for the
/// next call.
/// @param[in] damping  c times the step: small settles softly and long, large
/// hastens the first moments
bool relax(Pile& pile, base::ThreadPool& crew, double tolerance, double damping, int rounds,
           const RoundsSpent& spent);

/// Brings a nearly balanced pile to rest: Newton's method, each step solved by
/// conjugate gradients over the present contacts and undone where it does not
/// help; dynamics in between. Ends with pile.unbalance() below `tolerance`, or
/// by what `spent` throws.
void settle(Pile& pile, base::ThreadPool& crew, double tolerance, double damping, const RoundsSpent& spent);

}  // namespace rift::packing
