#pragma once

#include "engine/experiment/experiment.hpp"
#include "engine/simulation/record.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace rift::studio {

/// All that `rift experiment` reports.
struct ExperimentReport {
  std::string preset, command;
  scene::Scene scene;
  simulation::BuildInfo build;
  experiment::Experiment experiment;
  std::vector<history::HistoryPoint> rows;  // as measured
  std::string smoothing;
  fracture::CriticalRate truth;  // to lay over; none without rows
  std::string truth_name;
  double wall_s = 0;
};

/// Table, what stands behind the band, and what a crack did that was given what was found.
std::string experiment_text(const ExperimentReport& report, bool color);

nlohmann::ordered_json experiment_json(const ExperimentReport& report);

/// Writes table.csv, toughness_position.csv, toughness_velocity.csv, summary.json, charts/ and report.html.
/// Throws WorldError where a chart cannot be drawn; the rest is then written.
void write_experiment_report(const ExperimentReport& report, const std::filesystem::path& folder);

}  // namespace rift::studio
