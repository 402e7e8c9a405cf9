#pragma once

#include "engine/fracture/wake.hpp"
#include "engine/results/schema.hpp"
#include "engine/simulation/prepare.hpp"

#include <functional>
#include <string>
#include <vector>

namespace rift {

/// How far a run has come.
struct Progress {
  results::Phase phase = results::Phase::fracture;
  std::int64_t step = 0, total = 0;  // of all scenarios together
  double seconds = 0;                // since the first step
};

struct RunResult;

/// Called while a run marches; any of them may be empty. One way only, but for go_on's answer.
struct Observer {
  std::function<void(const results::Sample&)> sample;
  std::function<void(const results::Frame&)> frame;
  std::function<void(const results::ReleaseEvent&)> event;
  std::function<bool(const Progress&)> go_on;  // asked a few times a second; false stops the run
  /// A scenario has come to its end, or a stop; the result holds it and, so far, the times of the run.
  std::function<void(int scenario, const RunResult& so_far)> ended = {};
};

enum class Outcome { finished, stopped, diverged };
const char* name_of(Outcome outcome);

/// What one scenario came to. Steps and times are its own: the same whatever ran beside it.
struct LaneResult {
  Outcome outcome = Outcome::finished;
  std::int64_t steps = 0;
  std::string where;                   // of a divergence or a stop, for people
  std::vector<results::Sample> books;  // all rows, in time
  double worst_residual = 0;           // largest |residual| of all rows
  double prestress_kinetic = 0;        // kinetic over total energy when the crack started (ramp)
  double energy_at_crack_start = 0;    // elastic [J]
  Wake wake;                           // when it finished, of two heights behind the tip, or between two tips
  double wall_s = 0;                   // its share of the time while its crack ran
};

/// What a run came to.
struct RunResult {
  Outcome outcome = Outcome::finished;  // the worst of the lanes
  std::vector<LaneResult> lane;
  std::int64_t lane_steps = 0;  // steps of all lanes that had a scenario
  double wall_prestress_s = 0;  // marching the ramp
  double wall_fracture_s = 0;
  int lanes = 1, threads = 1;  // side by side
  std::string instructions;
};

/// How to march; of no influence on the results, but for the last bits by the instruction set.
struct MarchOptions {
  int threads = 0;  // 0 for one per core
  int lanes = 0;    // scenarios side by side; 0 for all of them, as far as there are kernels
};

/// The books are said not to close above this residual   [physics.md §7].
double ledger_limit(Kinematics kinematics, Precision precision);

/// Marches a prepared scene's lanes to their ends: the ramp if there is one, then their cracks. Where there
/// are more scenarios than lanes side by side, a lane that has come to its end takes up the next (but after a
/// ramp, which all share). A lane stops as diverged at its first sample that is not finite or whose books are
/// hopelessly open; the others go on.
RunResult march(const Prepared& prepared, const Observer& observer, const MarchOptions& options = {});

}  // namespace rift
