#pragma once

#include "engine/scene/preset.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace rift::study {

/// A study as its folder holds it.
struct StoredStudy {
  scene::Preset preset;
  std::vector<nlohmann::ordered_json> rows;  // summaries in the order of preset.study; null: not computed yet
  std::vector<std::string> notes;            // which results are damaged
};

/// Reads the preset and the results of a study's folder, and computes nothing. Throws InputError where
/// study.json is damaged or holds no preset, as those of rift before 0.2, and WorldError where it cannot be
/// read.
StoredStudy read_study(const std::filesystem::path& folder);

}  // namespace rift::study
