#include "engine/ensemble/instruction_set.hpp"
#include "engine/scene/parameters.hpp"
#include "engine/study/plan.hpp"
#include "tests/expectations.hpp"

#include <gtest/gtest.h>

namespace rift::study {
namespace {

using Steps = std::vector<std::int64_t>;

TEST(Queue, OfOneScenarioHasOneLane) {
  EXPECT_EQ(soonest({1000}, ensemble::Precision::double_precision).lanes, 1);
  EXPECT_EQ(soonest({1000}, ensemble::Precision::single_precision).lanes, 1);
}

// Beside one long scenario the short ones are done in the same time whatever the lanes; each lane more makes
// its steps dearer.
TEST(Queue, OfALongScenarioAndShortOnesHasFewLanes) {
  const Queue queue =
      soonest({100000, 20000, 10000, 5000, 3000, 2000}, ensemble::Precision::single_precision);
  const Queue even = soonest(Steps(6, 100000), ensemble::Precision::single_precision);
  EXPECT_LT(queue.lanes, even.lanes);
  EXPECT_LT(queue.time, even.time);
}

// One more of a length than there are lanes needs a second round.
TEST(Queue, CountsTheLanesThatStandIdleInTheLastRound) {
  const auto time = [](std::size_t scenarios) {
    return soonest(Steps(scenarios, 1000), ensemble::Precision::single_precision).time;
  };
  const auto lanes = static_cast<std::size_t>(lanes_of_many(ensemble::Precision::single_precision));
  EXPECT_EQ(time(2 * lanes), 2.0 * time(lanes));
  EXPECT_GT(time(4 * lanes + 1), 1.1 * time(4 * lanes));
}

TEST(Queue, OfManyFillsAsManyLanesAsAreFastest) {
  for (const ensemble::Precision precision :
       {ensemble::Precision::double_precision, ensemble::Precision::single_precision}) {
    const int lanes = lanes_of_many(precision);
    EXPECT_EQ(soonest(Steps(64, 1000), precision).lanes, lanes);
    EXPECT_GT(lanes, 1);
    EXPECT_LE(lanes, ensemble::lanes_in_register(precision, ensemble::instruction_set()));
  }
}

/// A lane of this step and velocity, damped or not.
simulation::LanePlan lane_of(double dt, double speed,
                             scene::DampingRegion region = scene::DampingRegion::none) {
  simulation::LanePlan lane;
  lane.scene = scene::default_scene();
  lane.scene.damping.region = region;
  lane.step.dt = dt;
  lane.crack_end = 0.08;
  lane.scenario.history = history::history_of(0.0, {{speed, 1.0}});
  return lane;
}

TEST(Passes, HoldScenariosOfOneStepTheLongestFirst) {
  const auto passes =
      passes_of({lane_of(2e-8, 900), lane_of(1e-8, 2000), lane_of(2e-8, 300), lane_of(2e-8, 600)});
  EXPECT_EQ(passes, (std::vector<std::vector<std::size_t>>{{2, 3, 0}, {1}}));
}

TEST(Passes, HoldTheDampedApart) {
  const auto passes = passes_of({lane_of(2e-8, 900), lane_of(2e-8, 800, scene::DampingRegion::surface),
                                 lane_of(2e-8, 700, scene::DampingRegion::all)});
  EXPECT_EQ(passes, (std::vector<std::vector<std::size_t>>{{2, 1}, {0}}));
}

// After a ramp no lane can be filled again.
TEST(Passes, AfterARampHoldNoMoreThanMarchTogether) {
  std::vector<simulation::LanePlan> lanes(20, lane_of(2e-8, 900));
  for (simulation::LanePlan& lane : lanes) lane.scene.loading.method = scene::LoadingMethod::ramp;
  const auto most = static_cast<std::size_t>(lanes_of_many(lanes.front().scene.solver.precision));
  for (const auto& pass : not_empty(passes_of(lanes))) EXPECT_LE(pass.size(), most);
}

}  // namespace
}  // namespace rift::study
