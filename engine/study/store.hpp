#pragma once

#include "engine/results/lane_summary.hpp"
#include "engine/scene/preset.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rift::study {

// A study's folder on the disk: study.json, and a pair of files per scenario under runs/
// (docs/results-format.md). Several processes may write into one: every file appears whole, under a name
// that follows from what is in it.

inline constexpr const char* study_name = "study.json";

/// XXH3-64 of a text as 16 hex digits.
std::string hash_text(std::string_view text);

/// The content of study.json.
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
std::optional<results::LaneSummary> read_result(const std::filesystem::path& folder, const std::string& key,
                                                std::vector<std::string>& notes);

/// Stores a scenario's summary and series: each under a temporary name, flushed and renamed, the series
/// first.
/// @return the summary as read_result() will give it
results::LaneSummary write_result(const std::filesystem::path& folder, const std::string& key,
                                  const results::LaneSummary& scenario, const std::string& series_csv);

/// Keeps why a scenario cannot be made, so that no other call tries it; and reads that back.
void write_not_made(const std::filesystem::path& folder, const std::string& key,
                    const std::vector<scene::Issue>& issues);
std::optional<std::vector<scene::Issue>> read_not_made(const std::filesystem::path& folder,
                                                       const std::string& key);

/// A study as its folder holds it.
struct StoredStudy {
  scene::Preset preset;
  std::vector<std::optional<results::LaneSummary>>
      rows;                                  // in the order of preset.study; none: not computed yet
  std::vector<std::string> notes;            // which results are damaged
  std::vector<std::filesystem::path> files;  // of the results, there or not; beside each its series, a .csv
};

/// Reads the preset and the results of a study's folder, and computes nothing. Throws InputError where
/// study.json is damaged or holds no preset, as those of rift before 0.2, and WorldError where it cannot be
/// read.
StoredStudy read_study(const std::filesystem::path& folder);

/// A scenario's series, column by column; an empty field is NaN, and `phase` is kept as text.
struct SeriesTable {
  std::map<std::string, std::vector<double>> column;
  std::vector<std::string> phase;

  /// The column of a name; throws std::out_of_range where there is none.
  const std::vector<double>& at(const std::string& name) const { return column.at(name); }
  bool empty() const { return phase.empty(); }
};

/// Reads a series as results::series_csv() writes it; empty where there is no such file.
SeriesTable read_series(const std::filesystem::path& path);

}  // namespace rift::study
