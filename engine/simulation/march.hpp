#pragma once

#include "engine/fracture/wake.hpp"
#include "engine/results/checkpoint.hpp"
#include "engine/results/schema.hpp"
#include "engine/simulation/prepare.hpp"

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace rift::simulation {

/// How far a run has come.
struct Progress {
  results::Phase phase = results::Phase::fracture;
  std::int64_t step = 0, total = 0;  // of all scenarios together
  double seconds = 0;                // since the first step
};

struct RunResult;

/// A run as whoever steers it finds it between two steps.
struct RunSnapshot {
  Progress progress;
  /// The energies and the displacements of a scenario now, with velocities where they are wanted; nothing
  /// where it does not march. Cost: a copy; of energies and velocities Ensemble::balance().
  std::function<std::optional<results::Sample>(int scenario)> sample;
  std::function<std::optional<results::Frame>(int scenario, bool velocity)> frame;
};

/// The commands of whoever steers a run. Whoever wants it to wait answers late; waiting is not counted as
/// marching.
struct SteeringCommands {
  bool stop = false;
  std::vector<scene::Change> changes = {};  // made now: their steps are filled in
  std::vector<int> frames = {};             // scenarios whose fields are to be written now
  bool wait = false;                        // asked again before the next step
  std::int64_t steps = 0;  // asked again after so many steps; 0: after a twentieth of a second
};

enum class CheckpointMoment { on_the_way, before_stop, at_end };

/// Called while a run marches; any of them may be empty. One way only, but for the answers of go_on and
/// steer.
struct Observer {
  std::function<void(const results::Sample&)> sample = {};
  std::function<void(const results::Frame&)> frame = {};
  std::function<void(const results::ReleaseEvent&)> event = {};
  std::function<void(const results::GaugeRow&)> gauge = {};  // of each gauge, with every sample
  std::function<bool(const Progress&)> go_on = {};  // asked a few times a second; false stops the run
  /// A scenario has come to its end, or a stop; the result holds it and, so far, the times of the run.
  std::function<void(int scenario, const RunResult& so_far)> ended = {};
  std::function<SteeringCommands(const RunSnapshot&)> steer = {};
  /// A scenario has marched its last step: what it came to can still be looked at.
  std::function<void(const RunSnapshot&, int scenario)> last_moment = {};
  /// Offered a few times a second, before a stop, and at the end where every scenario has come to its own:
  /// makes a checkpoint for who wants one (its journal_bytes are the caller's). Cost of making one: a copy of
  /// the state.
  std::function<void(const std::function<results::Checkpoint()>& make, CheckpointMoment moment)> checkpoint =
      {};
  /// The march has ended, and so much is to be done yet.
  std::function<void(const char* stage)> stage = {};
  /// A change was made, or (with the reason) was not.
  std::function<void(const scene::Change&, const std::string& refused)> changed = {};
};

enum class Outcome { finished, stopped, diverged };
const char* name_of(Outcome outcome);

/// What became of beams that break by themselves.
struct BrokenBeams {
  int gone = 0, softened = 0;  // of the latter something is left; the notch's are not counted
  double first_s = -1;         // when the first was gone; below 0: none is
  double leading_m = -1;       // BrokenBeams::leading(); below 0: there is none
};

/// What one scenario came to. Steps and times are its own: the same whatever ran beside it.
struct LaneResult {
  Outcome outcome = Outcome::finished;
  std::int64_t steps = 0;
  std::string where;                     // of a divergence or a stop, for people
  std::vector<results::Sample> samples;  // in time
  double worst_residual = 0;             // largest |residual| of all samples
  std::int64_t last_good_step = -1;      // at which the energy balance was looked at and not hopeless
  double prestress_kinetic = 0;          // kinetic over total energy when the crack started (ramp)
  double energy_at_crack_start = 0;      // elastic [J]
  BrokenBeams broken;
  fracture::Wake wake;                 // when it finished, of two heights behind the tip, or between two tips
  double wall_s = 0;                   // its share of the time while its crack ran
  std::vector<scene::Change> changes;  // those that were made, its own velocities among them
  double arrested_m = std::numeric_limits<double>::quiet_NaN();  // where a crack that runs by itself stopped
};

/// What a run came to.
struct RunResult {
  Outcome outcome = Outcome::finished;  // the worst of the lanes
  std::vector<LaneResult> lane;
  std::int64_t lane_steps = 0;  // steps of all lanes that had a scenario
  std::int64_t lane_room = 0;   // steps of all lanes of the kernel, idle ones too
  double wall_prestress_s = 0;  // marching the ramp
  double wall_fracture_s = 0;
  int lanes = 1, threads = 1;  // side by side
  std::string instructions;
  std::vector<LanePlan> steered;  // all lanes as they are after the changes; empty where nothing was changed
};

/// Where a march goes on.
struct Resumption {
  results::Checkpoint checkpoint;
  std::vector<results::Sample> samples;  // the samples of all lanes up to there, in time
};

/// How to march; of no influence on the results, but for the last bits by the instruction set.
struct MarchOptions {
  int threads = 0;           // 0 for one per available CPU
  int lanes = 0;             // scenarios side by side; 0 for as many as fill a register
  double checkpoint_s = 30;  // between two checkpoints of a recorded run
};

/// The energy balance is said not to close above this error   [model.md §7].
double ledger_limit(lattice::Kinematics kinematics, ensemble::Precision precision);

/// Throws InputError where the grip moves in the march's time and the lanes cannot share it: they are more
/// than go side by side (0: as many as there are kernels for), or a load curve's clock is not the same for
/// all.
void check_grip(const Prepared& prepared, int side_by_side = 0);

/// Marches a prepared scene's lanes to their ends: the ramp if there is one, then their cracks. Where there
/// are more scenarios than lanes side by side, a lane that has come to its end takes up the next (but not
/// where the grip, which all share, moves: check_grip). A lane
/// stops as diverged at its first sample that is not finite or whose energy balance is hopelessly open; the
/// others go on. The preset's [[steering]] is made where it says; a change that cannot be made then throws
/// InputError.
/// @param[in] from  where the same run was stopped or killed; null to begin at the beginning
RunResult march(const Prepared& prepared, const Observer& observer, const MarchOptions& options = {},
                const Resumption* from = nullptr);

}  // namespace rift::simulation
