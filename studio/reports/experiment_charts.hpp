#pragma once

#include "studio/charts/chart.hpp"
#include "studio/reports/experiment_report.hpp"

#include <vector>

namespace rift::studio {

/// History and velocity as measured, release rates against position, time and velocity, the lattice
/// efficiency, and the forward check where there was one.
std::vector<NamedChart> experiment_charts(const ExperimentReport& report);

}  // namespace rift::studio
