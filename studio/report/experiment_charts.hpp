#pragma once

#include "studio/report/experiment_report.hpp"
#include "studio/report/study_charts.hpp"

#include <vector>

namespace rift::studio {

/// Rows and course, velocity, G_IDc against position, time and velocity, the efficiency, and the crack that
/// ran by itself.
std::vector<NamedChart> experiment_charts(const ExperimentReport& report);

}  // namespace rift::studio
