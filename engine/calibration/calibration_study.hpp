#pragma once

#include "engine/calibration/boxes.hpp"
#include "engine/calibration/calibrate.hpp"

#include <nlohmann/json.hpp>

namespace rift::calibration {

/// What Fig. 17 of the paper shows, and the periodic boxes beside it.
struct CalibrationStudy {
  std::vector<std::vector<CylinderResult>> by_size;  // with the paper's beams; packings of each size
  std::vector<CylinderResult> scan;                  // with the scanned beams
  std::vector<CylinderResult> twisted;               // with the paper's r_mu and other nu_mu
  std::vector<BoxResult> boxes;  // at the coordination asked for, then at the scanned cylinders' core's
};

/// Told the stage and the fraction of it done.
using StudyStage = std::function<bool(const char* stage, double done)>;

/// Convergence over the sizes of the scene's [calibration], the scan of r_mu, and homogenised boxes of as
/// many packings. E_mu is not scanned: every modulus is proportional to it.
CalibrationStudy study_calibration(const scene::Scene& scene, base::Cache& cache, const StudyStage& progress,
                                   int threads);

/// Every result as a row, as tables and verdicts take it: "series" (size, scan, twisted or box), "elements",
/// "seed", "coordination", "core_coordination", "solid_fraction", "micro_radius_ratio",
/// "micro_poisson_ratio", "young_over_micro", "young_ends_over_micro", "poisson_ratio", "anisotropy"; null
/// what a row does not have.
std::vector<nlohmann::ordered_json> rows_of(const CalibrationStudy& study);

}  // namespace rift::calibration
