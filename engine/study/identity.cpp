#include "engine/study/identity.hpp"

#include "engine/ensemble/instruction_set.hpp"
#include "engine/scene/parameters.hpp"
#include "engine/scene/scenarios.hpp"

#include <fmt/format.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace rift::study {
namespace {

/// The scene as text without how it is shown, which changes none of its numbers.
std::string text_without_film(scene::Scene scene) {
  scene.film = scene::default_scene().film;
  return scene::preset_text(scene);
}

}  // namespace

std::string hash_text(std::string_view text) {
  return fmt::format("{:016x}", XXH3_64bits(text.data(), text.size()));
}

std::vector<scene::Scene> scenes_of_study(const scene::Preset& preset) {
  std::vector<scene::Scene> scenes;
  for (const scene::StudyRow& row : preset.study) {
    scenes.push_back(row.scene);
    scenes.back().output.frames = 0;
  }
  return scenes;
}

scene::StudyRow study_row_of(const scene::Scene& scene) {
  scene::StudyRow row{scene, {}};
  for (const scene::Axis& axis : scene::axes())
    row.axes.emplace_back(axis.name, scene::axis_text(scene, axis));
  return row;
}

std::string result_key(const scene::Scene& scene, const std::string& version) {
  return fmt::format("{}\nversion {}\ninstruction set {}\n", text_without_film(scene), version,
                     ensemble::name_of(ensemble::instruction_set()));
}

std::string study_hash(const scene::Preset& preset) {
  std::string text = "version " RIFT_VERSION "\n";
  for (const scene::Scene& scene : scenes_of_study(preset)) text += text_without_film(scene);
  return hash_text(text);
}

}  // namespace rift::study
