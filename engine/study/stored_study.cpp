#include "engine/study/stored_study.hpp"

#include "engine/base/files.hpp"
#include "engine/results/json_input.hpp"
#include "engine/scene/issue.hpp"
#include "engine/study/store.hpp"

#include <utility>

namespace rift::study {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

[[noreturn]] void refuse_study(const fs::path& file, std::string why) {
  throw scene::InputError({scene::Issue{.file = file.string(), .key = {}, .text = std::move(why)}});
}

std::string member_text(const Json& object, const char* name) {
  const auto found = object.is_object() ? object.find(name) : object.end();
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// The result in a file of runs/, or null where there is none yet or none that is whole.
Json stored_result(const fs::path& folder, const std::string& file, std::vector<std::string>& notes) {
  if (file.empty() || !fs::exists(folder / file)) return nullptr;
  const Json stored = results::json_or_discarded(base::read_whole_file(folder / file));
  const std::string key = member_text(stored, "key");
  if (key.empty() || result_file(folder, key) != folder / file) {
    notes.push_back((folder / file).string() + ": damaged");
    return nullptr;
  }
  return read_result(folder, key, notes).value_or(nullptr);
}

}  // namespace

StoredStudy read_study(const fs::path& folder) {
  const fs::path file = folder / study_name;
  const Json manifest = results::json_or_discarded(base::read_whole_file(file));
  if (!manifest.is_object() || !manifest.contains("scenarios") || !manifest["scenarios"].is_array())
    refuse_study(file, "is damaged: 'rift study' with the same preset writes it anew");
  const std::string text = member_text(manifest, "preset_text");
  if (text.empty())
    refuse_study(file, "holds no preset, as before rift 0.2: 'rift study' with its preset goes on with it");
  StoredStudy study;
  study.preset = scene::read_preset_text(text, member_text(manifest, "preset"));
  if (!study.preset.issues.empty()) throw scene::InputError(study.preset.issues);
  if (study.preset.study.empty() || study.preset.study.size() != manifest["scenarios"].size())
    refuse_study(file, "is damaged: its preset and its list of scenarios do not fit each other");
  for (const Json& scenario : manifest["scenarios"])
    study.rows.push_back(stored_result(folder, member_text(scenario, "file"), study.notes));
  return study;
}

}  // namespace rift::study
