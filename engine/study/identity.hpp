#pragma once

#include "engine/scene/preset.hpp"
#include "engine/scene/scene.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rift::study {

// A scenario of a study is the same one again by its effective preset and the program that computes it.

/// XXH3-64 of a text as 16 hex digits.
std::string hash_text(std::string_view text);

/// The scenarios' scenes in the order of preset.study. They write no frames: a study keeps numbers.
std::vector<scene::Scene> scenes_of_study(const scene::Preset& preset);

/// A scene as a row of a study that names all axes.
scene::StudyRow study_row_of(const scene::Scene& scene);

/// All that the bits of a scenario's result depend on: effective preset, version and instruction set.
std::string result_key(const scene::Scene& scene, const std::string& version);

/// Hash of the scenarios, in their order, and of this program's version, by which study.json is known.
std::string study_hash(const scene::Preset& preset);

}  // namespace rift::study
