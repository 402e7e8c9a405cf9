#pragma once

#include "engine/base/interrupted.hpp"
#include "engine/measurement/waves.hpp"
#include "engine/simulation/own_constants.hpp"
#include "engine/simulation/prepare.hpp"

#include <nlohmann/json.hpp>

#include <optional>

namespace rift::measurement {

/// G / G_I0 of the first lane's crack, run through a window infinitely slowly: what two plates at rest, cut
/// and softened as with the tip at the window's ends, differ by in energy
///   (U(a_0) - U(a_1)) / (b times the integral of G_I0 da)
/// A crack that releases beams at once radiates the same share however slow it is, and has no such limit.
/// Cost: two static solutions. Throws StaticsError, Interrupted.
/// @param[in] window  tip positions [m]
double quasi_static_ratio(const simulation::Prepared& prepared, const std::array<double, 2>& window,
                          const base::ProgressCallback& told = {});

/// -dU/da of a slow crack between each two neighbours of these tip positions [m], in J/m2: one less than
/// positions. Cost: a static solve for each.
std::vector<double> quasi_static_rates(const simulation::Prepared& prepared, const std::vector<double>& tip,
                                       const base::ProgressCallback& told = {});

/// What a lane's plate shows of itself, without a crack and unloaded.
struct SpecimenProperties {
  simulation::OwnConstants pulled;  // by static pulls, of the lane's beams
  std::vector<Wave> waves;          // by kind, the longest first
  theory::WaveSpeeds own;           // of long waves, by the pulls' E and nu in plane stress [m/s]
  theory::WaveSpeeds nominal;       // of the preset's material [m/s]

  /// The speed of the longest wave of a kind; NaN where none was measured.
  double speed(WaveKind kind) const;
};

/// The pulls alone, of a lane's plate: E and nu in the plane of its specimen with its beams. From the cache
/// where they were measured before. Throws StaticsError, Interrupted.
simulation::OwnConstants pulled_constants(const simulation::Prepared& prepared,
                                          const simulation::LanePlan& lane, base::Cache& cache,
                                          const base::ProgressCallback& told = {}, int threads = 0);

/// The same where the cache holds it; nothing is computed.
std::optional<simulation::OwnConstants> known_constants(const simulation::Prepared& prepared,
                                                        const simulation::LanePlan& lane, base::Cache& cache);

/// Measures the first lane's plate with its beams, or recalls from the cache what was measured of it before.
/// Throws as prepare() does.
SpecimenProperties measure_specimen(const simulation::Prepared& prepared, base::Cache& cache,
                                    const simulation::StageProgress& progress = {}, int threads = 0);

/// With names of numbers as in summaries: "measured_young_modulus_along_pa", ..., "waves": [{"kind",
/// "wavelength_m", "wavelength_over_radius", "speed_m_s"}].
nlohmann::ordered_json json_of(const SpecimenProperties& numbers, double mean_radius);

}  // namespace rift::measurement
