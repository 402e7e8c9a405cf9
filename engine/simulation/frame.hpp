#pragma once

#include "engine/ensemble/ensemble.hpp"
#include "engine/results/schema.hpp"
#include "engine/simulation/lane_units.hpp"

#include <span>
#include <string>

namespace rift::simulation {

/// The fields of one lane now, of those named: "displacement", "velocity", "damage" (of the crossing beams in
/// ascending order) and "energy" (of each beam half to each of its elements). In the lane's own units; the
/// caller names the lane. Cost O(elements) per field, O(beams) for the energy; what is not named is not
/// computed.
template <class Real>
results::Frame frame_of(ensemble::Ensemble<Real>& ensemble, int lane, std::span<const std::string> fields,
                        const LaneUnits& units);

}  // namespace rift::simulation
