#pragma once

#include "engine/fracture/release_rate.hpp"
#include "engine/history/crack_history.hpp"
#include "engine/lattice/stable_step.hpp"
#include "engine/scene/preset.hpp"

#include <cstdint>
#include <optional>
#include <vector>

/// How long the steps of a run are, and which does what.
namespace rift::simulation {

/// Limits of the step and the step chosen [s].
struct TimeStep {
  double dt = 0;
  double critical = 0;         // undamped: 2 / omega_max
  double critical_damped = 0;  // the smaller one that viscous damping allows; equals critical without damping
  double element_bound = 0;
};

/// The default: the smaller of 0.5 dt_c and, for P-NRT, L_CZM / (5 v), put on the ladder 0.5 dt_c 2^-k so
/// that scenarios share steps   [model.md §3].
/// @param[in] zone_length  L_CZM [m], 0 for S-NRT;  @param[in] speed  highest of the crack [m/s]
double default_step(double critical, double zone_length, double speed);

/// What a scenario asks of the step.
struct StepRequest {
  double zone_length = 0, speed = 0;      // L_CZM [m], 0 for S-NRT; highest of the crack [m/s]
  std::optional<double> critical_damped;  // where its damping makes the limit smaller [s]
};

/// The step which the preset asks for, or else the default one of the wish. Throws InputError where it is not
/// below the limit.
/// @param[in] time_unit  a second of the lattice, in seconds of the preset   [LaneUnits]
TimeStep choose_step(const scene::Preset& preset, const lattice::StableStep& stable, const StepRequest& wish,
                     double time_unit = 1.0);

/// Which step does what; steps are counted from the start of the run, loading included.
struct Schedule {
  std::int64_t ramp = 0, hold = 0, fracture = 0;  // steps of each phase
  std::vector<std::int64_t> samples;  // steps after which the energies are read, ascending; 0 is the start
  std::vector<std::int64_t> frames;   // steps after which the fields are written, ascending
  std::int64_t crack_start() const { return ramp + hold; }
  std::int64_t total() const { return ramp + hold + fracture; }
};

/// Samples beside those asked for, which mark the ends and sub-divisions of the measuring window.
inline constexpr int window_samples = fracture::sub_windows + 1;

/// More steps than any machine takes, and few enough to be counted exactly.
inline constexpr double most_steps = 1e12;

/// Steps of the crack from its start to `end` [m], whole or not: infinite, or NaN, where no number of them
/// brings it there.
double steps_of_crack(const history::CrackHistory& history, double dt, double end);

/// A crack that runs by itself is sampled and shown at even distances of its tip. Else even samples over each
/// phase, each at the step nearest to its time, and one at each end and sub-division of the window, where the
/// tip is nearest to it; even frames over the fracture phase, its first and last moment among them.
/// @param[in] end     tip position at which the run ends [m]
/// Asks for at most most_steps steps.
/// @param[in] window  tip positions [m]
Schedule make_schedule(const scene::Scene& scene, const history::CrackHistory& history, double dt, double end,
                       const std::array<double, 2>& window);

/// Of a run that lasts fracture.duration: even samples and frames over it. @param[in] dt  [s], of the scene
Schedule schedule_of_duration(const scene::Scene& scene, double dt);

}  // namespace rift::simulation
