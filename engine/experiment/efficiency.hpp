#pragma once

#include "engine/experiment/experiment.hpp"
#include "engine/experiment/kept_parts.hpp"
#include "engine/scene/scene.hpp"

#include <cstdint>
#include <vector>

namespace rift::experiment {

/// Histories that might as well have been measured: the rows of the course with noise as large as their
/// uncertainties say, or as the rows scatter around the course (parametric bootstrap; Efron and Tibshirani
/// 1993, section 6.5). The first row, where the notch ends, stays. None where nothing is smoothed.
std::vector<std::vector<history::HistoryPoint>> resampled(const scene::Scene& scene,
                                                          const history::SmoothedHistory& course, int count,
                                                          std::uint64_t seed);

/// The strips in which a lattice's efficiency is found: one for each velocity of the table that lies in
/// [lowest, highest] c_R, and the next one on either side.
std::vector<scene::Scene> steady_cracks(const scene::Scene& scene, double pulled, double lowest,
                                        double highest);

/// The lattice's efficiency at the velocities of [lowest, highest] c_R: the release ratio of a crack that
/// runs steadily along the middle of the same strip, where all that is stored ahead arrives (Nilsson 1972).
/// Lanes of one pass over the preset's own lattice, pulled by `pulled` [m].
std::vector<EfficiencyPoint> efficiency_of(const scene::Preset& preset, double pulled, double lowest,
                                           double highest, base::Cache& cache, const Parts& parts,
                                           const ExperimentProgress& progress);

/// Straight between the points, constant beyond them; the scatter too.
EfficiencyPoint efficiency_at(const std::vector<EfficiencyPoint>& points, double over_cr);

}  // namespace rift::experiment
