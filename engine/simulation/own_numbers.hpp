#pragma once

#include "engine/calibration/waves.hpp"
#include "engine/simulation/prepare.hpp"

#include <nlohmann/json.hpp>

namespace rift::simulation {

/// What a plate shows of itself, without a crack and unloaded.
struct OwnNumbers {
  double young_along = 0, poisson_along = 0;    // by a static pull along x; nu in the plane
  double young_across = 0, poisson_across = 0;  // along y
  std::vector<calibration::Wave> waves;         // by kind, the longest first
  theory::WaveSpeeds nominal;                   // of the preset's material [m/s]

  /// The speed of the longest wave of a kind; NaN where none was measured.
  double speed(calibration::WaveKind kind) const;
};

/// Measures the first lane's plate with its beams. Throws as prepare() does.
OwnNumbers measure_own_numbers(const Prepared& prepared, base::Cache& cache,
                               const StageProgress& progress = {}, int threads = 0);

/// With names of numbers as in summaries: "measured_young_modulus_along_pa", ..., "waves": [{"kind",
/// "wavelength_m", "wavelength_over_radius", "speed_m_s"}].
nlohmann::ordered_json json_of(const OwnNumbers& numbers, double mean_radius);

}  // namespace rift::simulation
