#pragma once

#include "engine/results/lane_summary.hpp"
#include "studio/text/table.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace rift::studio {

// Scenarios of runs and studies side by side, on a screen, as a table, as rows of a file.

/// A number of the summary that a comparison shows.
struct ComparedQuantity {
  const char* name;
  double results::LaneSummary::*number;
  const char* format;
};

/// THE list of them.
std::span<const ComparedQuantity> compared_quantities();

/// A scenario that has been computed, and where its series lies.
struct ComparedScenario {
  std::string title;
  std::filesystem::path folder;  // of the run or the study
  int lane = 0;                  // of the run, or row of the study
  results::LaneSummary summary;
  std::filesystem::path series;  // whose rows of `series_lane` are this scenario's
  int series_lane = 0;
};

/// The scenarios of these folders in their order: each lane of a run, or of the run of an experiment, each
/// scenario of a study that is computed. Throws WorldError where a folder holds neither, or a run that has not ended.
std::vector<ComparedScenario> compared_scenarios(const std::vector<std::filesystem::path>& folders);

/// Quantities down, scenarios across by their number in the list, in blocks that are at most `width` wide.
std::string comparison_text(const std::vector<ComparedScenario>& scenarios, std::size_t width, bool color);

/// A row for each scenario: its number, folder and title, then all of its summary.
std::vector<nlohmann::ordered_json> comparison_rows(const std::vector<ComparedScenario>& scenarios);

}  // namespace rift::studio
