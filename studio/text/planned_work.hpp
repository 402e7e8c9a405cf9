#pragma once

#include "engine/scene/preset.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <utility>
#include <vector>

namespace rift::studio {

/// A part of the work that is reported separately: a claim, a stage of an experiment or of a calibration.
struct PlannedPart {
  std::string name;
  int count = 0;             // of scenarios or specimens
  double seconds = 0;        // that it takes from nothing
  std::string counted = {};  // what `count` counts, where that is not the same as of the whole
};

/// What a command would do, known before it does it and without a lattice.
struct PlannedWork {
  std::string command;                // "rift study study_release"
  std::string counted = "scenarios";  // what `count` counts
  int count = 0, missing = 0;         // in all; still to be computed
  int specimens = 0;                  // packings
  std::vector<PlannedPart> parts = {};
  std::vector<scene::Scene> scenes = {};  // that march
  double steps_factor = 1;                // steps over those that are expected without a lattice
  double seconds = 0;                     // that what is missing takes, roughly
  double disk_bytes = 0, memory_bytes = 0;
  std::string to_start = {};  // what the command asks for before it begins: "--yes or --budget TIME"
};

/// The scenarios of a grid that several of its combinations come to, as JSON: those groups of axes that do
/// not count, why, and what the scenarios are.
nlohmann::ordered_json merged_combinations(const scene::Preset& preset);

/// @param[in] preset  whose grid it is, where it has one
nlohmann::ordered_json planned_json(const PlannedWork& work, const scene::Preset& preset);

/// The same as lines of a label (which may be empty) and a text.
std::vector<std::pair<std::string, std::string>> planned_rows(const nlohmann::ordered_json& numbers);

}  // namespace rift::studio
