#pragma once

#include "engine/calibration/cylinders.hpp"
#include "engine/lattice/lattice.hpp"
#include "engine/scene/scene.hpp"

#include <array>
#include <stdexcept>

namespace rift::calibration {

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
                     base::Cache& cache, const CalibrationProgress& progress = {}, int threads = 0);

}  // namespace rift::calibration
