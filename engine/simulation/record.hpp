#pragma once

#include "engine/simulation/build_info.hpp"
#include "engine/simulation/march.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace rift {

/// What a recorded run came to: its numbers, and the summary that stands in its folder.
struct Recorded {
  RunResult result;
  nlohmann::ordered_json summary;
};

/// Marches what was prepared and writes all that it computes into the folder of a run
/// (docs/results-format.md).
/// @param folder          made by results::create_run_folder()
/// @param beside          told all of it as well; steers; what it changes is kept in results::steering_name
/// there
/// @param preparation_s   wall time that went before, for the summary's total
Recorded record_run(const Prepared& prepared, const std::filesystem::path& folder, const BuildInfo& build,
                    const Observer& beside, const MarchOptions& options = {}, double preparation_s = 0);

}  // namespace rift
