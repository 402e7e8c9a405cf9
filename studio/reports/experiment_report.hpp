#pragma once

#include "engine/experiment/experiment.hpp"
#include "engine/simulation/record.hpp"
#include "studio/text/table.hpp"

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

/// One sentence with the number to publish: G_IDc over the whole crack, corrected for the lattice efficiency,
/// with its band, what that is, and the uncorrected one.
std::string publish_text(const ExperimentReport& report);

/// The results, a label and a text a row.
Table conclusions(const ExperimentReport& report);

/// A dozen of the points; the note says what its columns are.
Table experiment_table(const ExperimentReport& report);
inline constexpr const char* experiment_table_note =
    "Release rates in kJ/m²; corrected: divided by the lattice efficiency η; uncorrected: what the damage "
    "zone "
    "dissipates, as in the paper; quasi-static: of an infinitely slow crack in the same lattice.";

/// Table, what stands behind the band, and what a crack did that was given what was found.
std::string experiment_text(const ExperimentReport& report, bool color);

nlohmann::ordered_json experiment_json(const ExperimentReport& report);

/// Writes table.csv, toughness_position.csv, toughness_velocity.csv, summary.json, charts/ and report.html.
/// Throws WorldError where a chart cannot be drawn; the rest is then written.
void write_experiment_report(const ExperimentReport& report, const std::filesystem::path& folder);

}  // namespace rift::studio
