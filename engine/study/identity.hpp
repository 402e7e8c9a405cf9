#pragma once

#include "engine/scene/preset.hpp"
#include "engine/scene/scene.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rift::study {

// What makes a scenario of a study the same one again: its effective preset and the program.

/// XXH3-64 of a text as 16 hex digits.
std::string hash_text(std::string_view text);

/// The scenarios' scenes in the order of preset.study. They write no frames: a study keeps numbers.
std::vector<scene::Scene> scenes_of_study(const scene::Preset& preset);

/// A scene as a row of a study that names all axes.
scene::StudyRow study_row_of(const scene::Scene& scene);

/// All that the bits of a scenario's result depend on: effective preset, version and instruction set.
std::string result_key(const scene::Scene& scene, const std::string& version);

/// Of the scenarios, in their order, and of this program's version; what study.json is known by.
std::string study_hash(const scene::Preset& preset);

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
