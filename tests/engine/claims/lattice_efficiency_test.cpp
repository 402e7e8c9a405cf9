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

TEST(Beyond, EfficiencyIsTheStripsRatioOverItsSpecimens) {
  SummaryRow of_two_tips = strip_row(0.5, 4, 0.2, 1);
  of_two_tips.tips = 2;
  const Evidence evidence{.rows = {strip_row(0.5, 4, 0.8, 1), strip_row(0.5, 4, 0.9, 2),
                                   strip_row(0.3, 4, 0.95, 1), strip_row(0.5, 8, 0.99, 1),
                                   strip_row(0.5, 4, 0.1, 1, 2.0), of_two_tips}};
  const std::vector<EfficiencyPoint> points = efficiency(evidence, 1.0, 4.0);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[0].v, 0.3);
  EXPECT_EQ(points[1].ratio, (std::vector<double>{0.8, 0.9}));
  EXPECT_EQ(zones_of(evidence), (std::vector<double>{4.0, 8.0}));
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
