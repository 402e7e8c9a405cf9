#pragma once

#include "engine/measurement/traces.hpp"
#include "engine/scene/scene.hpp"
#include "engine/simulation/record.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace rift::studio {

/// All that `rift measure` reports.
struct InstrumentsReport {
  std::string run, command;
  simulation::BuildInfo build;       // of this program, not of the run's
  std::vector<scene::Scene> scenes;  // of the run's lane
  int lane = 0;
  measurement::Instruments seen;
  std::vector<measurement::SeenField> field;  // some, along the way
  std::vector<measurement::Trace> trace;      // of the run
  std::vector<measurement::Trace> measured;   // to compare with, by the run's clock
  double offset = 0;                          // added to their times [s]
};

/// Table, and what the instruments and the measured curves come to.
std::string instruments_text(const InstrumentsReport& report, bool color);

/// Why no moment has stress intensities, and what to change; empty where some have, or the plate can have
/// none.
std::string no_intensity_text(const measurement::Instruments& seen,
                              const measurement::InstrumentOptions& options);

nlohmann::ordered_json instruments_json(const InstrumentsReport& report);

/// Writes stress_intensity.csv, summary.json, charts/ and report.html. Throws WorldError where a chart cannot
/// be drawn; the rest is then written.
void write_instruments_report(const InstrumentsReport& report, const std::filesystem::path& folder);

/// field.csv: a row per moment and point of the grid that the camera holds.
std::string field_csv_header();
std::string field_csv_rows(const measurement::Grid& grid, const measurement::SeenField& field);

}  // namespace rift::studio
