#pragma once

#include "engine/calibration/calibrate.hpp"
#include "engine/simulation/record.hpp"
#include "engine/study/runner.hpp"
#include "studio/charts/chart.hpp"

#include <filesystem>
#include <optional>

namespace rift::studio {

/// What `rift calibrate` reports.
struct Calibration {
  std::string command;
  scene::Scene scene;
  simulation::BuildInfo build;
  calibration::Calibrated beams;
  std::optional<calibration::CalibrationStudy> study;  // with a report only
  double wall_s = 0;
};

/// The [material] table of a preset that has these beams.
std::string material_block(const Calibration& calibration);

std::string calibration_text(const Calibration& calibration, bool color);

nlohmann::ordered_json calibration_json(const Calibration& calibration);

/// report.html, table.csv, summary.json, material.toml and charts/. Throws WorldError.
void write_calibration_report(const Calibration& calibration, const std::filesystem::path& folder);

/// The charts of a calibration from its rows (engine/calibration/calibrate.hpp): E and nu against the
/// number of elements and against the coordination of the core, with beams of this modulus; E_M / E_mu and nu
/// against r_mu. Means over the packings with their standard deviation.
/// @param[in] micro_young_modulus  [Pa]
std::vector<NamedChart> calibration_charts(const std::vector<nlohmann::ordered_json>& rows,
                                           double micro_young_modulus);

}  // namespace rift::studio
