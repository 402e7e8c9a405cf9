#pragma once

#include "studio/report/stability_report.hpp"
#include "studio/report/study_charts.hpp"

namespace rift::studio {

/// Growth of the highest mode around the critical step; residuals of the books, case by case.
std::vector<NamedChart> stability_charts(const StabilityReport& report);

}  // namespace rift::studio
