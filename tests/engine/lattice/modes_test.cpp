#include "engine/lattice/modes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rift::lattice {
namespace {

TEST(StepOfAMode, GrowsByTheRootsOfTheRecurrence) {
  EXPECT_NEAR(step_of_mode(1.0, 1.0).growth(), 0.0, 1e-15);
  // x_{n+1} - 2 x_n + x_{n-1} = -9 x_n: roots of r^2 + 7 r + 1.
  EXPECT_NEAR(step_of_mode(3.0, 1.0).growth(), std::log((7.0 + std::sqrt(45.0)) / 2.0), 1e-14);
  EXPECT_NEAR(step_of_mode(1.0, 1.1).growth(), 0.5 * std::log(1.05), 1e-15);
}

TEST(StepOfAMode, TurnsByTheAngleOfTheComplexRoots) {
  // r^2 - r + 1: exp(+-i pi/3).
  EXPECT_NEAR(step_of_mode(1.0, 1.0).turn(), std::numbers::pi / 3.0, 1e-15);
  EXPECT_EQ(step_of_mode(3.0, 1.0).turn(), std::numbers::pi);  // both roots real and negative
}

}  // namespace
}  // namespace rift::lattice
