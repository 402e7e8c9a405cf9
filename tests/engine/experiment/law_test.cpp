#include "engine/experiment/application.hpp"

#include <gtest/gtest.h>

namespace rift::experiment {
namespace {

CriticalPoint at(double over_cr, double rate) {
  CriticalPoint p;
  p.over_cr = over_cr, p.as_paper = rate, p.uncertainty = 0.1 * rate;
  return p;
}

TEST(Law, AveragesPoolsWhatFallsAndGoesOnWithItsMeanSlope) {
  // 0.20 and 0.21 are averaged; 0.4 falls below 0.3 and is pooled with it.
  const auto law = law_of({at(0.4, 1400), at(0.21, 1100), at(0.2, 900), at(0.3, 1800), at(0.6, 2000)});
  ASSERT_EQ(law.size(), 5U);
  EXPECT_NEAR(law[1][0], 0.205, 1e-12);
  EXPECT_NEAR(law[1][1], 1000, 1e-9);
  EXPECT_NEAR(law[1][2], 100, 1e-9);
  EXPECT_NEAR(law[2][0], 0.35, 1e-12);
  EXPECT_NEAR(law[2][1], 1600, 1e-9);
  EXPECT_NEAR(law[3][1], 2000, 1e-9);
  const double slope = 1000 / 0.395;
  EXPECT_EQ(law[0][0], 0.0);
  EXPECT_NEAR(law[0][1], 1000 - slope * 0.205, 1e-6);
  EXPECT_EQ(law[4][0], 1.0);
  EXPECT_NEAR(law[4][1], 2000 + slope * 0.4, 1e-6);
}

TEST(Law, ThatFallsThroughoutIsFlat) {
  const auto law = law_of({at(0.2, 3000), at(0.4, 2000), at(0.6, 1000)});
  ASSERT_EQ(law.size(), 3U);
  for (const auto& [over_cr, rate, uncertainty] : law) EXPECT_NEAR(rate, 2000, 1e-9);
}

TEST(Law, AsksForSomethingAtRestHoweverSteep) {
  const auto law = law_of({at(0.4, 1000), at(0.5, 3000)});
  EXPECT_NEAR(law.front()[1], 50.0, 1e-9);
}

}  // namespace
}  // namespace rift::experiment
