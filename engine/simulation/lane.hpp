#pragma once

#include "engine/ensemble/ensemble.hpp"
#include "engine/history/crack_history.hpp"
#include "engine/results/schema.hpp"
#include "engine/scene/scene.hpp"

#include <cmath>
#include <span>
#include <string>

namespace rift::simulation {

/// All stiffnesses of a lattice go with E_mu, so that another E_mu changes nothing but time and energy: one
/// lattice serves scenarios of any E_mu, each in units of its own   [physics.md §5]. A factor turns what the
/// lattice shows into what the scenario does.
struct LaneUnits {
  double time = 1, energy = 1;

  results::Sample of_lane(results::Sample row) const {
    row.time_s *= time;
    row.velocity_m_s /= time;
    for (double results::Sample::*column :
         {&results::Sample::elastic_j, &results::Sample::kinetic_translation_j,
          &results::Sample::kinetic_rotation_j, &results::Sample::step_correction_j,
          &results::Sample::fracture_j, &results::Sample::damping_j, &results::Sample::numerical_damping_j,
          &results::Sample::contact_j, &results::Sample::work_external_j, &results::Sample::grip_force_n})
      row.*column *= energy;
    return row;
  }
};

/// Of a scenario whose E_mu is `stiffer` times that of the lattice.
inline LaneUnits units_of(double stiffer) { return {1.0 / std::sqrt(stiffer), stiffer}; }

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

/// The fields of one lane now, of those named: "displacement", "velocity", "damage" (of the crossing beams in
/// ascending order) and "energy" (of each beam half to each of its elements). In the lane's own units; the
/// caller names the lane. Cost O(elements) per field, O(beams) for the energy; what is not named is not
/// computed.
template <class Real>
results::Frame frame_of(ensemble::Ensemble<Real>& ensemble, int lane, std::span<const std::string> fields,
                        const LaneUnits& units);

}  // namespace rift::simulation
