#include "engine/measurement/specimen_properties.hpp"
#include "engine/simulation/summary.hpp"
#include "tests/engine/simulation/small_plate.hpp"

namespace rift::measurement {
namespace {

// Notched plates are prepared on a path of their own.
TEST(QuasiStatic, IsWhatTwoNotchedPlatesDifferByInEnergy) {
  const simulation::Prepared p = simulation::small_plate({"crack.technique=simple"});
  const double first =
                   simulation::small_plate({"crack.start=10 mm", "output.window=[0.45, 0.48]"}).static_energy,
               second =
                   simulation::small_plate({"crack.start=20 mm", "output.window=[0.45, 0.48]"}).static_energy;
  EXPECT_NEAR(quasi_static_ratio(p, {0.010, 0.020}),
              (first - second) / (p.scale.thickness * 0.010 * p.scale.g_i0), 1e-9);
}

TEST(QuasiStatic, WithTurningBeamsTendsToThatOfFixedOnes) {
  const simulation::Prepared linear = simulation::small_plate(),
                             turning = simulation::small_plate(
                                 {"solver.kinematics=corotational", "loading.displacement=0.6 um"});
  EXPECT_NEAR(quasi_static_ratio(turning, {0.010, 0.020}), quasi_static_ratio(linear, {0.010, 0.020}), 1e-4);
}

// A long damage zone radiates little: the slower the crack, the nearer its limit.
TEST(QuasiStatic, IsWhereSlowProgressiveCracksTendTo) {
  const auto distance = [](const char* velocity) {
    const simulation::Prepared p =
        simulation::small_plate({"crack.damage_zone_ratio=6", std::string("crack.velocity=") + velocity});
    const fracture::Plateau plateau = simulation::rates_of(p, simulation::march(p, {})).plateau;
    // By steps: the rows of the books lie where the tip is then.
    return plateau.mean.ratio / quasi_static_ratio(p, plateau.window_m) - 1.0;
  };
  const double fast = distance("0.2 c_r"), slow = distance("0.02 c_r");
  EXPECT_LT(std::abs(slow), 0.05);
  EXPECT_LT(std::abs(slow), 0.3 * std::abs(fast));
}

}  // namespace
}  // namespace rift::measurement
