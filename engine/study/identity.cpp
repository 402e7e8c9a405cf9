#include "engine/study/identity.hpp"

#include "engine/ensemble/instruction_set.hpp"
#include "engine/scene/axes.hpp"
#include "engine/scene/parameters.hpp"

#include <fmt/format.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

namespace rift {

namespace {

/// How a scene is shown says nothing of its numbers.
std::string text_without_film(Scene scene) {
  scene.film = default_scene().film;
  return preset_text(scene);
}

}  // namespace

std::string hash_text(std::string_view text) {
  return fmt::format("{:016x}", XXH3_64bits(text.data(), text.size()));
}

std::vector<Scene> scenes_of_study(const Preset& preset) {
  std::vector<Scene> scenes;
  for (const StudyRow& row : preset.study) {
    scenes.push_back(row.scene);
    scenes.back().output.frames = 0;
  }
  return scenes;
}

StudyRow study_row_of(const Scene& scene) {
  StudyRow row{scene, {}};
  for (const Axis& axis : axes()) row.axes.emplace_back(axis.name, axis_text(scene, axis));
  return row;
}

std::string result_key(const Scene& scene, const std::string& version) {
  return fmt::format("{}\nversion {}\ninstruction set {}\n", text_without_film(scene), version,
                     name_of(instruction_set()));
}

std::string study_hash(const Preset& preset) {
  std::string text = "version " RIFT_VERSION "\n";
  for (const Scene& scene : scenes_of_study(preset)) text += text_without_film(scene);
  return hash_text(text);
}

}  // namespace rift
