#pragma once

#include "engine/history/crack_history.hpp"
#include "engine/scene/scene.hpp"
#include "engine/simulation/lane_units.hpp"

namespace rift::simulation {

/// What a lane's tip does, in the lattice's time.
struct LaneHistory {
  history::CrackHistory history;
  double lead = 0;  // [s] in the lane's time from the start of the run to the first row of a measured history
};

/// The history begins a zone's length behind the notch, so that nothing is damaged in one jump; a measured
/// one is led up to as fast as its tip runs over the first zone's length.
/// @param[in] zone            L_CZM [m]
/// @param[in] rayleigh_speed  c_r [m/s]
LaneHistory lane_history(const scene::Scene& scene, double zone, double rayleigh_speed,
                         const LaneUnits& units);

}  // namespace rift::simulation
