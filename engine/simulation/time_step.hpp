#pragma once

#include "engine/lattice/stable_step.hpp"
#include "engine/scene/preset.hpp"

#include <optional>

namespace rift::simulation {

/// Limits of the step and the step chosen [s].
struct TimeStep {
  double dt = 0;
  double critical = 0;         // undamped: 2 / omega_max
  double critical_damped = 0;  // the smaller one that viscous damping allows; equals critical without damping
  double element_bound = 0;
};

/// The default: the smaller of 0.5 dt_c and, for P-NRT, L_CZM / (5 v), put on the ladder 0.5 dt_c 2^-k so
/// that scenarios share steps   [physics.md §3].
/// @param[in] zone_length  L_CZM [m], 0 for S-NRT;  @param[in] speed  highest of the crack [m/s]
double default_step(double critical, double zone_length, double speed);

/// What a scenario asks of the step.
struct StepWish {
  double zone_length = 0, speed = 0;      // L_CZM [m], 0 for S-NRT; highest of the crack [m/s]
  std::optional<double> critical_damped;  // where its damping makes the limit smaller [s]
};

/// The step which the preset asks for, or else the default one of the wish. Throws InputError where it is not
/// below the limit.
/// @param[in] time_unit  a second of the lattice, in seconds of the preset   [LaneUnits]
TimeStep choose_step(const scene::Preset& preset, const lattice::StableStep& stable, const StepWish& wish,
                     double time_unit = 1.0);

}  // namespace rift::simulation
