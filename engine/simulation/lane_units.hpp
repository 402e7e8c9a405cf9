#pragma once

#include "engine/results/schema.hpp"

#include <cmath>

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

}  // namespace rift::simulation
