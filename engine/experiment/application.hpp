#pragma once

#include "engine/experiment/experiment.hpp"
#include "engine/experiment/kept_parts.hpp"

namespace rift::experiment {

/// Experiment::law of the points along a crack.
std::vector<std::array<double, 3>> law_of(const std::vector<CriticalPoint>& along);

/// Lets a crack run by itself in the same plate, with the law that was found as what the material withstands,
/// and compares it with the measured one. It begins as fast as the measured tip ran over its first window.
Application apply(const scene::Preset& preset, const Experiment& found, base::Cache& cache,
                  const Parts& parts, const ExperimentProgress& progress);

}  // namespace rift::experiment
