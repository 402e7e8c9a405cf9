#pragma once

#include "engine/study/runner.hpp"
#include "studio/charts/chart.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rift::studio {

/// What sets a scenario or a family apart, as a label of a chart: "progressive, linear, r_l = 1, seed 2".
std::string axes_label(const nlohmann::ordered_json& axes);

/// Ratio against crack velocity beside Broberg, Freund and the strip, mean over seeds with their scatter as
/// bars; none where the study does not vary the velocity. At most 12 series a chart.
std::vector<NamedChart> velocity_charts(const std::vector<study::SummaryRow>& rows);

/// Ratio against tip position of each scenario, from the series under runs/. At most 12 series a chart.
/// @param series  by row of the study
std::vector<NamedChart> tip_charts(const std::vector<study::SummaryRow>& rows,
                                   const std::vector<std::filesystem::path>& series);

/// Writes charts/ and report.html into the folder of a study, from what is computed of it. Throws WorldError
/// where a chart cannot be drawn; the report is then written without it.
void write_study_report(const scene::Preset& preset, const simulation::BuildInfo& build,
                        const study::StudyResult& result, const std::filesystem::path& folder);

}  // namespace rift::studio
