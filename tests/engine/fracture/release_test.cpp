#include "engine/fracture/release.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rift::fracture {
namespace {

constexpr double zone = 0.49e-3, crossing = 7e-3;  // [m]

ReleaseLaw progressive(double exponent) { return {Technique::progressive, exponent, zone}; }

/// Y1/Y2 where the beam has been in the zone for b [m].
double left_at(double exponent, double b) {
  return stiffness_left(progressive(exponent), crossing - zone + b, crossing);
}

TEST(StiffnessLeft, IsAllAheadOfTheZoneAndNoneAtTheTip) {
  for (const double p : {1.0, 0.5, 2.0, 0.1, 16.0}) {
    EXPECT_EQ(left_at(p, -1.0), 1.0);
    EXPECT_EQ(left_at(p, -1e-9), 1.0);
    EXPECT_EQ(stiffness_left(progressive(p), crossing, crossing), 0.0);  // b = l: gone, not nearly gone
    EXPECT_EQ(stiffness_left(progressive(p), crossing + 1.0, crossing), 0.0);
  }
}

// 1e-12: the subtraction of positions ten times the zone costs a digit or two.
TEST(StiffnessLeft, FollowsTheThreeLawsOfThePaper) {
  for (const double part : {0.1, 0.25, 0.5, 0.9, 0.99}) {
    const double b = part * zone;
    EXPECT_NEAR(left_at(1.0, b), 1.0 - b / zone, 1e-12) << "eq. (9)";
    EXPECT_NEAR(left_at(0.5, b), std::sqrt(1.0 - b / zone), 1e-12) << "eq. (10)";
    EXPECT_NEAR(left_at(2.0, b), (1.0 - b / zone) * (1.0 - b / zone), 1e-12) << "eq. (11)";
    EXPECT_NEAR(left_at(3.7, b), std::pow(1.0 - b / zone, 3.7), 1e-12);
  }
}

TEST(StiffnessLeft, FallsAllTheWayThroughTheZone) {
  for (const double p : {1.0, 0.5, 2.0, 0.1, 8.0}) {
    double before = 1.0;
    for (int k = 1; k <= 100; ++k) {
      const double now = left_at(p, zone * k / 100.0);
      EXPECT_LT(now, before) << "p = " << p << ", b/l = " << k << " %";
      EXPECT_GE(now, 0.0);
      before = now;
    }
  }
}

TEST(StiffnessLeft, OfASimpleReleaseIsAllUntilTheTipArrives) {
  const ReleaseLaw simple{Technique::simple, 1.0, 0.0};
  EXPECT_EQ(stiffness_left(simple, std::nextafter(crossing, 0.0), crossing), 1.0);
  EXPECT_EQ(stiffness_left(simple, crossing, crossing), 0.0);
  EXPECT_EQ(stiffness_left(simple, std::nextafter(crossing, 1.0), crossing), 0.0);
}

}  // namespace
}  // namespace rift::fracture
