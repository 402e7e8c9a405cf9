#pragma once

#include "engine/experiment/experiment.hpp"

#include <string>
#include <vector>

namespace rift::experiment {

/// Plates of equal crack length between which a quasi-static release rate is read.
inline constexpr int static_parts = 8;

/// Where G_IDc is read along the measured course: position, time and velocity of each point. None where the
/// course is no longer than the window over which a release rate is averaged.
std::vector<CriticalPoint> points_of(const scene::Scene& scene, const history::SmoothedHistory& course,
                                     double zone_length, double mean_radius);

/// The same as it is to be expected without a lattice.
std::vector<CriticalPoint> planned_points(const scene::Scene& scene);

/// A part of an experiment before anything is computed: scenes that march in one pass, and static solutions.
struct PlannedPart {
  std::string name;
  std::vector<scene::Scene> scenes = {};
  int solutions = 0;
};

/// What run_experiment() computes, part by part. The resampled histories stand as the measured one, and the
/// crack that runs by itself as one that runs as measured.
/// @param[in] preset  without issues, with crack.history
std::vector<PlannedPart> planned_parts(const scene::Preset& preset, const ExperimentOptions& options);

}  // namespace rift::experiment
