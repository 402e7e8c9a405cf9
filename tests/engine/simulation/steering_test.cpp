#include "engine/scene/issue.hpp"
#include "engine/simulation/march.hpp"
#include "engine/simulation/summary.hpp"
#include "tests/engine/simulation/small_plate.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace rift::simulation {
namespace {

/// Marches and makes each change at the first question after the lane's step has passed it.
struct Steered {
  RunResult result;
  std::vector<scene::Change> made;
  std::vector<std::string> refused;
};

Steered steered(const Prepared& p, std::vector<scene::Change> wishes) {
  Steered s;
  Observer observer;
  std::size_t next = 0;
  observer.steer = [&](const RunSnapshot& moment) {
    SteeringCommands orders;
    orders.steps = 1;
    if (next < wishes.size() && moment.progress.step >= wishes[next].step)
      orders.changes.push_back(wishes[next++]);
    return orders;
  };
  observer.changed = [&](const scene::Change& change, const std::string& why) {
    if (why.empty())
      s.made.push_back(change);
    else
      s.refused.push_back(why);
  };
  s.result = march(p, observer, {.threads = 1});
  return s;
}

void expect_same_books(const RunResult& a, const RunResult& b) {
  ASSERT_FALSE(a.lane[0].samples.empty());
  ASSERT_EQ(a.lane[0].samples.size(), b.lane[0].samples.size());
  for (std::size_t k = 0; k < a.lane[0].samples.size(); ++k) {
    EXPECT_EQ(a.lane[0].samples[k].step, b.lane[0].samples[k].step);
    EXPECT_EQ(a.lane[0].samples[k].elastic_j, b.lane[0].samples[k].elastic_j) << k;
    EXPECT_EQ(a.lane[0].samples[k].fracture_j, b.lane[0].samples[k].fracture_j) << k;
    EXPECT_EQ(a.lane[0].samples[k].tip_m, b.lane[0].samples[k].tip_m) << k;
  }
}

// The clock decides at which step a question comes, and the first one comes after a twentieth of a second: a
// wish for step 1 is made at whatever step that is.
TEST(Steering, AnsweredChangesAreMadeAndTheBooksStillClose) {
  for (const auto& [axis, value] : {std::pair{"damage_zone_ratio", "3"},
                                    {"relaxation", "quadratic"},
                                    {"technique", "simple"},
                                    {"damping_alpha", "0.05"},
                                    {"crack_velocity", "0.2 c_r"}}) {
    const Prepared p = small_plate({"crack.velocity=0.4 c_r"});
    const std::int64_t half = p.lane[0].schedule.total() / 3;
    const Steered s = steered(p, {{0, half, axis, value}});
    ASSERT_EQ(s.made.size(), 1U) << axis << (s.refused.empty() ? "" : ": " + s.refused[0]);
    EXPECT_EQ(s.made[0].step, half) << axis;
    EXPECT_EQ(s.result.outcome, Outcome::finished) << axis;
    EXPECT_LT(s.result.lane[0].worst_residual, 1e-10) << axis;
    const RunResult plain = march(p, {}, {.threads = 1});
    EXPECT_NE(plain.lane[0].samples.back().elastic_j, s.result.lane[0].samples.back().elastic_j) << axis;
  }
}

TEST(Steering, ReplayGivesTheSameBits) {
  const std::vector<std::string> settings{"crack.velocity=0.4 c_r"};
  const Prepared p = small_plate(settings);
  const std::int64_t total = p.lane[0].schedule.total();
  const Steered s = steered(p, {{0, total / 5, "damage_zone_ratio", "7"},
                                {0, total / 4, "damping_alpha", "0.05"},
                                {0, total / 3, "crack_velocity", "0.25 c_r"},
                                {0, total / 2, "relaxation", "square-root"}});
  ASSERT_EQ(s.made.size(), 4U);
  Prepared again = small_plate(settings);
  again.preset.steering = scene::read_preset_text(scene::steering_text(s.made), "replay").steering;
  ASSERT_EQ(again.preset.steering, s.made);
  const RunResult replayed = march(again, {}, {.threads = 2});
  expect_same_books(s.result, replayed);
  EXPECT_EQ(replayed.lane[0].changes, s.made);
}

TEST(Steering, AChangeOfVelocityMovesTheTipFromThatStepOn) {
  const Prepared p = small_plate({"crack.velocity=0.4 c_r"});
  const std::int64_t half = p.lane[0].schedule.total() / 2;
  const Steered s = steered(p, {{0, half, "crack_velocity", "0.1 c_r"}});
  const auto& samples = s.result.lane[0].samples;
  EXPECT_NEAR(samples.back().velocity_m_s / samples.front().velocity_m_s, 0.25, 1e-12);
  const LanePlan& lane = s.result.steered[0];
  EXPECT_NEAR(samples.back().tip_m, lane.crack_end, p.step.dt * samples.back().velocity_m_s);
  EXPECT_GT(s.result.lane[0].steps, p.lane[0].schedule.total() * 2);
  ASSERT_EQ(lane.scene.crack.velocity.size(), 2U);
  ASSERT_GT(samples.size(), 1U);
  for (std::size_t k = 1; k < samples.size(); ++k) EXPECT_GT(samples[k].step, samples[k - 1].step);
}

// Beams that the damage zone has reached keep their law, so that a longer zone damages nothing in one jump.
TEST(Steering, ALongerZoneNeverSoftensABeamInOneJump) {
  fracture::LaneScenario scenario{.history = history::history_of(0, {{1.0, 100.0}}),
                                  .law = {fracture::Technique::progressive, 1.0, 2.0}};
  fracture::change_law(scenario, {fracture::Technique::progressive, 1.0, 6.0}, 10.0);
  for (double s = 10.0; s < 30.0; s += 0.1) {
    const double before = fracture::stiffness_left({fracture::Technique::progressive, 1.0, 2.0}, 10.0, s);
    EXPECT_EQ(fracture::stiffness_left(fracture::law_at(scenario, s), 10.0, s), before) << s;
  }
  EXPECT_EQ(fracture::law_at(scenario, 15.9).zone_length, 2.0);
  EXPECT_EQ(fracture::law_at(scenario, 16.0).zone_length, 6.0);
  EXPECT_EQ(fracture::reach_ahead(scenario, 10.0), 6.0);
  fracture::change_law(scenario, {fracture::Technique::progressive, 1.0, 1.0}, 11.0);
  EXPECT_EQ(fracture::law_at(scenario, 16.5).zone_length, 6.0);
  EXPECT_EQ(fracture::law_at(scenario, 17.1).zone_length, 1.0);
  EXPECT_EQ(fracture::reach_ahead(scenario, 20.0), 1.0);
}

TEST(Steering, RefusesWhatCannotBe) {
  const Prepared p = small_plate({"crack.technique=simple", "crack.velocity=0.4 c_r"});
  const Steered s = steered(p, {{0, 1, "damage_zone_ratio", "3"},
                                {0, 1, "damping_alpha", "3"},
                                {0, 1, "crack_velocity", "5 c_r"},
                                {7, 1, "crack_velocity", "0.5 c_r"},
                                {0, 1, "seed", "2"}});
  ASSERT_EQ(s.refused.size(), 5U);
  EXPECT_NE(s.refused[0].find("simple release"), std::string::npos);
  EXPECT_NE(s.refused[1].find("must lie in"), std::string::npos) << s.refused[1];
  EXPECT_NE(s.refused[2].find("(0, 2] c_r"), std::string::npos);
  EXPECT_NE(s.refused[3].find("is not running"), std::string::npos);
  EXPECT_NE(s.refused[4].find("cannot be steered"), std::string::npos);
  EXPECT_TRUE(s.made.empty());
}

TEST(Steering, ADampingThatTheStepCannotBearIsRefusedWithTheLimit) {
  const Prepared p = small_plate({"solver.dt_fraction=0.95", "crack.velocity=0.4 c_r"});
  const Steered s = steered(p, {{0, 1, "damping_alpha", "0.9"}});
  ASSERT_EQ(s.refused.size(), 1U);
  EXPECT_NE(s.refused[0].find("needs steps below"), std::string::npos) << s.refused[0];
  EXPECT_EQ(s.result.outcome, Outcome::finished);
}

TEST(Steering, WaitingForOrdersIsNotMarching) {
  const Prepared p = small_plate();
  Observer observer;
  bool waited = false;
  observer.steer = [&](const RunSnapshot& moment) {
    if (!waited) std::this_thread::sleep_for(std::chrono::milliseconds(700));
    waited = true;
    EXPECT_EQ(moment.frame(0, true)->displacement.size(), p.lattice.centre.size());
    EXPECT_EQ(moment.frame(0, true)->velocity.size(), p.lattice.centre.size());
    EXPECT_TRUE(moment.frame(0, false)->velocity.empty());
    EXPECT_EQ(moment.sample(0)->lane, 0);
    EXPECT_FALSE(moment.sample(3).has_value());
    return SteeringCommands{.steps = 1};
  };
  const auto start = std::chrono::steady_clock::now();
  const RunResult result = march(p, observer);
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ASSERT_TRUE(waited);
  EXPECT_LT(result.wall_fracture_s, wall - 0.69);
}

TEST(Steering, APlateauThatWasSteeredIsNone) {
  const Prepared p = small_plate({"crack.velocity=0.4 c_r"});
  const LanePlan& lane = p.lane[0];
  const double middle = 0.5 * (lane.window[0] + lane.window[1]);
  const auto step =
      static_cast<std::int64_t>(history::time_of_arrival(lane.scenario.history, middle) / p.step.dt);
  for (const auto& [at, reached] : {std::pair{step, false}, {std::int64_t{2}, true}}) {
    const Steered s = steered(p, {{0, at, "relaxation", "quadratic"}});
    Prepared now = p;
    now.lane = s.result.steered;
    EXPECT_EQ(rates_of(now, s.result, 0).plateau.reached, reached) << at;
  }
}

TEST(Steering, AChangeThatNeverComesIsRefusedBeforeTheFirstStep) {
  const std::int64_t total = small_plate({"crack.velocity=0.4 c_r"}).lane[0].schedule.total();
  Prepared p = small_plate({"crack.velocity=0.4 c_r"});
  p.preset.steering = {{0, total, "relaxation", "quadratic"}};
  bool began = false;
  EXPECT_THROW(march(p, {.sample = [&](const results::Sample&) { began = true; }}), scene::InputError);
  EXPECT_FALSE(began);
  p.preset.steering = {{0, 10, "crack_velocity", "0.2 c_r"}, {0, total, "relaxation", "quadratic"}};
  EXPECT_EQ(march(p, {}).lane[0].changes.size(), 2U);
  p.preset.steering = {{0, 10, "crack_velocity", "0.2 c_r"}, {0, 100 * total, "relaxation", "quadratic"}};
  EXPECT_THROW(march(p, {}), scene::InputError);
}

TEST(SteeringText, MistakesAreNamedByLineAndKey) {
  const scene::Preset preset = scene::read_preset_text(
      "[[steering]]\nlane = 4\nstep = -1\ndamping_alpha = 7\n[[steering]]\nstep = 5\nseed = 3\n"
      "[[steering]]\nrelaxation = \"linear\"\n[[steering]]\nstep = 4\n",
      "x.toml");
  std::string all;
  for (const scene::Issue& issue : preset.issues) all += scene::to_text(issue) + "\n";
  EXPECT_NE(all.find("x.toml:2: steering.lane = 4: must be a whole number in [0, 0]"), std::string::npos)
      << all;
  EXPECT_NE(all.find("x.toml:3: steering.step = -1"), std::string::npos) << all;
  EXPECT_NE(all.find("x.toml:4: steering.damping_alpha = 7"), std::string::npos) << all;
  EXPECT_NE(all.find("x.toml:7: steering.seed = 3: cannot be steered"), std::string::npos) << all;
  EXPECT_NE(all.find("x.toml:8: steering.step: is missing"), std::string::npos) << all;
  EXPECT_NE(all.find("x.toml:10: steering: changes nothing"), std::string::npos) << all;
}

TEST(SteeringText, AStudyIsNotSteered) {
  const scene::Preset preset = scene::read_preset_text(
      "[study]\nseed = [1, 2]\n[[steering]]\nstep = 1\nrelaxation = \"linear\"\n", "x.toml");
  ASSERT_EQ(preset.issues.size(), 1U);
  EXPECT_NE(scene::to_text(preset.issues[0]).find("a study is not steered"), std::string::npos);
}

}  // namespace
}  // namespace rift::simulation
