#include "studio/workbench/live_run.hpp"

#include "engine/results/archive.hpp"
#include "engine/results/journal_index.hpp"
#include "engine/scene/scenarios.hpp"
#include "studio/screen/live_parts.hpp"
#include "tests/engine/simulation/small_plate.hpp"
#include "tests/expectations.hpp"

#include <chrono>
#include <thread>

namespace rift::studio {
namespace {

using namespace std::chrono_literals;

template <class Condition>
bool soon(const Condition& condition) {
  for (int k = 0; k < 500; ++k) {
    if (condition()) return true;
    std::this_thread::sleep_for(10ms);
  }
  return false;
}

/// A run in slow motion, so that there is time to steer it.
struct Slow {
  TemporaryFolder folder;
  std::optional<LiveRun> run;
  Live live;

  explicit Slow(const std::vector<std::string>& overrides = {}, bool paused = true) {
    RunRequest request{.preset = simulation::small_preset(overrides), .folder = folder.path() / "run"};
    request.cache = shared_cache();
    run.emplace(std::move(request));
    if (paused) run->pause(true);
  }
  bool look_until(const std::string& state) {
    return soon([&] {
      run->look(live, {0});
      return live.state == state;
    });
  }
  std::int64_t step() {
    run->look(live, {0});
    return live.step;
  }
};

TEST(LiveRun, MarchesToItsEndAndGivesTheSameBooksAsAPlainRun) {
  Slow slow({}, false);
  const auto recorded = slow.run->result();
  ASSERT_TRUE(recorded);
  EXPECT_EQ(recorded->result.outcome, simulation::Outcome::finished);
  const simulation::RunResult plain = simulation::march(simulation::small_plate(), {});
  ASSERT_EQ(recorded->result.lane[0].samples.size(), plain.lane[0].samples.size());
  EXPECT_EQ(recorded->result.lane[0].samples.back().elastic_j, plain.lane[0].samples.back().elastic_j);
  EXPECT_TRUE(slow.look_until("finished"));
  EXPECT_EQ(slow.live.done, 1);
  EXPECT_EQ(slow.live.lanes.at(0).samples.size(), plain.lane[0].samples.size());
  EXPECT_FALSE(slow.live.lanes[0].rates.empty());
}

TEST(LiveRun, PauseHoldsItAndASingleStepIsOne) {
  Slow slow;
  ASSERT_TRUE(slow.look_until("paused"));
  ASSERT_TRUE(soon([&] { return slow.step() == 1; }));  // asked after its first step
  std::this_thread::sleep_for(200ms);
  EXPECT_EQ(slow.step(), 1);
  for (int k = 2; k <= 4; ++k) {
    slow.run->single_step();
    EXPECT_TRUE(soon([&] { return slow.step() == k; })) << k << ": " << slow.live.step;
    std::this_thread::sleep_for(100ms);
    EXPECT_EQ(slow.step(), k);
  }
  EXPECT_FALSE(slow.live.lanes[0].displacement.empty());
  EXPECT_EQ(slow.live.lanes[0].samples.back().step, 4);
  slow.run->pause(false);
  EXPECT_TRUE(slow.look_until("finished"));
}

TEST(LiveRun, SlowMotionTakesItsTime) {
  Slow slow;
  slow.run->change_speed(-1);
  slow.run->change_speed(-1);  // 100 steps a second
  slow.run->pause(false);
  ASSERT_TRUE(slow.look_until("100 steps/s"));
  const std::int64_t before = slow.step();
  std::this_thread::sleep_for(600ms);
  const std::int64_t after = slow.step();
  EXPECT_GT(after, before);
  EXPECT_LT(after, before + 90);
  slow.run->change_speed(5);
  EXPECT_TRUE(slow.look_until("finished"));
}

TEST(LiveRun, AChangeIsToldKeptAndRepeatable) {
  Slow slow({"crack.velocity=0.4 c_r"});
  ASSERT_TRUE(soon([&] { return slow.step() == 1; }));
  for (int k = 0; k < 20; ++k) slow.run->single_step();
  ASSERT_TRUE(soon([&] { return slow.step() == 21; }));
  slow.run->change({0, 0, "damage_zone_ratio", "4"});
  ASSERT_TRUE(soon([&] {
    (void)slow.step();
    return slow.live.message.find("kept in steering.toml") != std::string::npos;
  })) << slow.live.message;
  EXPECT_NE(slow.live.message.find("step 21"), std::string::npos) << slow.live.message;
  EXPECT_EQ(slow.step(), 21);  // it waits on
  EXPECT_EQ(slow.run->scene(0).crack.damage_zone_ratio, 4);
  slow.run->change({0, 0, "damage_zone_ratio", "-4"});
  EXPECT_TRUE(soon([&] {
    (void)slow.step();
    return slow.live.message.find("is refused") != std::string::npos;
  }));
  slow.run->pause(false);
  const auto recorded = slow.run->result();
  ASSERT_TRUE(recorded);
  const scene::Preset again = scene::read_preset(slow.run->folder() / results::steering_name);
  EXPECT_TRUE(again.issues.empty());
  ASSERT_EQ(again.steering.size(), 1U);
  const simulation::RunResult replayed = simulation::march(simulation::prepare(again, shared_cache()), {});
  EXPECT_EQ(replayed.lane[0].samples.back().elastic_j, recorded->result.lane[0].samples.back().elastic_j);
  EXPECT_EQ(recorded->summary.at("scenarios")[0].at("steering")[0].at("step"), 21);
}

TEST(LiveRun, AChangeThatChangesNothingIsNotKept) {
  Slow slow({"crack.velocity=0.4 c_r", "damping.alpha=0.001", "damping.region=surface"});
  ASSERT_TRUE(soon([&] { return slow.step() == 1; }));
  const auto says = [&](const std::string& part) {
    return soon([&] {
      (void)slow.step();
      return slow.live.message.find(part) != std::string::npos;
    });
  };
  for (const std::string_view axis : not_empty(scene::steerable_axes())) {
    const std::string now = scene::axis_text(slow.run->scene(0), *scene::find_axis(axis));
    slow.run->change({0, 0, std::string(axis), now});
    EXPECT_TRUE(says(std::string(axis) + " is " + now + " already")) << axis << ": " << slow.live.message;
  }
  slow.run->change({0, 0, "relaxation", "1"});  // another word for linear
  EXPECT_TRUE(says("relaxation is 1 already")) << slow.live.message;
  EXPECT_FALSE(std::filesystem::exists(slow.run->folder() / results::steering_name));
  slow.run->change({0, 0, "crack_velocity", "0.3 c_r"});
  EXPECT_TRUE(says("kept in steering.toml")) << slow.live.message;
  slow.run->change({0, 0, "crack_velocity", "0.4 c_r"});  // back again: a change
  EXPECT_TRUE(says("crack_velocity = 0.4 c_r; kept")) << slow.live.message;
  slow.run->pause(false);
  const auto recorded = slow.run->result();
  ASSERT_TRUE(recorded);
  EXPECT_EQ(recorded->summary.at("scenarios")[0].at("steering").size(), 2U);
}

TEST(LiveRun, AVelocityThatIsStillToComeIsAChange) {
  Slow slow({"crack.velocity=0.4 c_r until 6 mm, 0.3 c_r"});
  ASSERT_TRUE(soon([&] { return slow.step() == 1; }));
  slow.run->change({0, 0, "crack_velocity", "0.3 c_r"});
  EXPECT_TRUE(soon([&] {
    (void)slow.step();
    return slow.live.message.find("kept in steering.toml") != std::string::npos;
  })) << slow.live.message;
  slow.run->stop();
}

TEST(LiveRun, ShowsTheRatioOfItsSummary) {
  Slow slow({}, false);
  const auto recorded = slow.run->result();
  ASSERT_TRUE(recorded);
  ASSERT_TRUE(slow.look_until("finished"));
  const LiveLane& lane = slow.live.lanes.at(0);
  ASSERT_TRUE(lane.ended);
  const double ratio = recorded->summary.at("scenarios")[0].at("ratio");
  EXPECT_EQ(lane.ended->ratio, ratio);
  const auto passed = ratio_so_far(lane);
  ASSERT_TRUE(passed && passed->complete);
  EXPECT_NEAR(passed->mean, ratio, 1e-12);  // the same rows, by the same formula
}

TEST(LiveRun, AFrameThatIsAskedForIsInTheJournalWhenItSaysSo) {
  Slow slow;
  ASSERT_TRUE(soon([&] { return slow.step() == 1; }));
  const auto frames = [&] {
    return results::JournalIndex(slow.run->folder() / results::journal_name).frames(0).size();
  };
  const std::size_t before = frames();
  slow.run->store_frame();
  EXPECT_TRUE(soon([&] { return slow.run->stored(); }));
  EXPECT_EQ(frames(), before + 1);
  slow.run->store_frame();  // of the same step: it is there already
  EXPECT_TRUE(soon([&] { return slow.run->stored(); }));
  EXPECT_EQ(frames(), before + 1);
  slow.run->pause(false);
  ASSERT_TRUE(slow.run->result());
}

TEST(LiveRun, StoppedItKeepsWhatThereIs) {
  Slow slow;
  ASSERT_TRUE(soon([&] { return slow.step() == 1; }));
  slow.run->stop();
  const auto recorded = slow.run->result();
  ASSERT_TRUE(recorded);
  EXPECT_EQ(recorded->result.outcome, simulation::Outcome::stopped);
  EXPECT_TRUE(std::filesystem::exists(slow.run->folder() / results::summary_name));
  EXPECT_TRUE(slow.look_until("stopped"));
}

TEST(LiveRun, StoppedBeforeItsFirstStepItLeavesNoFolder) {
  TemporaryFolder folder;
  {
    RunRequest request{.preset = simulation::small_preset({"specimen.elements=4000"}),
                       .folder = folder.path() / "run"};
    LiveRun run(std::move(request));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "run"));
    run.stop();
    EXPECT_FALSE(run.result());
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "run"));
}

TEST(LiveRun, AFailureIsToldWhereTheResultIsAskedFor) {
  TemporaryFolder folder;
  RunRequest request{.preset = simulation::small_preset({"specimen.coordination=6.9"}),
                     .folder = folder.path() / "run"};
  LiveRun run(std::move(request));
  EXPECT_THROW((void)run.result(), scene::InputError);
  Live live;
  run.look(live, {0});
  EXPECT_EQ(live.state, "failed");
}

}  // namespace
}  // namespace rift::studio
