#pragma once

#include "studio/charts/chart.hpp"
#include "studio/reports/study_families.hpp"

#include <filesystem>
#include <vector>

namespace rift::studio {

// The charts of a study: few curves in one chart, many as small multiples, seeds as a mean and its scatter.

/// Release rate in the window against crack velocity beside Broberg, Freund and the strip; bars are the
/// standard deviation between specimens. None where the study does not vary the velocity.
std::vector<NamedChart> velocity_charts(const study::StudyRows& rows);

/// Release rate against tip position: the mean over the specimens, and their extent as a band.
/// @param series  the scenarios' files, by row of the study. Throws WorldError where one cannot be read
std::vector<NamedChart> tip_charts(const study::StudyRows& rows,
                                   const std::vector<std::filesystem::path>& series);

}  // namespace rift::studio
