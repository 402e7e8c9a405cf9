#include "engine/lattice/stable_step.hpp"
#include "engine/stability/cracked_plate.hpp"
#include "engine/stability/free_vibration.hpp"
#include "engine/stability/suite.hpp"
#include "tests/shared_cache.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rift::stability {
namespace {

// The dear ones, of damage zones, inclusions and slow cracks, are left to suite_slow_test.cpp.

/// All cases of the families with this in their name come to what they must.
void expect_family(const std::string& name) {
  SuiteOptions options;
  options.quick = true;
  options.only = name;
  const std::vector<StabilityCase> cases = stability_cases(options);
  EXPECT_FALSE(cases.empty()) << name;
  for (const StabilityCase& one : cases) {
    const StabilityRow row = try_case(one);
    EXPECT_TRUE(row.as_expected) << row.family << ": " << row.name << ": in double "
                                 << name_of(row.in_double.ending) << ' ' << row.in_double.residual
                                 << " growth " << row.in_double.growth << " for " << row.growth << ' '
                                 << row.in_double.said << "; in single " << name_of(row.in_single.ending)
                                 << ' ' << row.in_single.residual << ' ' << row.in_single.said;
  }
}

TEST(StiffAndExtremeCases, OfTheStepComeToWhatTheyMust) { expect_family("step"); }
TEST(StiffAndExtremeCases, OfBetaComeToWhatTheyMust) { expect_family("beta"); }
TEST(StiffAndExtremeCases, OfDampingComeToWhatTheyMust) { expect_family("damping"); }
TEST(StiffAndExtremeCases, OfTheBeamsComeToWhatTheyMust) { expect_family("of the beams"); }
TEST(StiffAndExtremeCases, OfDensityComeToWhatTheyMust) { expect_family("density"); }
TEST(StiffAndExtremeCases, OfUnequalRadiiComeToWhatTheyMust) { expect_family("radii"); }
TEST(StiffAndExtremeCases, OfPreStrainComeToWhatTheyMust) { expect_family("pre-strain"); }
TEST(StiffAndExtremeCases, OfPathsComeToWhatTheyMust) { expect_family("crack path"); }
TEST(StiffAndExtremeCases, OfSmallLatticesComeToWhatTheyMust) { expect_family("small lattices"); }

// The suite's own expectation, against what is known otherwise.
TEST(HighestMode, IsWhatLanczosFindsAndNothingTheElementBoundForbids) {
  const lattice::Lattice block = small_block(4, 4, 2);
  const lattice::StableStep stable = lattice::stable_step(block);
  const double exact = 2.0 / lattice::highest_mode(block).omega;
  EXPECT_NEAR(stable.critical / exact, 1.0, 2e-5);
  EXPECT_LT(stable.critical, exact);
  EXPECT_LT(stable.element_bound, exact);
}

TEST(Suite, SeesThatACaseIsNotAsExpected) {
  StabilityCase one{"f", "c", CaseEnd::closes, std::nan(""), "", [](ensemble::Precision) {
                      Observed seen;
                      seen.ending = CaseEnd::diverges;
                      return seen;
                    }};
  EXPECT_FALSE(try_case(one).as_expected);
  one.expected = CaseEnd::diverges;
  EXPECT_TRUE(try_case(one).as_expected);
  one.growth = 0.1;  // and none was seen
  EXPECT_FALSE(try_case(one).as_expected);
}

TEST(Suite, ACaseThatClosesButShowsAnotherNumberIsNotAsExpected) {
  StabilityCase one{"f", "c", CaseEnd::closes, std::nan(""), "", [](ensemble::Precision) {
                      Observed seen;
                      seen.ending = CaseEnd::closes;
                      seen.ratio = 0.5;
                      return seen;
                    }};
  const auto expect = [&](double low, double high, double factor) {
    one.claims = [=](const Observed& seen, ensemble::Precision) {
      return std::vector<Claim>{{"ratio", low, high, factor * seen.ratio}};
    };
    return try_case(one).as_expected;
  };
  EXPECT_TRUE(expect(0.5, 0.5, 1.0));
  EXPECT_FALSE(expect(0.6, 0.7, 1.0));
  EXPECT_FALSE(expect(0.0, 1.0, std::nan("")));
}

TEST(Suite, ARatioThatSinglePrecisionChangesIsNotAsExpected) {
  StabilityCase one{"f", "c", CaseEnd::closes, std::nan(""), "", [](ensemble::Precision precision) {
                      Observed seen;
                      seen.ending = CaseEnd::closes;
                      seen.ratio = precision == ensemble::Precision::double_precision ? 0.5 : 0.502;
                      return seen;
                    }};
  EXPECT_FALSE(try_case(one).as_expected);
}

TEST(Suite, CountsTheBeamsThatTheTipOfAPlateHasPassed) {
  const Observed seen = crack({}, {}, {}, ensemble::Precision::double_precision);
  ASSERT_EQ(seen.claims.size(), 1U);
  EXPECT_EQ(seen.claims[0].what, "beams released");
  EXPECT_GT(seen.claims[0].low, 20.0);
  EXPECT_EQ(seen.claims[0].low, seen.claims[0].high);
  EXPECT_TRUE(seen.claims[0].holds());
}

TEST(Suite, ARefusalMustSayWhy) {
  StabilityCase one{"f", "c", CaseEnd::refused, std::nan(""), "the limit is", [](ensemble::Precision) {
                      Observed seen;
                      seen.ending = CaseEnd::refused;
                      seen.said = "no";
                      return seen;
                    }};
  EXPECT_FALSE(try_case(one).as_expected);
}

TEST(Suite, ADivergenceMustBeCaughtInTime) {
  StabilityCase one{"f", "c", CaseEnd::diverges, std::nan(""), "", [](ensemble::Precision) {
                      Observed seen;
                      seen.ending = CaseEnd::diverges;
                      seen.caught_within = caught_at_most + 1;
                      return seen;
                    }};
  EXPECT_FALSE(try_case(one).as_expected);
}

// With samples far apart the march itself looks.
TEST(Divergence, IsCaughtBetweenTwoSamplesByStepElementBeamAndLane) {
  scene::Preset preset = plate_preset({"crack.velocity=0.005 c_r", "crack.end=22 mm", "output.samples=10"});
  ASSERT_TRUE(preset.issues.empty());
  simulation::Prepared p = simulation::prepare(preset, {preset.scene, preset.scene}, shared_cache());
  force_step(p, 1.01 * p.stable.critical);
  const simulation::RunResult result = simulation::march(p, {});
  EXPECT_EQ(result.outcome, simulation::Outcome::diverged);
  for (int lane = 0; lane < 2; ++lane) {
    const simulation::LaneResult& r = result.lane[lane];
    EXPECT_GT(p.lane[lane].schedule.samples[1], 128);
    EXPECT_LE(r.steps - r.last_good_step, 200);
    EXPECT_LT(r.steps, p.lane[lane].schedule.samples[1]);
    EXPECT_TRUE(
        r.where.starts_with("step " + std::to_string(r.steps) + ", lane " + std::to_string(lane) + ": "))
        << r.where;
    EXPECT_NE(r.where.find(" element "), std::string::npos) << r.where;
    EXPECT_NE(r.where.find("its most strained beam is "), std::string::npos) << r.where;
    EXPECT_EQ(r.samples.back().step, r.steps);  // the row that tells why is kept
  }
}

}  // namespace
}  // namespace rift::stability
