#pragma once

#include "engine/claims/claims.hpp"
#include "engine/experiment/experiment.hpp"
#include "studio/text/planned_work.hpp"

#include <CLI/App.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace rift::studio {

// What commands of many scenarios would do, from the very plans by which they do it; and what they ask of a
// preset before they begin.

/// Longer than this is not begun without being asked for [s].
inline constexpr double long_work_s = 600.0;

/// Where `rift study PRESET` works by default: studies/NAME.
std::filesystem::path study_folder(const std::string& preset);

/// Throws InputError unless the preset holds a study.
void check_holds_study(const scene::Preset& preset);

/// Throws InputError unless the preset holds one crack with a measured history.
void check_one_history(const scene::Preset& preset);

/// --resamples and --specimens.
void add_experiment_parts(CLI::App& command, experiment::ExperimentOptions& parts);

/// @param[in] command  without its options: "rift study study_release --set 'specimen.seed=3'"
/// @param[in] folder  of the study, which may hold a part of it
PlannedWork planned_study(const scene::Preset& preset, const std::string& command,
                          const std::filesystem::path& folder);

/// What a dry run knows of the measured crack, on this machine and now.
struct MeasuredCrack {
  double steps = 0, seconds = 0;
};

/// Its cracks at the pace of the measured one.
PlannedWork planned_experiment(const scene::Preset& preset, const std::string& command,
                               const experiment::ExperimentOptions& options, const MeasuredCrack& crack);
/// With the report that `--out` asks for.
PlannedWork planned_calibration(const scene::Scene& scene, const std::string& command, int threads);
PlannedWork planned_reproduction(const std::vector<std::string>& names, claims::Effort effort, int threads);

}  // namespace rift::studio
