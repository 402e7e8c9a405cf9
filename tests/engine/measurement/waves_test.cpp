#include "engine/measurement/waves.hpp"

#include "engine/base/interrupted.hpp"
#include "engine/lattice/stable_step.hpp"
#include "tests/engine/calibration/cubic_lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rift::measurement {
namespace {

struct Plate {
  lattice::Lattice lattice = calibration::cubic_lattice::lattice_of({120, 24, 1}, packing::Shape::block);
  double dt = 0.5 * lattice::stable_step(lattice).critical;
};

/// Speeds of long waves along the axes of a cubic lattice of rigidly joined beams, of density 1000 kg/m3.
theory::WaveSpeeds exact() {
  const double r = calibration::cubic_lattice::section_radius, l = calibration::cubic_lattice::edge,
               e = calibration::cubic_lattice::young;
  const double direct = e * std::numbers::pi * r * r / (l * l);
  const double shear = 6.0 * e * (std::numbers::pi * r * r * r * r / 4.0) / (l * l * l * l);
  return {std::sqrt(direct / 1000.0), std::sqrt(shear / 1000.0), 0.9 * std::sqrt(shear / 1000.0)};
}

double longest(const std::vector<Wave>& waves, WaveKind kind) {
  for (const Wave& wave : waves)
    if (wave.kind == kind) return wave.speed;
  return 0.0;
}

TEST(MeasuredWaves, OfACubicLatticeAreItsOwn) {
  const Plate plate;
  // What is expected is only where to look: 10 % off changes nothing but when the echo is awaited.
  theory::WaveSpeeds guess = exact();
  const std::vector<Wave> waves = measured_waves(plate.lattice, plate.dt, guess);
  // 24 columns: the wave of one period across has k l = 2 pi / 24, and a chain's speed is sin(k l / 2) / (k l
  // / 2) of that of long waves.
  const double half = std::numbers::pi / 24.0;
  EXPECT_NEAR(longest(waves, WaveKind::dilatational) / (exact().dilatational * std::sin(half) / half), 1.0,
              2e-3);
  guess.dilatational *= 1.1;
  const double moved = longest(measured_waves(plate.lattice, plate.dt, guess), WaveKind::dilatational);
  EXPECT_NEAR(moved / longest(waves, WaveKind::dilatational), 1.0, 2e-3);
}

TEST(MeasuredWaves, AreLongestFirstAndNoneIsShorterThanEightRadii) {
  const Plate plate;
  const std::vector<Wave> waves = measured_waves(plate.lattice, plate.dt, exact());
  ASSERT_GT(waves.size(), 4u);
  for (std::size_t k = 0; k < waves.size(); ++k) {
    EXPECT_GE(waves[k].wavelength, 8.0 * plate.lattice.mean_radius);
    EXPECT_LE(waves[k].misfit, 0.1);
    if (k > 0 && waves[k].kind == waves[k - 1].kind) {
      EXPECT_LT(waves[k].wavelength, waves[k - 1].wavelength);
    }
  }
}

TEST(MeasuredWaves, StopWhenToldTo) {
  const Plate plate;
  EXPECT_THROW(measured_waves(plate.lattice, plate.dt, exact(), 1, [](double) { return false; }),
               base::Interrupted);
}

}  // namespace
}  // namespace rift::measurement
