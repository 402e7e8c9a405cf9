#include "engine/study/store.hpp"

#include "engine/base/files.hpp"
#include "engine/base/json_text.hpp"
#include "engine/base/world_error.hpp"
#include "engine/results/json_input.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/study/identity.hpp"

#include <fmt/format.h>

#include <system_error>

namespace rift::study {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Whether there is anything but what another process is about to write.
bool holds_files(const fs::path& folder) {
  std::error_code error;
  for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error))
    if (entry->path().extension() != ".part") return true;
  if (error) throw base::WorldError("read the folder", folder, error.message());
  return false;
}

std::string text_of(const Json& j, const char* key) {
  return j.contains(key) && j.at(key).is_string() ? j.at(key).get<std::string>() : std::string();
}

/// Why the study in the folder cannot be gone on with; empty where it can.
std::string difference(const Json& there, const StudyManifest& ours) {
  if (text_of(there, "version") != ours.version)
    return fmt::format("a study of rift {}, this is rift {}", text_of(there, "version"), ours.version);
  if (text_of(there, "instruction_set") != ours.instruction_set)
    return fmt::format("a study computed with {0}, this is {1}: RIFT_SIMD={0} goes on with it",
                       text_of(there, "instruction_set"), ours.instruction_set);
  if (text_of(there, "hash") != ours.hash)
    return fmt::format("another study (of {}, {} scenarios)", text_of(there, "preset"),
                       there.contains("scenarios") ? there.at("scenarios").size() : 0);
  return {};
}

Json to_json(const StudyManifest& manifest) {
  return {{"hash", manifest.hash},
          {"version", manifest.version},
          {"instruction_set", manifest.instruction_set},
          {"preset", manifest.preset},
          {"axes", manifest.axes},
          {"scenarios", manifest.rows},
          {"preset_text", manifest.preset_text}};
}

std::string check_of(const std::string& key, const Json& scenario, const std::string& series_hash) {
  return hash_text(key + base::json_text(scenario) + series_hash);
}

fs::path series_file(fs::path result) { return result.replace_extension(".csv"); }

}  // namespace

void open_study(const fs::path& folder, const StudyManifest& manifest, std::vector<std::string>& notes) {
  base::make_folder(folder);
  const fs::path file = folder / study_name;
  const bool anything = holds_files(folder);
  if (fs::exists(file)) {
    const Json there = results::json_or_discarded(base::read_whole_file(file));
    const bool sound = there.is_object() && !text_of(there, "hash").empty();
    if (sound) {
      if (const std::string why = difference(there, manifest); !why.empty())
        throw results::FolderExists(
            fmt::format("{} holds {}; nothing was changed, choose another with --out", folder.string(), why));
      return base::make_folder(folder / "runs");
    }
    notes.push_back(fmt::format("{}: damaged, written anew", file.string()));
  } else if (anything) {
    throw results::FolderExists(
        fmt::format("{} is not empty and holds no study; choose another with --out", folder.string()));
  }
  base::write_whole_file(file, base::json_text(to_json(manifest), 2) + "\n");
  base::make_folder(folder / "runs");
}

void open_shared(const fs::path& folder) {
  base::make_folder(folder);
  base::make_folder(folder / "runs");
}

fs::path result_file(const fs::path& folder, const std::string& key) {
  return folder / "runs" / (hash_text(key) + ".json");
}

std::optional<Json> read_result(const fs::path& folder, const std::string& key,
                                std::vector<std::string>& notes) {
  const fs::path file = result_file(folder, key);
  if (!fs::exists(file)) return std::nullopt;
  const Json j = results::json_or_discarded(base::read_whole_file(file));
  const bool whole = j.is_object() && text_of(j, "key") == key && j.contains("scenario") &&
                     j.at("scenario").is_object() &&
                     text_of(j, "check") == check_of(key, j.at("scenario"), text_of(j, "series_hash"));
  const fs::path series = series_file(file);
  if (whole && fs::exists(series) && hash_text(base::read_whole_file(series)) == text_of(j, "series_hash"))
    return j.at("scenario");
  notes.push_back(fmt::format("{}: damaged, computed again", (whole ? series : file).string()));
  return std::nullopt;
}

Json write_result(const fs::path& folder, const std::string& key, const Json& scenario,
                  const std::string& series_csv) {
  const fs::path file = result_file(folder, key);
  base::write_whole_file(series_file(file), series_csv);
  Json kept = results::read_json(base::json_text(scenario), file);  // what is undefined is null from here on
  const std::string series_hash = hash_text(series_csv);
  const Json j{{"key", key},
               {"scenario", kept},
               {"series_hash", series_hash},
               {"check", check_of(key, kept, series_hash)}};
  base::write_whole_file(file, base::json_text(j, 2) + "\n");
  return kept;
}

}  // namespace rift::study
