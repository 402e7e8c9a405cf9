#pragma once

#include "engine/simulation/march.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace rift::simulation {

/// Which program made a result.
struct BuildInfo {
  std::string version;  // "0.1.0"
  std::string compiler;
};

/// What a recorded run came to: its numbers, and the summary that stands in its folder.
struct Recorded {
  RunResult result;
  nlohmann::ordered_json summary;
};

/// Marches what was prepared and writes all that it computes into the folder of a run
/// (docs/results-format.md).
/// @param folder          made by results::create_run_folder(), or claimed by the caller
///                        (results::ClaimedFolder) where other processes might write into it
/// @param beside          told all of it as well; steers; what it changes is kept in results::steering_name
/// there
/// @param preparation_s   wall time that this call has taken before, for the summary's total, which is of all
/// calls
Recorded record_run(const Prepared& prepared, const std::filesystem::path& folder, const BuildInfo& build,
                    const Observer& beside, const MarchOptions& options = {}, double preparation_s = 0);

/// Goes on with a run in its folder that was stopped or killed, from its last checkpoint, to the same bits as
/// if it had never stopped; without a checkpoint from its beginning.
/// @param prepared   of what the folder's preset says
/// @param[out] note  what is to be said of it, such as a damaged checkpoint; may be empty
/// Throws std::invalid_argument where the checkpoint is of another run, WorldError where another process
/// writes into the folder.
Recorded resume_run(const Prepared& prepared, const std::filesystem::path& folder, const BuildInfo& build,
                    const Observer& beside, std::string& note, const MarchOptions& options = {},
                    double preparation_s = 0);

/// What to say of a run's folder on a file system without locks.
std::string no_locks_note(const std::filesystem::path& folder);

/// Outcomes, rows and largest residuals of the lanes of a run that has ended, as its folder has them; nothing
/// else.
RunResult result_of_run(const std::filesystem::path& folder);

/// Whether every lane of the run in this folder has come to its end, by itself or by diverging, and the files
/// of its end are there: it is not to be resumed.
bool has_ended(const std::filesystem::path& folder);

/// Makes the files of a run's end from its journal where every lane has come to its end and one of them is
/// missing: the disk failed, or a kill came, while they were written. @return whether that was so
bool complete_end(const std::filesystem::path& folder);

/// Whether the folder holds a run of this very preset, by this program with these instructions, that has not
/// come to its end.
bool is_unfinished_run_of(const std::filesystem::path& folder, const scene::Preset& preset,
                          const BuildInfo& build);

/// The preset that a run's folder holds, with the changes of who steered it. Throws WorldError where there is
/// no run, InputError where its preset is not one of this version.
scene::Preset preset_of_run(const std::filesystem::path& folder);

}  // namespace rift::simulation
