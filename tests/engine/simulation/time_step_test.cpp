#include "engine/simulation/schedule.hpp"

#include "tests/engine/simulation/small_plate.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rift::simulation {
namespace {

std::string refusal_of_step(const std::vector<std::string>& overrides) {
  try {
    small_plate(overrides);
  } catch (const scene::InputError& error) {
    return error.what();
  }
  return "not refused";
}

TEST(DefaultStep, IsHalfTheCriticalOneWithoutADamageZone) {
  EXPECT_DOUBLE_EQ(default_step(1.4e-7, 0.0, 2200.0), 0.7e-7);
  EXPECT_DOUBLE_EQ(default_step(1.4e-7, 0.49e-3, 220.0), 0.7e-7);  // slow: 5 steps are a small matter
}

TEST(DefaultStep, GivesABeamFiveStepsToSoften) {
  for (const double speed : {220.0, 440.0, 1100.0, 1540.0, 2200.0, 4400.0})
    for (const double zone : {0.1e-3, 0.49e-3, 4e-3}) {
      const double dt = default_step(1.4e-7, zone, speed);
      EXPECT_GE(zone / (speed * dt), 5.0);
      if (dt < 0.7e-7) {
        EXPECT_LT(zone / (speed * 2.0 * dt), 5.0) << "the next rung would do";
      }
    }
}

TEST(DefaultStep, StandsOnTheLadderThatScenariosShare) {
  for (double speed = 100.0; speed < 5000.0; speed *= 1.3) {
    const double rung = std::log2(0.7e-7 / default_step(1.4e-7, 0.3e-3, speed));
    EXPECT_EQ(rung, std::round(rung));
    EXPECT_GE(rung, 0.0);
  }
  EXPECT_DOUBLE_EQ(default_step(1.4e-7, 0.49e-3, 2200.0), 0.35e-7);  // 3.2 steps at the rung above
}

TEST(ChooseStep, TakesTheStepOrTheFractionOfThePreset) {
  const Prepared by_default = small_plate({"crack.technique=simple"});
  EXPECT_DOUBLE_EQ(by_default.step.dt, 0.5 * by_default.step.critical);
  EXPECT_EQ(by_default.step.critical_damped, by_default.step.critical);
  EXPECT_LT(by_default.step.element_bound, by_default.step.critical);
  const Prepared fraction = small_plate({"solver.dt_fraction=0.17"});
  EXPECT_DOUBLE_EQ(fraction.step.dt, 0.17 * fraction.step.critical);
  EXPECT_EQ(small_plate({"solver.dt=2.35e-8"}).step.dt, 2.35e-8);
}

TEST(ChooseStep, RefusesAStepAboveTheCriticalOneWithBothNumbers) {
  const double critical = small_plate().step.critical;
  EXPECT_EQ(
      refusal_of_step({"solver.dt=1e-6"}),
      fmt::format("--set solver.dt=1e-6: makes a step of 1e-06 s, and the critical step of this lattice is "
                  "{:.4g} s",
                  critical));
  EXPECT_EQ(refusal_of_step({fmt::format("solver.dt={}", critical * (1.0 + 1e-9))}).substr(0, 15),
            "--set solver.dt");
  EXPECT_EQ(refusal_of_step({fmt::format("solver.dt={}", critical * (1.0 - 1e-9))}), "not refused");
}

TEST(ChooseStep, RefusesAStepThatOnlyDampingMakesUnstable) {
  const std::vector<std::string> damped{"damping.alpha=0.05", "damping.region=all"};
  const Prepared p = small_plate(damped);
  ASSERT_LT(p.step.critical_damped, 0.99 * p.step.critical);
  EXPECT_EQ(
      refusal_of_step({"solver.dt_fraction=0.999", damped[0], damped[1]}),
      fmt::format("--set solver.dt_fraction=0.999: makes a step of {:.4g} s, and the critical step of this "
                  "lattice with this damping is {:.4g} s ({:.4g} s undamped)",
                  0.999 * p.step.critical, p.step.critical_damped, p.step.critical));
  EXPECT_EQ(refusal_of_step({"solver.dt_fraction=0.999"}), "not refused");
}

// The default step is half the undamped limit; where damping makes even that unstable, alpha is to blame.
TEST(ChooseStep, BlamesTheDampingWhereEvenTheDefaultStepIsTooLong) {
  EXPECT_TRUE(refusal_of_step({"damping.alpha=1", "damping.region=all", "crack.technique=simple"})
                  .starts_with("--set damping.alpha=1: makes a step of "));
}

TEST(ChooseStep, AllowsAStepJustBelowTheDampedLimitAndTheRunStaysBounded) {
  const std::vector<std::string> damped{"damping.alpha=0.05", "damping.region=all"};
  const double limit = small_plate(damped).step.critical_damped;
  const Prepared p = small_plate({damped[0], damped[1], fmt::format("solver.dt={}", 0.999 * limit)});
  const RunResult result = march(p, {});
  EXPECT_EQ(result.outcome, Outcome::finished) << result.lane[0].where;
  EXPECT_LT(result.lane[0].worst_residual, 1e-10);
}

}  // namespace
}  // namespace rift::simulation
