#pragma once

#include "engine/study/runner.hpp"

#include <filesystem>
#include <string>

namespace rift::studio {

/// Writes charts/ and report.html into the folder of a study, from what is computed of it. Throws WorldError
/// where a chart cannot be drawn; the report is then written without it.
void write_study_report(const scene::Preset& preset, const simulation::BuildInfo& build,
                        const study::StudyResult& result, const std::filesystem::path& folder);

}  // namespace rift::studio
