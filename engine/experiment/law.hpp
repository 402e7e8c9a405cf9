#pragma once

#include "engine/experiment/experiment.hpp"

namespace rift::experiment {

/// Experiment::law of the points along a crack.
std::vector<std::array<double, 3>> law_of(const std::vector<CriticalPoint>& along);

}  // namespace rift::experiment
