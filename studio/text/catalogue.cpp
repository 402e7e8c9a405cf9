#include "studio/text/catalogue.hpp"

#include "engine/base/files.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/json_input.hpp"
#include "engine/results/lane_summary.hpp"
#include "engine/scene/derived.hpp"
#include "engine/study/resources.hpp"
#include "engine/study/store.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace rift::studio {

namespace fs = std::filesystem;
namespace {

// A preset opens with two comment lines: "# <what it shows>" and "# Cost: <text>".
PresetEntry read_entry(const fs::path& path) {
  PresetEntry entry{.name = path.stem().string(), .path = path, .shows = {}, .cost = {}};
  std::ifstream file(path);
  if (!file) throw std::runtime_error(fmt::format("cannot read the preset {}", path.string()));
  constexpr std::string_view mark = "Cost: ";
  for (std::string line; std::getline(file, line) && line.starts_with('#');) {
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
    line.erase(0, std::min(line.find_first_not_of("# "), line.size()));
    if (line.starts_with(mark)) {
      entry.cost = line.substr(mark.size());
    } else if (entry.shows.empty()) {
      entry.shows = line;
    }
  }
  return entry;
}

using Json = nlohmann::ordered_json;

/// Reads what the summary of a run that has ended says.
void read_outcome(RunEntry& entry, const Json& summary) {
  const auto lanes = results::lane_summaries_of(summary.at("scenarios"));
  entry.outcome = "finished";
  for (const results::LaneSummary& lane : lanes)
    if (lane.outcome != "finished") entry.outcome = lane.outcome;
  if (lanes.size() != 1)
    entry.result = fmt::format("{} lanes", lanes.size());
  else if (!std::isnan(lanes[0].ratio))
    entry.result = fmt::format("{:.3f}", lanes[0].ratio);
}

/// "12 of 30" scenarios, by their files alone.
std::string computed_of_study(const fs::path& folder) {
  try {
    const Json manifest =
        results::read_json(base::read_whole_file(folder / study::study_name), folder / study::study_name);
    const Json& scenarios = manifest.at("scenarios");
    const auto there = std::count_if(scenarios.begin(), scenarios.end(), [&](const Json& scenario) {
      return fs::exists(folder / scenario.at("file").get<std::string>());
    });
    return fmt::format("{} of {}", there, scenarios.size());
  } catch (const std::exception&) {
    return "";
  }
}

std::optional<RunEntry> entry_of(const fs::path& folder) {
  std::error_code error;
  RunEntry entry{folder.filename().string(), folder, "unfinished", "", fs::last_write_time(folder, error)};
  if (error) return std::nullopt;
  if (fs::exists(folder / study::study_name, error)) {
    entry.outcome = "study";
    entry.result = computed_of_study(folder);
    return entry;
  }
  if (!fs::exists(folder / results::journal_name, error)) return std::nullopt;
  if (!fs::exists(folder / results::summary_name, error)) return entry;
  try {
    read_outcome(entry, results::json_or_discarded(base::read_whole_file(folder / results::summary_name)));
  } catch (const std::exception&) {
    entry.outcome = "damaged";
  }
  return entry;
}

}  // namespace

std::vector<PresetEntry> preset_entries(const fs::path& folder) {
  std::error_code error;
  std::vector<PresetEntry> entries;
  for (const auto& file : fs::directory_iterator(folder, error))
    if (file.path().extension() == ".toml") entries.push_back(read_entry(file.path()));
  if (error)
    throw std::runtime_error(
        fmt::format("cannot list the presets in {}: {}", folder.string(), error.message()));
  std::ranges::sort(entries, {}, &PresetEntry::name);
  return entries;
}

std::string command_for(const scene::Preset& preset) {
  if (!preset.issues.empty()) return "";
  if (!preset.study.empty()) return "study";
  if (preset.scene.specimen.shape == packing::Shape::cylinder) return "calibrate";
  if (!scene::can_crack(preset.scene)) return "pack";
  const bool measured = !preset.scene.crack.history.empty() && preset.scene.crack.tips == 1;
  return measured && preset.lanes.empty() ? "experiment" : "run";
}

double expected_disk_bytes(const scene::Preset& preset) {
  const std::string command = command_for(preset);
  double bytes = 0.0;
  for (const scene::StudyRow& row : preset.study) bytes += study::disk_bytes_of_scenario(row.scene);
  if (command == "study") return bytes;
  if (command != "run" && command != "experiment") return std::numeric_limits<double>::quiet_NaN();
  return study::expected_disk_bytes(preset.lanes.empty() ? std::span(&preset.scene, 1)
                                                         : std::span(preset.lanes));
}

std::vector<RunEntry> run_entries(const fs::path& folder) {
  std::vector<RunEntry> entries;
  std::error_code none;
  for (const auto& file : fs::directory_iterator(folder, none))
    if (file.is_directory(none))
      if (auto entry = entry_of(file.path())) entries.push_back(std::move(*entry));
  std::ranges::sort(entries, [](const RunEntry& a, const RunEntry& b) { return a.when > b.when; });
  return entries;
}

}  // namespace rift::studio
