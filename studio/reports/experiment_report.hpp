#pragma once

#include "engine/experiment/experiment.hpp"
#include "studio/charts/chart.hpp"
#include "studio/text/table.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace rift::studio {

/// All that `rift experiment` has to tell.
struct ExperimentReport {
  std::string preset, command;
  simulation::BuildInfo build;
  experiment::Experiment experiment;
  std::vector<history::HistoryPoint> rows;  // as measured
  std::string smoothing;
  fracture::CriticalRate truth;  // to lay over; none without rows
  std::string truth_name;
  double wall_s = 0;
};

/// A dozen of the points.
Table experiment_table(const ExperimentReport& report);

/// Table, what stands behind the band, and what a crack did that was given what was found.
std::string experiment_text(const ExperimentReport& report, bool color);

nlohmann::ordered_json experiment_json(const ExperimentReport& report);

/// Rows and course, velocity, G_IDc against position, time and velocity, the efficiency, and the crack that
/// ran by itself.
std::vector<NamedChart> experiment_charts(const ExperimentReport& report);

/// Writes table.csv, toughness_position.csv, toughness_velocity.csv, summary.json, charts/ and report.html.
/// Throws WorldError where a chart cannot be drawn; the rest is then written.
void write_experiment_report(const ExperimentReport& report, const std::filesystem::path& folder);

/// How far what was found is from the critical rate laid over it.
struct Distance {
  double mean = 0, largest = 0;  // of |found / truth - 1|
  double within = 0;  // share of the points whose band of two standard uncertainties holds the truth
};
Distance distance_from_truth(const ExperimentReport& report, bool corrected);

}  // namespace rift::studio
