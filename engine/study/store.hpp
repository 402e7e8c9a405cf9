#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// A study's folder on the disk: study.json, and a pair of files per scenario under runs/
/// (docs/results-format.md). Several processes may write into one: every file appears whole, under a name
/// that follows from what is in it.
namespace rift::study {

inline constexpr const char* study_name = "study.json";

/// What study.json says of a study.
struct StudyManifest {
  std::string hash, version, instruction_set, preset;
  std::string
      preset_text;  // the effective preset with its study, so that the folder alone can be gone on with
  std::vector<std::string> axes;
  nlohmann::ordered_json rows;  // [{"axes": {name: text}, "file": "runs/<hash>.json"}]
};

/// Makes the folder with its study.json, or continues one that holds the same study. A damaged study.json is
/// written anew, with a note: what counts is known by its content. Throws FolderExists where the folder holds
/// another study, the same of another program, or anything else; WorldError where it cannot be made.
void open_study(const std::filesystem::path& folder, const StudyManifest& manifest,
                std::vector<std::string>& notes);

/// Makes the folder for results of any study; they are known by what they are of.
void open_shared(const std::filesystem::path& folder);

/// The file of a scenario's result, beside it the same name with ".csv".
std::filesystem::path result_file(const std::filesystem::path& folder, const std::string& key);

/// The result stored under a key, or nothing; one that is damaged counts as absent, with a note.
std::optional<nlohmann::ordered_json> read_result(const std::filesystem::path& folder, const std::string& key,
                                                  std::vector<std::string>& notes);

/// Stores a scenario's summary and series: each under a temporary name, flushed and renamed, the series
/// first.
/// @return the summary as read_result() will give it
nlohmann::ordered_json write_result(const std::filesystem::path& folder, const std::string& key,
                                    const nlohmann::ordered_json& scenario, const std::string& series_csv);

}  // namespace rift::study
