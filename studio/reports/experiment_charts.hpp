#pragma once

#include "studio/reports/experiment_report.hpp"
#include "studio/reports/study_report.hpp"

#include <vector>

namespace rift::studio {

/// Rows and course, velocity, G_IDc against position, time and velocity, the efficiency, and the crack that
/// ran by itself.
std::vector<NamedChart> experiment_charts(const ExperimentReport& report);

}  // namespace rift::studio
