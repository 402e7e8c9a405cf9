#include "engine/study/store.hpp"

#include "engine/base/files.hpp"
#include "engine/base/text.hpp"
#include "engine/base/world_error.hpp"
#include "engine/results/json_input.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/scene/issue.hpp"
#include "engine/scene/text_differences.hpp"

#include <fmt/format.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <limits>
#include <string_view>
#include <system_error>
#include <utility>

namespace rift::study {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// True where the folder holds anything but what another process is about to write.
bool holds_files(const fs::path& folder) {
  std::error_code error;
  for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error))
    if (entry->path().extension() != ".part") return true;
  if (error) throw base::WorldError("read the folder", folder, error.message());
  return false;
}

/// A text of an object; empty where it is none.
std::string text_of(const Json& object, const char* name) {
  const auto found = object.is_object() ? object.find(name) : object.end();
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// Why the study in the folder cannot be gone on with; empty where it can.
std::string difference(const Json& there, const StudyManifest& ours) {
  if (text_of(there, "version") != ours.version)
    return fmt::format("a study of rift {}, this is rift {}", text_of(there, "version"), ours.version);
  if (text_of(there, "instruction_set") != ours.instruction_set)
    return fmt::format("a study computed with {0}, this is {1}: RIFT_SIMD={0} continues it",
                       text_of(there, "instruction_set"), ours.instruction_set);
  if (text_of(there, "hash") != ours.hash)
    return fmt::format("another study (of {}, {} scenarios){}", text_of(there, "preset"),
                       there.contains("scenarios") ? there.at("scenarios").size() : 0,
                       scene::differences_text(text_of(there, "preset_text"), ours.preset_text));
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

std::string hash_text(std::string_view text) {
  return fmt::format("{:016x}", XXH3_64bits(text.data(), text.size()));
}

void open_study(const fs::path& folder, const StudyManifest& manifest, std::vector<std::string>& notes) {
  base::make_folder(folder);
  const fs::path file = folder / study_name;
  const bool anything = holds_files(folder);
  if (fs::exists(file)) {
    const Json there = results::json_or_discarded(base::read_whole_file(file));
    const bool sound = there.is_object() && !text_of(there, "hash").empty();
    if (sound) {
      if (const std::string why = difference(there, manifest); !why.empty())
        throw results::FolderExists(fmt::format(
            "{} holds {}; nothing was changed: choose another folder with --out", folder.string(), why));
      return base::make_folder(folder / "runs");
    }
    notes.push_back(fmt::format("{} was damaged and has been rewritten", file.string()));
  } else if (anything) {
    throw results::FolderExists(
        fmt::format("{} is not empty and holds no study: choose another folder with --out", folder.string()));
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

std::optional<results::LaneSummary> read_result(const fs::path& folder, const std::string& key,
                                                std::vector<std::string>& notes) {
  const fs::path file = result_file(folder, key);
  if (!fs::exists(file)) return std::nullopt;
  const Json j = results::json_or_discarded(base::read_whole_file(file));
  const bool whole = j.is_object() && text_of(j, "key") == key && j.contains("scenario") &&
                     j.at("scenario").is_object() &&
                     text_of(j, "check") == check_of(key, j.at("scenario"), text_of(j, "series_hash"));
  const fs::path series = series_file(file);
  if (whole && fs::exists(series) && hash_text(base::read_whole_file(series)) == text_of(j, "series_hash"))
    return results::lane_summary_of(j.at("scenario"));
  notes.push_back(fmt::format("{} is damaged and is computed again", (whole ? series : file).string()));
  return std::nullopt;
}

results::LaneSummary write_result(const fs::path& folder, const std::string& key,
                                  const results::LaneSummary& scenario, const std::string& series_csv) {
  const fs::path file = result_file(folder, key);
  base::write_whole_file(series_file(file), series_csv);
  const Json kept = results::to_json(scenario);
  const std::string series_hash = hash_text(series_csv);
  const Json j{{"key", key},
               {"scenario", kept},
               {"series_hash", series_hash},
               {"check", check_of(key, kept, series_hash)}};
  base::write_whole_file(file, base::json_text(j, 2) + "\n");
  return results::lane_summary_of(kept);
}

namespace {

constexpr const char* not_made_folder = "not_made";

fs::path not_made_file(const fs::path& folder, const std::string& key) {
  return folder / not_made_folder / (hash_text(key) + ".json");
}

}  // namespace

void write_not_made(const fs::path& folder, const std::string& key, const std::vector<scene::Issue>& issues) {
  Json why = Json::array();
  for (const scene::Issue& issue : issues)
    why.push_back({{"file", issue.file},
                   {"line", issue.line},
                   {"key", issue.key},
                   {"text", issue.text},
                   {"value", issue.value},
                   {"column", issue.column}});
  base::make_folder(folder / not_made_folder);
  base::write_whole_file(not_made_file(folder, key),
                         base::json_text(Json{{"key", key}, {"why", why}}, 2) + "\n");
}

std::optional<std::vector<scene::Issue>> read_not_made(const fs::path& folder, const std::string& key) {
  const fs::path file = not_made_file(folder, key);
  if (!fs::exists(file)) return std::nullopt;
  const Json kept = results::json_or_discarded(base::read_whole_file(file));
  if (text_of(kept, "key") != key || !kept.contains("why") || !kept["why"].is_array()) return std::nullopt;
  std::vector<scene::Issue> issues;
  for (const Json& one : kept["why"]) {
    if (!one.is_object()) return std::nullopt;
    const auto number = [&](const char* name) {
      return one.contains(name) && one[name].is_number_integer() ? one[name].get<int>() : 0;
    };
    issues.push_back({.file = text_of(one, "file"),
                      .line = number("line"),
                      .key = text_of(one, "key"),
                      .text = text_of(one, "text"),
                      .value = text_of(one, "value"),
                      .column = number("column")});
  }
  return issues;
}

namespace {

[[noreturn]] void refuse_study(const fs::path& file, std::string why) {
  throw scene::InputError({scene::Issue{.file = file.string(), .key = {}, .text = std::move(why)}});
}

/// The result in a file of runs/, or nothing where there is none yet or none that is whole.
std::optional<results::LaneSummary> stored_result(const fs::path& folder, const std::string& file,
                                                  std::vector<std::string>& notes) {
  if (file.empty() || !fs::exists(folder / file)) return std::nullopt;
  const Json stored = results::json_or_discarded(base::read_whole_file(folder / file));
  const std::string key = text_of(stored, "key");
  if (key.empty() || result_file(folder, key) != folder / file) {
    notes.push_back((folder / file).string() + ": damaged");
    return std::nullopt;
  }
  return read_result(folder, key, notes);
}

}  // namespace

StoredStudy read_study(const fs::path& folder) {
  const fs::path file = folder / study_name;
  const Json manifest = results::json_or_discarded(base::read_whole_file(file));
  if (!manifest.is_object() || !manifest.contains("scenarios") || !manifest["scenarios"].is_array())
    refuse_study(file, "is damaged: 'rift study' with the same preset rewrites it");
  const std::string text = text_of(manifest, "preset_text");
  if (text.empty())
    refuse_study(file,
                 "holds no preset (written before rift 0.2): 'rift study' with its preset continues it");
  StoredStudy study;
  study.preset = scene::read_preset_text(text, text_of(manifest, "preset"));
  if (!study.preset.issues.empty()) throw scene::InputError(study.preset.issues);
  if (study.preset.study.empty() || study.preset.study.size() != manifest["scenarios"].size())
    refuse_study(file, "is damaged: its preset and its list of scenarios do not fit each other");
  for (const Json& scenario : manifest["scenarios"]) {
    study.rows.push_back(stored_result(folder, text_of(scenario, "file"), study.notes));
    study.files.push_back(folder / text_of(scenario, "file"));
  }
  return study;
}

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t from = 0; from <= line.size();) {
    const std::size_t to = std::min(line.find(',', from), line.size());
    fields.push_back(line.substr(from, to - from));
    from = to + 1;
  }
  return fields;
}

double number(std::string_view field) {
  double value = undefined;
  std::from_chars(field.data(), field.data() + field.size(), value);
  return value;
}

}  // namespace

SeriesTable read_series(const std::filesystem::path& path) {
  SeriesTable table;
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) return table;
  std::vector<std::string> names;
  for (std::string_view name : fields_of(line)) names.emplace_back(name);
  while (std::getline(file, line)) {
    const std::vector<std::string_view> fields = fields_of(line);
    if (fields.size() != names.size()) continue;
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (names[k] == "phase") {
        table.phase.emplace_back(fields[k]);
      } else {
        table.column[names[k]].push_back(number(fields[k]));
      }
    }
  }
  return table;
}

}  // namespace rift::study
