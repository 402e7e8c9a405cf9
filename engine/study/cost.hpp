#pragma once

#include "engine/scene/scene.hpp"

#include <cstdint>

namespace rift::study {

/// Estimates that need no lattice, for bars and for asking before a long study.

/// Step and steps of a scenario, with a critical step of 0.63 R / c_r (measured on the quickstart plate).
struct Length {
  double step_s = 0;
  std::int64_t steps = 0;
};
Length estimated_length(const scene::Scene& scene);

/// What a step costs: the scene's beams, as many times as its damping and its kinematics make them dearer
/// [rift bench --needs]. The unit is a walk over one beam for as many lanes as march side by side.
double estimated_step_cost(const scene::Scene& scene);

/// The steps of a scenario that marches by itself.
double estimated_cost(const scene::Scene& scene);

/// The same for packing and pre-stress together.
double estimated_preparation(const scene::Scene& scene);

}  // namespace rift::study
