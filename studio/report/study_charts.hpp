#pragma once

#include "engine/study/runner.hpp"
#include "studio/report/chart.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rift::studio {

/// A chart of a study, before it is drawn.
struct NamedChart {
  std::string name, caption;
  Chart chart;
};

/// What sets a scenario or a family apart, as a label of a chart: "progressive, linear, r_l = 1, seed 2".
std::string axes_label(const nlohmann::ordered_json& axes);

/// Ratio against crack velocity beside Broberg, Freund and the strip, mean over seeds with their scatter as
/// bars; none where the study does not vary the velocity. At most 12 series a chart.
std::vector<NamedChart> velocity_charts(const std::vector<study::SummaryRow>& rows);

/// Ratio against tip position of each scenario, from the series under runs/. At most 12 series a chart.
/// @param series  by row of the study
std::vector<NamedChart> tip_charts(const std::vector<study::SummaryRow>& rows,
                                   const std::vector<std::filesystem::path>& series);

}  // namespace rift::studio
