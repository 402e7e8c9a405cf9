#pragma once

#include "engine/simulation/march.hpp"
#include "studio/commands/common.hpp"
#include "studio/commands/scene_options.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

/// What `rift run` and `rift resume` have in common.
namespace rift::studio {

/// Told a few times a second; Ctrl-C is heard here.
std::function<bool(const simulation::Progress&)> telling(ProgressLine& line, const StopSignal& stop,
                                                         std::size_t elements);

/// The table of every scenario and where the files are, or with `json` the summary.
void print_run(const nlohmann::ordered_json& summary, const std::filesystem::path& folder, bool json,
               bool color, const std::string& film = {});

/// By a signal, by a budget, or by hand in the panel, which counts as a Ctrl-C.
ExitCode stopped_by(const StopSignal& stop);

/// That a run was stopped before its first step, in which nothing can be kept, and what the same command does
/// then.
/// @param what  "stopped while packing";  @param then  what the folder is like now
std::string nothing_kept_text(const std::string& what, const StopSignal& stop, const std::string& then);
ExitCode exit_code_of(simulation::Outcome outcome, const StopSignal& stop);

}  // namespace rift::studio
