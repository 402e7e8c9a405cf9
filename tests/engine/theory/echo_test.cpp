#include "engine/theory/references.hpp"
#include "engine/theory/wave_speeds.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rift::theory {
namespace {

constexpr double far = 1e3;  // [m], of an end that does not matter

// model.md §9.4, on the paper's plate: H = 40 mm, nu = 0.3, plane stress; three digits are printed.
TEST(Echo, OfTheGripsIsBackAfterTheAdvanceOfThePapersPlate) {
  const WaveSpeeds c = wave_speeds(10e9, 0.3, 667.0, Plane::stress);
  const auto advance = [&](double x) { return echo_free_advance(x * c.rayleigh, 0.04, far, c.dilatational); };
  EXPECT_NEAR(advance(0.5), 11.3e-3, 0.05e-3);
  EXPECT_NEAR(advance(1.0), 25.8e-3, 0.05e-3);
  for (const double x : {0.1, 0.5, 0.8, 1.0})
    EXPECT_NEAR(advance(x), 21.7e-3 * x / std::sqrt(1.0 - 0.294 * x * x), 0.05e-3) << x;
}

// By the way of the wave: to the grip and back to the tip, which has gone on meanwhile.
TEST(Echo, HasTravelledForAsLongAsTheTip) {
  constexpr double c_d = 4000.0, height = 0.05, ahead = 0.03;
  for (const double v : {10.0, 1000.0, 2500.0, 3900.0}) {
    const double of_grips = echo_free_advance(v, height, far, c_d);
    EXPECT_NEAR(2.0 * std::hypot(0.5 * height, 0.5 * of_grips) / c_d * v / of_grips, 1.0, 1e-12) << v;
    const double of_end = echo_free_advance(v, far, ahead, c_d);
    EXPECT_NEAR((ahead + ahead - of_end) / c_d * v / of_end, 1.0, 1e-12) << v;
    EXPECT_EQ(echo_free_advance(v, height, ahead, c_d), std::fmin(of_grips, of_end)) << v;
  }
}

TEST(Echo, NeverCatchesUpWithATipAsFastAsTheWaves) {
  EXPECT_TRUE(std::isinf(echo_free_advance(4000.0, 0.04, 0.1, 4000.0)));
  EXPECT_TRUE(std::isinf(echo_free_advance(4400.0, 0.04, 0.1, 4000.0)));
}

}  // namespace
}  // namespace rift::theory
