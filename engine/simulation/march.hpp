#pragma once

#include "engine/simulation/prepare.hpp"

#include <functional>
#include <string>
#include <vector>

namespace rift {

/// How far a run has come.
struct Progress {
  results::Phase phase = results::Phase::fracture;
  std::int64_t step = 0, total = 0;
  double seconds = 0;  // since the first step
};

/// Called while a run marches; any of them may be empty. One way only, but for go_on's answer.
struct Observer {
  std::function<void(const results::Sample&)> sample;
  std::function<void(const results::Frame&)> frame;
  std::function<void(const results::ReleaseEvent&)> event;
  std::function<bool(const Progress&)> go_on;  // asked a few times a second; false stops the run
};

enum class Outcome { finished, stopped, diverged };
const char* name_of(Outcome outcome);

/// What a run came to.
struct RunResult {
  Outcome outcome = Outcome::finished;
  std::int64_t steps = 0;
  std::string where;                   // of a divergence or a stop, for people
  std::vector<results::Sample> books;  // all rows, in time
  double worst_residual = 0;           // largest |residual| of all rows
  double prestress_kinetic = 0;        // kinetic over total energy when the crack started (ramp)
  double energy_at_crack_start = 0;    // elastic [J]
  double wall_prestress_s = 0;         // marching the ramp
  double wall_fracture_s = 0;
};

/// The books are said not to close above this residual   [physics.md §7: linear, double].
inline constexpr double ledger_limit = 1e-10;

/// Marches a prepared scene to its end: the ramp if there is one, then the crack.
/// Stops as diverged at the first sample that is not finite or whose books are open by more than 1e-6.
RunResult march(const Prepared& prepared, const Observer& observer);

}  // namespace rift
