#pragma once

#include "engine/study/accuracy_judgement.hpp"
#include "studio/report/study_charts.hpp"

#include <vector>

namespace rift::studio {

/// Charts of an accuracy study, those that have something to show:
///   work_precision    error over wall time, a series a knob (on the scene's own specimen; elements against
///   the
///                     finest), the goal, the scatter of specimens, what is recommended
///   error_step        error of the step over the step, double and single, with the observed order
///   ratio_elements    ratio over elements, mean and scatter of the specimens, beside Broberg's
/// Logarithmic axes have no place for an error of 0: such points are left out, which the caption says.
std::vector<NamedChart> accuracy_charts(const std::vector<study::Tried>& tried,
                                        const study::Accuracy& accuracy, double goal);

}  // namespace rift::studio
