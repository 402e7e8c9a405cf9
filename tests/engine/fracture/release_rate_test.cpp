#include "engine/fracture/release_rate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace rift::fracture {
namespace {

using results::RatePoint;
using results::Sample;

constexpr RateScale scale{.thickness = 2e-3, .g_i0 = 5e5, .length = 0.2};
constexpr double unit = 2e-3 * 5e5;  // b G_I0: energy per length at a ratio of 1 [J/m]

/// What happens per metre of crack, in units of b G_I0.
struct Rates {
  double fracture = 0, damping = 0, numerical = 0, rotation = 0, correction = 0, work = 0;
};

/// Books that close: what is released, lost or kept as rotation comes out of the elastic energy.
Sample row_at(double tip, const Rates& per_metre, double start = 0.0) {
  const double a = (tip - start) * unit;
  Sample s;
  s.tip_m = tip;
  s.fracture_j = per_metre.fracture * a;
  s.damping_j = per_metre.damping * a;
  s.numerical_damping_j = per_metre.numerical * a;
  s.kinetic_rotation_j = per_metre.rotation * a;
  s.kinetic_translation_j = 0.125 * a;
  s.step_correction_j = per_metre.correction * a;
  s.work_external_j = per_metre.work * a;
  s.elastic_j = 400.0 + s.work_external_j + s.step_correction_j - s.fracture_j - s.damping_j -
                s.numerical_damping_j - s.kinetic_rotation_j - s.kinetic_translation_j;
  return s;
}

std::vector<Sample> rows(int count, double end, const Rates& per_metre) {
  std::vector<Sample> lane;
  for (int k = 0; k < count; ++k) lane.push_back(row_at(end * k / (count - 1), per_metre));
  return lane;
}

// 1e-12: differences of some 400 J, a few 1e-14 each, over some J.
constexpr double rounding = 1e-12;

TEST(RateBetween, IsWhatLeavesTheLatticeOverStripEnergyPerLength) {
  const Rates what{.fracture = 0.62};
  const RatePoint rate = rate_between(row_at(0.04, what), row_at(0.08, what), scale);
  EXPECT_NEAR(rate.ratio, 0.62, rounding);
  EXPECT_NEAR(rate.ratio_fracture, 0.62, rounding);
  EXPECT_NEAR(rate.ratio_paper, 0.62, rounding);
  EXPECT_NEAR(rate.ratio_difference, 0.0, rounding);
  EXPECT_DOUBLE_EQ(rate.tip_m, 0.06);
}

TEST(RateBetween, CountsViscousDampingInTheRatioAndNotInThatOfTheBeams) {
  const Rates what{.fracture = 0.31, .damping = 0.2, .numerical = 0.07};
  const RatePoint rate = rate_between(row_at(0.04, what), row_at(0.08, what), scale);
  EXPECT_NEAR(rate.ratio, 0.51, rounding);
  EXPECT_NEAR(rate.ratio_fracture, 0.31, rounding);
  EXPECT_NEAR(rate.ratio_paper, 0.51, rounding);
  EXPECT_NEAR(rate.ratio_difference, 0.0, rounding);
}

TEST(RateBetween, LeavesRotationInTheRateWhereKineticEnergyIsOfTranslationOnly) {
  const Rates what{.fracture = 0.31, .rotation = 0.11};
  const RatePoint rate = rate_between(row_at(0.04, what), row_at(0.08, what), scale);
  EXPECT_NEAR(rate.ratio, 0.31, rounding);
  EXPECT_NEAR(rate.ratio_paper, 0.42, rounding);
}

TEST(RateBetween, TakesWorkOfTheGripsAndTheStepCorrectionIntoAccount) {
  const Rates what{.fracture = 0.31, .correction = 0.05, .work = 0.4};
  const RatePoint rate = rate_between(row_at(0.04, what), row_at(0.08, what), scale);
  EXPECT_NEAR(rate.ratio, 0.31, rounding);
  EXPECT_NEAR(rate.ratio_fracture, 0.31, rounding);
}

// Where the energy balance does not close the two ratios differ by what is missing: neither is made from the
// other.
TEST(RateBetween, ShowsAnOpenBalanceAsADifferenceOfTheTwoRatios) {
  const Rates what{.fracture = 0.31};
  Sample to = row_at(0.08, what);
  to.fracture_j += 0.1 * unit * 0.04;
  const RatePoint rate = rate_between(row_at(0.04, what), to, scale);
  EXPECT_NEAR(rate.ratio, 0.31, rounding);
  EXPECT_NEAR(rate.ratio_fracture, 0.41, rounding);
  EXPECT_NEAR(rate.ratio_difference, -0.1, rounding);
}

TEST(RateBetween, CountsBothOfTwoTips) {
  RateScale two = scale;
  two.tips = 2;
  const Rates what{.fracture = 0.62};
  EXPECT_NEAR(rate_between(row_at(0.04, what), row_at(0.08, what), two).ratio, 0.31, rounding);
}

// Releases b G_I0(a) da at each of two tips, summed up in small pieces: the ratio is 1.
TEST(RateBetween, OfACentralCrackIsOverTheIntegralOfItsReference) {
  const RateScale central{.thickness = 2e-3, .length = 0.2, .g_i0_slope = 3e7, .tips = 2};
  for (const auto& [from, to] : {std::pair{0.0, 0.01}, std::pair{0.012, 0.013}, std::pair{0.02, 0.08}}) {
    constexpr int pieces = 1000;
    double energy = 0.0;  // trapezoids: exact for what is linear in a
    for (int k = 0; k < pieces; ++k) {
      const double a = from + (to - from) * k / pieces, next = from + (to - from) * (k + 1) / pieces;
      energy += 2.0 * 2e-3 * 0.5 * (3e7 * a + 3e7 * next) * (next - a);
    }
    Sample first, last;
    first.tip_m = from, last.tip_m = to;
    first.elastic_j = 400.0, last.elastic_j = 400.0 - energy;
    last.fracture_j = energy;
    const RatePoint rate = rate_between(first, last, central);
    EXPECT_NEAR(rate.ratio_fracture, 1.0, rounding) << from;
    EXPECT_NEAR(rate.ratio * energy, energy, 400.0 * 1e-15) << from;
  }
}

TEST(MeanGI0, IsTheMiddlesAndOfAStripItsOwnToTheLastBit) {
  EXPECT_EQ(mean_g_i0(scale, -0.01, 0.3), scale.g_i0);
  const RateScale central{.thickness = 2e-3, .length = 0.2, .g_i0_slope = 3e7, .tips = 2};
  EXPECT_DOUBLE_EQ(mean_g_i0(central, 0.02, 0.04), 3e7 * 0.03);
}

// A zone ahead of the tip releases before there is a crack to refer to.
TEST(RateCurve, OfACentralCrackBeginsWhereTheDifferenceBeginsAtNoLength) {
  const RateScale central{.thickness = 2e-3, .length = 0.2, .g_i0_slope = 3e7, .tips = 2};
  std::vector<Sample> lane;
  for (int k = -10; k <= 100; ++k) lane.push_back(row_at(0.0005 * k, {.fracture = 1.0}));
  const std::vector<RatePoint> curve = rate_curve(lane, central);
  ASSERT_FALSE(curve.empty());
  EXPECT_NEAR(curve.front().tip_m, 1e-3,
              0.51e-3);  // half of 0.01 L; the row on the limit may round either way
  for (const RatePoint& point : curve) EXPECT_TRUE(std::isfinite(point.ratio) && point.ratio > 0.0);
}

TEST(RateCurve, OfEnergiesLinearInTheTipIsConstantBetweenAnyRows) {
  const Rates what{.fracture = 0.62, .damping = 0.1, .rotation = 0.05};
  for (const int count : {21, 117, 1000}) {  // rows further apart than 0.01 L, about as far, nearer
    const std::vector<RatePoint> curve = rate_curve(rows(count, 0.08, what), scale);
    ASSERT_FALSE(curve.empty());
    for (const RatePoint& point : curve) {
      EXPECT_NEAR(point.ratio, 0.72, 10 * rounding);  // over 2 mm: twenty times less energy
      EXPECT_NEAR(point.ratio_fracture, 0.62, 10 * rounding);
      EXPECT_NEAR(point.ratio_paper, 0.77, 10 * rounding);
      EXPECT_NEAR(point.ratio_difference, 0.0, 10 * rounding);
    }
  }
}

TEST(RateCurve, HasAPointAtEachRowAsFarAsTheDifferenceReaches) {
  const std::vector<Sample> lane =
      rows(161, 0.08, {.fracture = 1.0});  // 0.5 mm apart; half of 0.01 L is 1 mm
  const std::vector<RatePoint> curve = rate_curve(lane, scale);
  // Rows 2 and 158 lie on the limit itself, where rounding decides.
  ASSERT_GE(curve.size(), 155U);
  ASSERT_LE(curve.size(), 157U);
  EXPECT_NEAR(curve.front().tip_m, 1e-3, 0.51e-3);
  EXPECT_NEAR(curve.back().tip_m, 79e-3, 0.51e-3);
  for (std::size_t k = 1; k < curve.size(); ++k)
    EXPECT_NEAR(curve[k].tip_m - curve[k - 1].tip_m, 0.5e-3, 1e-12);
}

// Fracture energy a^2: the centred difference of a parabola is exact where rows lie at its ends, so the curve
// is 2 a and neither shifted nor smeared.
TEST(RateCurve, IsCentred) {
  std::vector<Sample> lane;
  for (int k = 0; k <= 160; ++k) {
    Sample s = row_at(0.0005 * k, {});
    s.fracture_j = s.tip_m * s.tip_m * unit;
    s.elastic_j -= s.fracture_j;
    lane.push_back(s);
  }
  const std::vector<RatePoint> curve = rate_curve(lane, scale);
  ASSERT_GT(curve.size(), 100U);
  for (const RatePoint& point : curve) EXPECT_NEAR(point.ratio_fracture, 2.0 * point.tip_m, rounding);
}

TEST(RateCurve, OfARunShorterThanTheDifferenceIsEmpty) {
  EXPECT_TRUE(rate_curve(rows(10, 1.9e-3, {.fracture = 1.0}), scale).empty());
}

TEST(Plateau, IsTheRateOverTheWindow) {
  const Rates what{.fracture = 0.62, .damping = 0.1, .rotation = 0.05};
  const Plateau plateau = plateau_of(rows(161, 0.08, what), {0.04, 0.08}, scale);
  ASSERT_TRUE(plateau.reached);
  EXPECT_NEAR(plateau.mean.ratio, 0.72, rounding);
  EXPECT_NEAR(plateau.window_m[0], 0.04, 1e-15);
  EXPECT_NEAR(plateau.window_m[1], 0.08, 1e-15);
  EXPECT_NEAR(plateau.scatter, 0.0, 1e-6);  // the root of a difference of squares: sqrt(1e-15) and a little
}

TEST(Plateau, IgnoresWhatLiesOutsideTheWindow) {
  std::vector<Sample> lane = rows(201, 0.1, {.fracture = 0.62});
  for (Sample& s : lane) {
    if (s.tip_m < 0.0399) s.fracture_j -= 30.0;
    if (s.tip_m > 0.0801) s.fracture_j += 30.0;
  }
  const Plateau plateau = plateau_of(lane, {0.04, 0.08}, scale);
  ASSERT_TRUE(plateau.reached);
  EXPECT_NEAR(plateau.mean.ratio_fracture, 0.62, rounding);
}

// A released energy that grows as a^2 takes 2 a: 0.14 over the second half of 0.04 to 0.08 and 0.10 over the first.
TEST(Plateau, TrendIsTheSecondHalfLessTheFirst) {
  std::vector<Sample> lane;
  for (int k = 0; k <= 200; ++k) {
    Sample s = row_at(0.0005 * k, {});
    s.fracture_j = s.tip_m * s.tip_m * unit;
    s.elastic_j -= s.fracture_j;
    lane.push_back(s);
  }
  EXPECT_NEAR(plateau_of(lane, {0.04, 0.08}, scale).trend, 0.04, rounding);
}

// Ten sub-windows of 0.5, 0.7, 0.5, ...: mean 0.6, and each 0.1 from it: sqrt(10 x 0.01 / 9).
TEST(Plateau, ScatterIsTheStandardDeviationOverTenSubWindows) {
  std::vector<Sample> lane{row_at(0.04, {})};
  for (int k = 0; k < 10; ++k) {
    const double rate = k % 2 == 0 ? 0.5 : 0.7;
    for (int n = 1; n <= 4; ++n) {
      Sample s = lane.back();
      s.tip_m = 0.04 + 0.004 * k + 0.001 * n;
      s.fracture_j += 0.7 * rate * unit * 0.001;
      s.damping_j += 0.3 * rate * unit * 0.001;  // the scatter is that of the ratio with damping
      s.elastic_j -= rate * unit * 0.001;
      lane.push_back(s);
    }
  }
  const Plateau plateau = plateau_of(lane, {0.04, 0.08}, scale);
  ASSERT_TRUE(plateau.reached);
  EXPECT_NEAR(plateau.mean.ratio, 0.6, rounding);
  EXPECT_NEAR(plateau.scatter, std::sqrt(0.1 / 9.0), 1e-10);
}

TEST(Plateau, IsNotReachedWhereTheRunStoppedBeforeTheEndOfTheWindow) {
  EXPECT_FALSE(plateau_of(rows(161, 0.079, {.fracture = 0.62}), {0.04, 0.08}, scale).reached);
  EXPECT_FALSE(plateau_of({}, {0.04, 0.08}, scale).reached);
  EXPECT_TRUE(plateau_of(rows(161, 0.0799, {.fracture = 0.62}), {0.04, 0.08}, scale).reached);
}

TEST(Plateau, IsNotReachedWhereTheBooksBeginInsideTheWindow) {
  std::vector<Sample> lane = rows(161, 0.08, {.fracture = 0.62});
  lane.erase(lane.begin(), lane.begin() + 90);
  EXPECT_FALSE(plateau_of(lane, {0.04, 0.08}, scale).reached);
}

}  // namespace
}  // namespace rift::fracture
