#pragma once

#include "engine/base/cache.hpp"
#include "engine/base/process_limits.hpp"
#include "engine/calibration/cylinders.hpp"
#include "engine/calibration/homogenise.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/scene/scene.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <stdexcept>

namespace rift::calibration {

/// The result of each test, several at once, the largest packing first; each thread has a cache of its own,
/// whose notes are gathered in `cache`.
/// @param[in] result_of  (test, cache, tell) -> result; tell as in side_by_side()
template <class Test, class ResultOf>
auto each_specimen(const std::vector<Test>& tests, base::Cache& cache, const base::ProgressCallback& progress,
                   int threads, const ResultOf& result_of) {
  std::vector<double> work;
  for (const Test& test : tests) work.push_back(test.packing.elements);
  std::vector<base::Cache> caches(base::threads_or_all_cpus(threads), base::Cache{cache.folder, {}});
  std::vector<decltype(result_of(tests.front(), cache, progress))> results(tests.size());
  side_by_side(work, threads, progress, [&](std::size_t k, int thread, const base::ProgressCallback& tell) {
    results[k] = result_of(tests[k], caches[thread], tell);
  });
  for (const base::Cache& used : caches)
    cache.notes.insert(cache.notes.end(), used.notes.begin(), used.notes.end());
  return results;
}

/// A mean over packings and the standard deviation of one of them; that is NaN of a single packing.
struct Scattered {
  double mean = 0, deviation = 0;
};

Scattered scattered(const std::vector<double>& values);

/// The beams that make a solid of a given E and nu.
struct Calibrated {
  lattice::MicroMaterial micro;
  double micro_young_deviation = 0;        // of E_mu over the packings [Pa]
  double radius_ratio_deviation = 0;       // of r_mu
  Scattered young_modulus, poisson_ratio;  // of the cylinders with these very beams [Pa, -]
  std::array<double, 2> attainable{0, 0};  // of nu, by the scanned beams
};

/// Poisson's ratio is out of what beams of this range can make.
struct OutOfReach : std::runtime_error {
  std::array<double, 2> attainable;
  OutOfReach(double wanted, std::array<double, 2> range);
};

/// The cylinders of a calibration of this scene's material: of its specimen's coordination, spread and
/// contact tolerance, and twice as high as wide.
/// @param[in] beams  that each is tried with
std::vector<CylinderTest> cylinders_for(const scene::Scene& scene, int elements,
                                        const std::vector<BeamShape>& beams);

/// The scanned beams of a scene, with the paper's nu_mu.
std::vector<BeamShape> scanned_beams(const scene::Scene& scene);

/// Means over the packings of one size, by beam.
std::vector<Scattered> young_of(const std::vector<CylinderResult>& packings);  // E_M / E_mu
std::vector<Scattered> poisson_of(const std::vector<CylinderResult>& packings);

/// r_mu by interpolation of nu over the scan, then by secants over cylinders that are pressed with it until
/// their nu is within 2e-4 of the one asked for; E_mu by proportion, nothing computed. nu_mu hardly counts
/// and is the paper's.   [paper, appendix; Andre et al. 2012] Throws OutOfReach, and what press_cylinders()
/// throws.
Calibrated calibrate(const scene::Scene& scene, double young_modulus, double poisson_ratio,
                     base::Cache& cache, const base::ProgressCallback& progress = {}, int threads = 0);

/// What Fig. 17 of the paper shows, and the periodic boxes beside it.
struct CalibrationStudy {
  std::vector<std::vector<CylinderResult>> by_size;  // with the paper's beams; packings of each size
  std::vector<CylinderResult> scan;                  // with the scanned beams
  std::vector<CylinderResult> twisted;               // with the paper's r_mu and other nu_mu
  std::vector<BoxResult> boxes;  // at the coordination asked for, then at the scanned cylinders' core's
};

/// A specimen that a calibration presses, and for how many beams, known before it.
struct PlannedSpecimen {
  const char* stage = "";
  int elements = 0;
  bool packed_before = false;  // in an earlier stage
  int solutions = 0;
};

/// What calibrate() presses at most for a scene, and with `study` what study_calibration() presses before it.
std::vector<PlannedSpecimen> planned_specimens(const scene::Scene& scene, bool study);

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
