#pragma once

#include "engine/scene/scene.hpp"

#include <cstdint>
#include <vector>

namespace rift::experiment {

/// Histories that might as well have been measured: the rows of the course with noise as large as their
/// uncertainties say, or as the rows scatter around the course (parametric bootstrap; Efron and Tibshirani
/// 1993, section 6.5). The first row, where the notch ends, stays. None where nothing is smoothed.
std::vector<std::vector<history::HistoryPoint>> resampled(const scene::Scene& scene,
                                                          const history::Course& course, int count,
                                                          std::uint64_t seed);

}  // namespace rift::experiment
