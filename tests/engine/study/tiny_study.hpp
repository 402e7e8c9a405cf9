#pragma once

#include "engine/study/runner.hpp"
#include "tests/shared_cache.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace rift::study {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

inline const simulation::BuildInfo build{"0.1.0", "a compiler"};

/// 18 scenarios: two techniques, two zones, two velocities, damped and not; of several steps.
inline const std::string study_text = R"(
[specimen]
length = "36 mm"
height = "12 mm"
layers = 2
elements = 500
coordination = 5.6
[loading]
displacement = "0.6 mm"
[crack]
end = "16 mm"
[output]
samples = 30
window = [0.2, 0.4]
[damping]
region = "surface"
[study]
technique = ["simple", "progressive"]
damage_zone_ratio = [0.4, 4]
crack_velocity = ["0.3 c_r", "0.9 c_r"]
damping_alpha = [0, 0.01, 0.02]
)";

inline scene::Preset preset_from(const std::string& text) {
  scene::Preset preset = scene::read_preset_text(text, "tiny.toml", {});
  for (const scene::Issue& issue : preset.issues) ADD_FAILURE() << scene::to_text(issue);
  return preset;
}

/// The same without damping.
inline std::string undamped_text() {
  std::string text = study_text;
  text.erase(text.find("[damping]"), text.find("[study]") - text.find("[damping]"));
  text.erase(text.find("damping_alpha"));
  return text;
}

inline scene::Preset tiny_study() { return preset_from(study_text); }

inline StudyOptions into(const fs::path& folder) {
  StudyOptions options;
  options.folder = folder;
  options.threads = 1;
  return options;
}

inline StudyResult compute(const StudyOptions& options, const StudyObserver& observer = {}) {
  return run_study(tiny_study(), options, shared_cache(), build, observer);
}

/// A row without what depends on when and beside what it was computed.
inline Json lasting(Json row) {
  for (const char* name : {"lanes", "threads", "element_steps_per_s", "beam_steps_per_s", "memory_peak_bytes",
                           "packing_from_cache", "prestress_from_cache", "axes", "row", "series"})
    row.erase(name);
  Json kept = Json::object();
  for (const auto& [name, value] : row.items())
    if (!name.starts_with("wall_") && name != "cost_s") kept[name] = value;
  return kept;
}

inline std::vector<Json> lasting(const StudyRows& rows) {
  std::vector<Json> all;
  for (const auto& row : rows) all.push_back(row ? lasting(to_json(*row)) : Json(nullptr));
  return all;
}

}  // namespace rift::study
