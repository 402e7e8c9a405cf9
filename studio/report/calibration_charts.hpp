#pragma once

#include "engine/study/series_table.hpp"
#include "studio/report/study_charts.hpp"

namespace rift::studio {

/// The charts of a calibration from its rows (engine/calibration/calibration_study.hpp): E and nu against the
/// number of elements and against the coordination of the core, with beams of this modulus; E_M / E_mu and nu
/// against r_mu. Means over the packings with their standard deviation.
/// @param[in] micro_young_modulus  [Pa]
std::vector<NamedChart> calibration_charts(const std::vector<study::SummaryRow>& rows,
                                           double micro_young_modulus);

}  // namespace rift::studio
