#pragma once

#include "engine/calibration/calibration_study.hpp"
#include "engine/simulation/build_info.hpp"

#include <filesystem>
#include <optional>

namespace rift::studio {

/// What `rift calibrate` tells.
struct Calibration {
  scene::Scene scene;
  simulation::BuildInfo build;
  calibration::Calibrated beams;
  std::optional<calibration::CalibrationStudy> study;  // with a report only
};

/// The [material] table of a preset that has these beams.
std::string material_block(const Calibration& calibration);

std::string calibration_text(const Calibration& calibration, bool color);

nlohmann::ordered_json calibration_json(const Calibration& calibration);

/// report.html, table.csv, summary.json, material.toml and charts/. Throws WorldError.
void write_calibration_report(const Calibration& calibration, const std::filesystem::path& folder);

}  // namespace rift::studio
