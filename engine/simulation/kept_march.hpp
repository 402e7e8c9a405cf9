#pragma once

#include "engine/simulation/application_phase.hpp"
#include "engine/simulation/march.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rift::simulation {

/// A lane and the scenario in it.
struct LaneSlot {
  int scenario = -1;  // none: the lane is idle
  std::size_t next_sample = 0, next_frame = 0;
  std::int64_t framed_at = -1;  // the step of the last frame
  Rest rest = {};
  double since_s = 0;  // of the time that cracks have run for, when its own began
};

/// Where a march was, beside the state of its ensemble: the words of a checkpoint.
struct MarchNotes {
  int lanes = 0;  // of the kernel
  std::string instructions;
  double dt = 0;  // [s], of the lattice
  std::int64_t marched = 0, lane_steps = 0;
  int next_scenario = 0;
  bool cracking = true;  // false while the ramp is marched
  double wall_prestress_s = 0, wall_fracture_s = 0;
  std::vector<LaneSlot> seats = {};   // of the lanes of the kernel
  std::vector<LaneResult> lane = {};  // without their samples, which the journal holds
};

std::string to_json(const MarchNotes& notes);
/// Throws std::invalid_argument where the text is not of such notes.
MarchNotes march_notes(const std::string& json);

/// Wall time that a run has taken up to a checkpoint, in all its calls, with what went before the march [s]:
/// said by who keeps the checkpoint, for who goes on from it; 0 where nobody said it.
void set_taken_s(results::Checkpoint& checkpoint, double seconds);
double taken_s(const results::Checkpoint& checkpoint);

/// Where a march that is not recorded as a run keeps how far it is: a pass of a study, a specimen of an
/// experiment.
struct MarchKeeping {
  std::filesystem::path folder;
  std::string identity;    // of all that the march depends on
  bool result_too = true;  // what it came to is kept as well, so that the next call finds it
  double taken_before_s =
      0;  // by the same work, before this march goes on: the checkpoint's taken_s() counts it
};

/// Where the march that the folder keeps goes on, or what it came to; none where there is no march of this
/// identity.
/// @param[out] note  why what is kept is of no use, such as its damage; may be empty
std::optional<Resumption> kept_march(const MarchKeeping& keeping, std::string& note);

/// As march(), with a checkpoint in the folder every options.checkpoint_s seconds, at a stop and, where the
/// result is kept too, at the end. Where `from` is of another march, the march begins anew. Throws WorldError
/// where the folder cannot be written, otherwise as march().
/// @param[in] from   what kept_march() has found; null to begin at the beginning
/// @param[out] note  why `from` was of no use
RunResult march_and_keep(const Prepared& prepared, const Observer& observer, const MarchOptions& options,
                         const MarchKeeping& keeping, const Resumption* from, std::string& note);

/// The identity of the march that the folder keeps; empty where it keeps none that is whole.
std::string kept_identity(const std::filesystem::path& folder);

/// Removes what is kept, and the folder.
void forget_march(const std::filesystem::path& folder);

}  // namespace rift::simulation
