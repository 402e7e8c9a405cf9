#include "engine/claims/broberg_problem.hpp"

#include "engine/theory/references.hpp"
#include "engine/theory/strip_transient.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace rift::claims {
namespace {

constexpr double plate_length = 0.3, plate_thickness = 2e-3, strip_rate = 1e5, griffith = 1e7;  // SI
constexpr OwnPlate own_plate{.poisson_ratio = 0.28, .rayleigh_speed = 2150.0, .height = 0.059};

/// What the beams at a place take of what arrives: they differ, and are the same for each crack.
double efficiency_at(double x) { return 0.6 + 0.2 * std::sin(700.0 * x) + 0.1 * std::sin(260.0 * x); }

SummaryRow broberg_row(double v, double zone, double radius, long seed, const char* crack) {
  SummaryRow row;
  row.technique = "progressive", row.relaxation = 1.0, row.damage_zone_ratio = zone;
  row.crack_velocity_over_cr = v, row.seed = static_cast<double>(seed);
  row.elements = std::round(1.0 / radius), row.mean_radius_m = radius;
  row.length_m = plate_length, row.thickness_m = plate_thickness, row.rayleigh_speed_m_s = 2200.0;
  row.tips = std::string(crack) == "opening" ? 2 : 1, row.series = crack;
  row.window_over_length = {0.01, 0.09};
  row.g_i0_j_m2 = row.tips > 1.5 ? griffith * 0.05 * plate_length : strip_rate;
  row.echo_free_over_length = 0.06;
  return row;
}

/// The series of a crack whose zone takes the share of its beams of what theory says to arrive, times 1 +
/// excess, and for the crack that opens times 1 + (2 + 0.5 r_l) R / a more.
SeriesTable broberg_series(const SummaryRow& row, double excess) {
  SeriesTable series;
  const double da = 5e-5, end = row.tips > 1.5 ? 0.09 * plate_length : 0.59 * plate_length;
  const double own_v = row.crack_velocity_over_cr * row.rayleigh_speed_m_s / own_plate.rayleigh_speed;
  const double broberg = theory::broberg(own_v, own_plate.poisson_ratio, theory::Plane::stress).g;
  double energy = 0.0;
  for (double tip = row.tips > 1.5 ? 0.0 : 0.4 * plate_length; tip < end; tip += da) {
    series.column["tip_m"].push_back(tip);
    series.column["energy_fracture_j"].push_back(energy);
    const double a = tip + 0.5 * da;
    if (row.tips > 1.5) {
      const double size = row.mean_radius_m / a, shift = (2.0 + 0.5 * row.damage_zone_ratio) * size;
      energy += plate_thickness * da * griffith * a * broberg * (1.0 + shift) * (1.0 + excess) *
                (efficiency_at(0.5 * plate_length + a) + efficiency_at(0.5 * plate_length - a));
    } else {
      const double arrives = tip < 2.0 * own_plate.height
                                 ? 1.0
                                 : theory::strip_arrival(row.crack_velocity_over_cr, tip / own_plate.height,
                                                         (tip + da) / own_plate.height);
      energy += plate_thickness * da * strip_rate * arrives *
                efficiency_at(row.series == "left" ? plate_length - a : a);
    }
  }
  return series;
}

/// Two packings of two sizes each, with r_l = 1 and 4 at three velocities; the second packing's ratios are
/// off by `scatter`.
Evidence broberg_evidence(double excess, double scatter) {
  Evidence evidence{.rows = {},
                    .series =
                        [=](const SummaryRow& row) {
                          return broberg_series(row, excess + (row.seed > 1.5 ? scatter : -scatter));
                        },
                    .own = [](const SummaryRow&) { return own_plate; }};
  for (const double v : {0.3, 0.5, 0.7})
    for (const double zone : {1.0, 4.0})
      for (const double radius : {4e-4, 2e-4})
        for (const long seed : {1, 2})
          for (const char* crack : {"opening", "right", "left"})
            evidence.rows.push_back(broberg_row(v, zone, radius, seed, crack));
  return evidence;
}

TEST(BrobergProblem, TakesTheEfficiencyOfTheSameBeams) {
  Evidence evidence{.rows = {},
                    .series = [](const SummaryRow& row) { return broberg_series(row, 0.0); },
                    .own = [](const SummaryRow&) { return own_plate; }};
  for (const char* crack : {"right", "opening", "left"})
    evidence.rows.push_back(broberg_row(0.5, 1, 1e-6, 7, crack));
  const std::vector<BrobergProblem> points = broberg_problem(evidence);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_EQ(points[0].seed, std::vector<long>{7});
  EXPECT_NEAR(points[0].own_v, 0.5 * 2200.0 / 2150.0, 1e-12);
  EXPECT_NEAR(points[0].over_theory[0], 1.0, 2e-3);  // stretches of a tenth of the half length
  EXPECT_LT(points[0].per_cent_of_speed, 0.05);
  EXPECT_GT(points[0].per_cent_of_speed, 0.0);
}

TEST(BrobergProblem, WantsBothStrips) {
  Evidence evidence = broberg_evidence(0.0, 0.0);
  std::erase_if(evidence.rows, [](const SummaryRow& row) { return row.series == "left"; });
  EXPECT_TRUE(broberg_problem(evidence).empty());
  EXPECT_EQ(judge_broberg(evidence).verdict, Verdict::not_decidable);
}

TEST(BrobergLimits, AreWhatIsLeftWithoutRadiusAndZone) {
  const std::vector<BrobergLimit> limits = broberg_limits(broberg_problem(broberg_evidence(0.0, 0.0)));
  ASSERT_EQ(limits.size(), 3U);
  for (const BrobergLimit& limit : limits) {
    EXPECT_NEAR(limit.limit, 1.0, 3e-3) << limit.v;
    EXPECT_NEAR(limit.uncertainty, arrival_uncertainty, 1e-4) << limit.v;
  }
}

TEST(BrobergLimits, AreAsUncertainAsThePackingsScatter) {
  const std::vector<BrobergProblem> points = broberg_problem(broberg_evidence(0.0, 0.01));
  const auto mean_at = [&](double v, double elements) {
    double sum = 0.0;
    for (const BrobergProblem& p : points)
      if (p.v == v && p.elements == elements) sum += 0.25 * (p.over_theory[0] + p.over_theory[1]);
    return sum;
  };
  for (const BrobergLimit& limit : broberg_limits(points)) {
    // ± 1 % of each packing of a size, straight on from R / a to 0 of two sizes: 2 fine - coarse.
    const double one = 1.83734 * 0.01;
    EXPECT_NEAR(
        limit.uncertainty,
        std::hypot(2.0 * one * mean_at(limit.v, 5000), one * mean_at(limit.v, 2500), arrival_uncertainty),
        5e-4)
        << limit.v;
  }
}

TEST(BrobergClaim, IsJudgedByDistanceAndUncertainty) {
  const auto verdict = [](double excess, double scatter) {
    return judge_broberg(broberg_evidence(excess, scatter)).verdict;
  };
  EXPECT_EQ(verdict(0.015, 0.002), Verdict::holds);
  EXPECT_EQ(verdict(0.015, 0.01), Verdict::not_decidable);   // too uncertain
  EXPECT_EQ(verdict(0.024, 0.002), Verdict::not_decidable);  // beyond the margin by less than the uncertainty
  EXPECT_EQ(verdict(0.06, 0.002), Verdict::does_not_hold);
}

}  // namespace
}  // namespace rift::claims
