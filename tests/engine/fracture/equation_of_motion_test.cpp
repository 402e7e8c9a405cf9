#include "engine/fracture/equation_of_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rift::fracture {
namespace {

using Against = CriticalRate::Against;
constexpr double c_r = 1000.0;

TEST(DrivingForce, OfAnEvenReleaseIsWhatIsReleasedAtRest) {
  // 900 J/m2 by a plate of 2 mm, released at 0.25 c_r: 1,200 at rest. The weights' mean is 1.
  std::vector<ReleasedBeam> beams;
  for (int k = 0; k < 1000; ++k) beams.push_back({0.02 + 1e-5 * (k + 0.5), 900.0 * 2e-3 * 1e-5, 0.25});
  EXPECT_NEAR(driving_force(beams, 0.03, 0.01, 2e-3), 1200.0, 1e-3);
  EXPECT_NEAR(driving_force(beams, 0.025, 0.005, 2e-3), 1200.0, 1e-2);  // those ahead and behind do not count
}

TEST(DrivingForce, IsKnownTheBetterTheLongerItsWindow) {
  // Beams of 0 and 2 J in turns, 1 J/mm in the mean: sqrt(2 x 1.2 / N) of it.
  std::vector<ReleasedBeam> beams;
  for (int k = 0; k < 4000; ++k) beams.push_back({1e-5 * (k + 0.5), k % 2 == 0 ? 0.0 : 2.0, 0.0});
  const double short_window =
      driving_force_error(beams, 0.04, 0.01, 1.0) / driving_force(beams, 0.04, 0.01, 1.0);
  const double long_window =
      driving_force_error(beams, 0.04, 0.04, 1.0) / driving_force(beams, 0.04, 0.04, 1.0);
  EXPECT_NEAR(short_window, std::sqrt(2.4 / 1000.0), 1e-4);
  EXPECT_NEAR(long_window, 0.5 * short_window, 1e-4);
}

TEST(CriticalRateAt, IsStraightBetweenRowsAndConstantBeyond) {
  const CriticalRate by_velocity{Against::velocity_over_cr, {{0.1, 1000.0}, {0.5, 3000.0}}};
  EXPECT_EQ(critical_rate(by_velocity, 0.0, c_r, 7.0), 1000.0);
  EXPECT_NEAR(critical_rate(by_velocity, 0.3, c_r, 7.0), 2000.0, 1e-9);
  EXPECT_EQ(critical_rate(by_velocity, 0.9, c_r, 7.0), 3000.0);
  EXPECT_DOUBLE_EQ(critical_rate({Against::velocity, {{100.0, 1000.0}, {500.0, 3000.0}}}, 0.3, c_r, 7.0),
                   2000.0);
  EXPECT_DOUBLE_EQ(critical_rate({Against::position, {{0.1, 1000.0}, {0.5, 3000.0}}}, 0.9, c_r, 0.2), 1500.0);
  EXPECT_EQ(critical_rate({Against::position, {{0.1, 1000.0}}}, 0.9, c_r, 0.2), 1000.0);
}

TEST(VelocityOverCr, IsTheRootOfTheEquationOfMotion) {
  const CriticalRate rising{Against::velocity_over_cr, {{0.0, 1000.0}, {1.0, 3000.0}}};
  // 2000 (1 - v) = 1000 + 2000 v
  EXPECT_NEAR(velocity_over_cr(2000.0, rising, c_r, 0.0, 0.95), 0.25, 1e-8);
  EXPECT_EQ(velocity_over_cr(999.0, rising, c_r, 0.0, 0.95), 0.0);  // arrested
  EXPECT_NEAR(velocity_over_cr(1000.5, rising, c_r, 0.0, 0.95), 0.5 / 3000.5, 1e-7);
  EXPECT_EQ(velocity_over_cr(1e9, rising, c_r, 0.0, 0.95), 0.95);
  const CriticalRate along{Against::position, {{0.0, 1000.0}, {1.0, 3000.0}}};
  EXPECT_NEAR(velocity_over_cr(3000.0, along, c_r, 0.25, 0.95), 0.5, 1e-8);
}

TEST(VelocityOverCr, IsTheHighestOfSeveralRoots) {
  // Falls, then rises: 1500 (1 - v) meets it more than once.
  const CriticalRate weakening{Against::velocity_over_cr, {{0.0, 1600.0}, {0.2, 900.0}, {0.8, 900.0}}};
  EXPECT_NEAR(velocity_over_cr(1500.0, weakening, c_r, 0.0, 0.95), 0.4, 1e-8);
}

}  // namespace
}  // namespace rift::fracture
