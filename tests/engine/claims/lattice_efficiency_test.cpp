#include "engine/claims/lattice_efficiency.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rift::claims {
namespace {

SummaryRow strip_row(double v, double zone, double ratio, long seed, double relaxation = 1.0) {
  SummaryRow row;
  row.technique = "progressive", row.relaxation = relaxation, row.damage_zone_ratio = zone;
  row.crack_velocity_over_cr = v, row.tips = 1, row.seed = static_cast<double>(seed);
  row.ratio = ratio, row.ratio_scatter = 0.01, row.error_broberg = ratio - 0.5;
  row.wall_fracture_s = 2.0;
  return row;
}

SummaryRow own_row(double v, double zone, double ratio, double radius, double broberg, long seed = 1) {
  SummaryRow row = strip_row(v, zone, ratio, seed);
  row.elements = std::round(1.0 / radius);
  row.tips = 2, row.mean_radius_m = radius, row.broberg = broberg, row.length_m = 0.2;
  row.window_over_length = {0.1, 0.3};  // 40 mm in the middle
  return row;
}

TEST(Beyond, EfficiencyIsTheStripsRatioOverItsSpecimens) {
  const Evidence evidence{.rows = {strip_row(0.5, 4, 0.8, 1), strip_row(0.5, 4, 0.9, 2),
                                   strip_row(0.3, 4, 0.95, 1), strip_row(0.5, 8, 0.99, 1),
                                   strip_row(0.5, 4, 0.1, 1, 2.0), own_row(0.5, 4, 0.2, 1e-3, 0.5)}};
  const std::vector<EfficiencyPoint> points = efficiency(evidence, 1.0, 4.0);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[0].v, 0.3);
  EXPECT_EQ(points[1].ratio, (std::vector<double>{0.8, 0.9}));
  EXPECT_EQ(zones_of(evidence), (std::vector<double>{4.0, 8.0}));
}

// ratio = eta Broberg (1 + 3 R / a): straight on to R = 0 it is eta Broberg.
TEST(Beyond, OwnProblemIsTakenStraightOnToNoRadius) {
  const double eta = 0.8, broberg = 0.52, half_length = 0.04;
  Evidence evidence{.rows = {strip_row(0.5, 4, eta, 1)}};
  for (const double radius : {1e-3, 0.5e-3})
    evidence.rows.push_back(
        own_row(0.5, 4, eta * broberg * (1.0 + 3.0 * radius / half_length), radius, broberg));
  const std::vector<Extrapolated> limits = extrapolated(broberg_problem(evidence));
  ASSERT_EQ(limits.size(), 1U);
  EXPECT_NEAR(limits[0].limit, broberg, 1e-12);
  EXPECT_EQ(find_claim("beyond_broberg")->judge(evidence).verdict, Verdict::holds);
  evidence.rows.push_back(own_row(0.5, 4, 0.8 * eta * broberg, 1e-3, broberg, 2));  // now they scatter
  EXPECT_EQ(find_claim("beyond_broberg")->judge(evidence).verdict, Verdict::not_decidable);
  evidence.rows.pop_back();
  evidence.rows[0] = strip_row(0.5, 4, 0.9, 1);
  EXPECT_EQ(find_claim("beyond_broberg")->judge(evidence).verdict, Verdict::does_not_hold);
}

TEST(Beyond, WithoutTheStripAtThatZoneNothingIsExtrapolated) {
  const Evidence evidence{.rows = {strip_row(0.5, 8, 0.9, 1), own_row(0.5, 4, 0.4, 1e-3, 0.52),
                                   own_row(0.5, 4, 0.41, 0.5e-3, 0.52)}};
  EXPECT_TRUE(extrapolated(broberg_problem(evidence)).empty());
  EXPECT_EQ(find_claim("beyond_broberg")->judge(evidence).verdict, Verdict::not_decidable);
}

TEST(Beyond, MapFindsTheCellNearestToBroberg) {
  const Evidence evidence{.rows = {strip_row(0.5, 1, 0.7, 1), strip_row(0.3, 1, 0.5, 1),
                                   strip_row(0.5, 2, 0.52, 1, 0.5), strip_row(0.3, 2, 0.52, 1, 0.5)}};
  const std::vector<MapCell> cells = map_of(evidence);
  ASSERT_EQ(cells.size(), 2U);
  EXPECT_EQ(cells[0].relaxation, 0.5);
  EXPECT_EQ(cells[1].wall_s, 4.0);
  const Judgement judgement = find_claim("beyond_map")->judge(evidence);
  EXPECT_EQ(judgement.verdict, Verdict::holds);
  EXPECT_NE(judgement.measured.find("best of 2: p = 0.5, r_l = 2, mean |delta| 0.020"), std::string::npos)
      << judgement.measured;
}

TEST(Beyond, AZoneThatTakesAllLetsTheEfficiencyHold) {
  const Evidence all{.rows = {strip_row(0.5, 1, 0.6, 1), strip_row(0.5, 16, 0.97, 1)}},
      some{.rows = {strip_row(0.5, 1, 0.6, 1), strip_row(0.5, 16, 0.9, 1)}};
  EXPECT_EQ(find_claim("beyond_efficiency")->judge(all).verdict, Verdict::holds);
  EXPECT_EQ(find_claim("beyond_efficiency")->judge(some).verdict, Verdict::does_not_hold);
}

TEST(Beyond, WakeBandsAreSharesOfAllThatMoves) {
  SummaryRow row;
  row.wake_cell_m = {2e-3, 4e-3}, row.wake_kinetic_j = {5.0, 2.0, 1.0}, row.wake_rotation_j = 2.0;
  row.mean_radius_m = 0.5e-3;
  const std::vector<WakeBand> bands = wake_bands(row);
  ASSERT_EQ(bands.size(), 3U);
  EXPECT_EQ(bands[0].cell, 4.0);
  EXPECT_EQ(bands[0].share, 0.5);
  EXPECT_EQ(bands[2].cell, 16.0);
  EXPECT_TRUE(wake_bands(SummaryRow{}).empty());
}

}  // namespace
}  // namespace rift::claims
