#pragma once

#include "engine/ensemble/ensemble.hpp"
#include "engine/history/crack_history.hpp"
#include "engine/results/schema.hpp"
#include "engine/scene/scene.hpp"

#include <span>
#include <string>

namespace rift::simulation {

using fracture::LaneUnits;

/// The movement of a lane's tip, in the lattice's time.
struct LaneHistory {
  history::CrackHistory history;
  double lead = 0;  // [s] in the lane's time from the start of the run to the first row of a measured history
};

/// The history of a lane begins a zone's length behind the notch, so that nothing is damaged in one jump; a
/// measured one is led up to as fast as its tip runs over the first zone's length.
/// @param[in] zone            L_CZM [m]
/// @param[in] rayleigh_speed  c_r [m/s]
LaneHistory lane_history(const scene::Scene& scene, double zone, double rayleigh_speed,
                         const LaneUnits& units);

/// An energy balance as a row of the results; the caller says when and where.
results::Sample sample_of(const fracture::EnergyBalance& balance);

/// The fields of one lane now, of those named: "displacement", "velocity", "damage" (of the damageable beams
/// in ascending order) and "energy" (of each beam half to each of its elements). The caller names the lane
/// and its tip. Cost O(elements) per field, O(beams) for the energy; what is not named is not computed.
results::Frame frame_of(ensemble::Ensemble& ensemble, int lane, std::span<const std::string> fields);

}  // namespace rift::simulation
