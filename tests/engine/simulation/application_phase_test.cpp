#include "engine/scene/derived.hpp"
#include "engine/simulation/march.hpp"
#include "engine/simulation/steering.hpp"
#include "engine/simulation/summary.hpp"
#include "tests/engine/simulation/small_plate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace rift::simulation {
namespace {

/// A small plate whose crack runs by itself, and what its strip holds [J/m2].
Prepared by_itself(const std::string& toughness, std::vector<std::string> more = {}) {
  more.insert(more.begin(), {"crack.toughness=" + toughness, "crack.velocity=0.2 c_r",
                             "crack.damage_zone_ratio=3", "crack.toughness_window=8"});
  return small_plate(more);
}

double stored() { return small_plate({}).scale.g_i0; }

TEST(OwnWay, KeepsToTheVelocityAtWhichWhatIsReleasedIsWhatIsWithstood) {
  const double g = stored();
  // Steep enough for the root to stay within some hundredths of 0.4 c_r.
  const Prepared p =
      by_itself(fmt::format("[[\"0.35 c_r\", \"{} J/m2\"], [\"0.45 c_r\", \"{} J/m2\"]]", 0.3 * g, 1.3 * g));
  const RunResult run = march(p, {}, {.threads = 1});
  ASSERT_EQ(run.outcome, Outcome::finished);
  EXPECT_LT(run.lane[0].worst_residual, 1e-10);
  EXPECT_GT(run.lane[0].changes.size(), 5U);
  const results::Sample& last = run.lane[0].samples.back();
  EXPECT_GE(last.tip_m, scene::crack_end(p.preset.scene) - p.step.dt * last.velocity_m_s);
  double way = 0.0, released = 0.0, slow = 1e9, fast = 0.0;
  for (std::size_t k = 1; k < run.lane[0].samples.size(); ++k) {
    const results::Sample &a = run.lane[0].samples[k - 1], &b = run.lane[0].samples[k];
    if (a.tip_m < p.preset.scene.crack.start + 16.0 * p.lattice.mean_radius) continue;
    slow = std::min(slow, b.velocity_m_s), fast = std::max(fast, b.velocity_m_s);
    way += b.tip_m - a.tip_m, released += b.fracture_j - a.fracture_j;
  }
  EXPECT_GT(slow, 0.34 * p.rayleigh_speed);
  EXPECT_LT(fast, 0.46 * p.rayleigh_speed);
  const double rate = released / (way * p.scale.thickness);
  EXPECT_GT(rate, 0.3 * g);
  EXPECT_LT(rate, 1.3 * g);
}

TEST(OwnWay, IsArrestedWhereTheMaterialWithstandsMoreThanThereIs) {
  const Prepared p = by_itself(fmt::format("[[\"0 m\", \"{} J/m2\"]]", 3.0 * stored()));
  const RunResult run = march(p, {}, {.threads = 1});
  ASSERT_EQ(run.outcome, Outcome::finished);
  const LaneResult& lane = run.lane[0];
  ASSERT_TRUE(std::isfinite(lane.arrested_m));
  // As soon as the window of the release rate is full.
  EXPECT_NEAR(lane.arrested_m, p.preset.scene.crack.start + 8.0 * p.lattice.mean_radius,
              1.4 * p.lattice.mean_radius);
  EXPECT_EQ(lane.samples.back().tip_m, lane.arrested_m);
  EXPECT_EQ(lane.steps, lane.samples.back().step);
}

// 0.8 of what is stored: a steady crack is slow but runs on, and the estimate over one window dips below G_c.
TEST(OwnWay, IsNotArrestedByADipOfItsEstimate) {
  for (const int seed : {1, 2}) {
    const Prepared p =
        by_itself(fmt::format("[[\"0 c_r\", \"{} J/m2\"]]", 0.8 * stored()),
                  {fmt::format("specimen.seed={}", seed), "crack.damage_zone_ratio=1", "crack.end=40 mm"});
    const RunResult run = march(p, {}, {.threads = 1});
    EXPECT_EQ(std::count_if(run.lane[0].changes.begin(), run.lane[0].changes.end(),
                            [](const scene::Change& change) { return change.axis == tip_stops; }),
              0)
        << "seed " << seed;
    EXPECT_TRUE(std::isnan(run.lane[0].arrested_m)) << "seed " << seed << ' ' << run.lane[0].arrested_m;
    EXPECT_LT(run.lane[0].worst_residual, 1e-10);
    EXPECT_GT(run.lane[0].samples.back().tip_m, 39e-3) << "seed " << seed;
  }
}

/// Half of what is stored, and from 14 mm on three times of it.
std::string tough_strip() {
  return fmt::format("[[\"0 m\", \"{} J/m2\"], [\"14 mm\", \"{} J/m2\"], [\"14.1 mm\", \"{} J/m2\"]]",
                     0.5 * stored(), 0.5 * stored(), 3.0 * stored());
}

TEST(OwnWay, IsArrestedInAToughStripAndItsTipRestsThere) {
  const Prepared p = by_itself(tough_strip());
  const RunResult run = march(p, {}, {.threads = 1});
  ASSERT_EQ(run.outcome, Outcome::finished);
  const LaneResult& lane = run.lane[0];
  ASSERT_TRUE(std::isfinite(lane.arrested_m));
  EXPECT_GT(lane.arrested_m, 14e-3);
  EXPECT_LT(lane.arrested_m, 14e-3 + 8.0 * p.lattice.mean_radius);
  EXPECT_EQ(lane.samples.back().tip_m, lane.arrested_m);
  EXPECT_EQ(lane.samples.back().velocity_m_s, 0.0);
  EXPECT_LT(lane.worst_residual, 1e-10);
  // Until the slowest waves have been to the far end and back.
  const results::Sample& stopped = *(lane.samples.end() - 2);
  EXPECT_EQ(stopped.tip_m, lane.arrested_m);
  EXPECT_NEAR(lane.samples.back().time_s - stopped.time_s, 2.0 * 48e-3 / p.rayleigh_speed, 2.0 * p.step.dt);
}

/// The same under a grip that pulls on while the tip rests, to 2.5 times the displacement.
Prepared pulled_on() {
  return by_itself(tough_strip(), {"loading.curve=[[\"0 us\", \"0.6 mm\"], [\"40 us\", \"0.6 mm\"], "
                                   "[\"140 us\", \"1.5 mm\"]]"});
}

TEST(OwnWay, StartsAgainWhereTheLoadRises) {
  const Prepared p = pulled_on();
  const RunResult run = march(p, {}, {.threads = 1});
  ASSERT_EQ(run.outcome, Outcome::finished);
  const LaneResult& lane = run.lane[0];
  EXPECT_LT(lane.worst_residual, 1e-10);
  const auto stop = std::find_if(lane.changes.begin(), lane.changes.end(),
                                 [](const scene::Change& change) { return change.axis == tip_stops; });
  ASSERT_NE(stop, lane.changes.end());
  ASSERT_NE(stop + 1, lane.changes.end());
  EXPECT_EQ((stop + 1)->axis, "crack_velocity");
  // The rate grows with the square of the displacement from what it was at the stop: not more than what is
  // stored, not less than the half that it ran on. So 3 times what is stored is there between sqrt(3) and
  // sqrt(6) of the displacement, 89 and 137 us, and is seen two windows later at most.
  const double restart = static_cast<double>((stop + 1)->step) * p.step.dt;
  EXPECT_GT(restart, 89e-6);
  EXPECT_LT(restart, 137e-6 + 2.0 * 8.0 * p.lattice.mean_radius / p.rayleigh_speed);
  EXPECT_GT(lane.samples.back().tip_m, 20e-3);
}

TEST(OwnWay, GoesOnFromACheckpointOfARestingTipToTheSameBits) {
  const Prepared p = pulled_on();
  const RunResult whole = march(p, {}, {.threads = 1});
  const auto stop = std::find_if(whole.lane[0].changes.begin(), whole.lane[0].changes.end(),
                                 [](const scene::Change& change) { return change.axis == tip_stops; });
  ASSERT_NE(stop, whole.lane[0].changes.end());
  const std::int64_t resting = (stop->step + (stop + 1)->step) / 2;
  Resumption from;
  Observer observer;
  observer.steer = [&](const RunSnapshot& moment) {
    SteeringCommands orders;
    orders.steps = 1;
    orders.stop = moment.progress.step >= resting;
    return orders;
  };
  observer.sample = [&](const results::Sample& s) { from.samples.push_back(s); };
  observer.checkpoint = [&](const auto& make, CheckpointMoment moment) {
    if (moment == CheckpointMoment::before_stop) from.checkpoint = make();
  };
  ASSERT_EQ(march(p, observer, {.threads = 1}).outcome, Outcome::stopped);
  const RunResult again = march(p, {}, {.threads = 1}, &from);
  ASSERT_EQ(again.lane[0].samples.size(), whole.lane[0].samples.size());
  EXPECT_EQ(again.lane[0].changes, whole.lane[0].changes);
  for (std::size_t k = 0; k < whole.lane[0].samples.size(); ++k)
    EXPECT_EQ(again.lane[0].samples[k].fracture_j, whole.lane[0].samples[k].fracture_j);
}

TEST(OwnWay, RunsAtTheHighestVelocityWhereNothingHoldsIt) {
  const Prepared p = by_itself("[[\"0 c_r\", \"1 J/m2\"]]");
  const RunResult run = march(p, {}, {.threads = 1});
  EXPECT_NEAR(run.lane[0].samples.back().velocity_m_s, scene::fastest_by_itself * p.rayleigh_speed, 1e-6);
}

TEST(OwnWay, GoesOnFromACheckpointToTheSameBits) {
  const double g = stored();
  const Prepared p =
      by_itself(fmt::format("[[\"0 c_r\", \"{} J/m2\"], [\"0.9 c_r\", \"{} J/m2\"]]", 0.2 * g, 1.5 * g));
  const RunResult whole = march(p, {}, {.threads = 1});
  Resumption from;
  Observer observer;
  observer.steer = [&](const RunSnapshot& moment) {
    SteeringCommands orders;
    orders.steps = 1;
    orders.stop = moment.progress.step >= whole.lane[0].steps * 2 / 3;
    return orders;
  };
  observer.sample = [&](const results::Sample& s) { from.samples.push_back(s); };
  observer.checkpoint = [&](const auto& make, CheckpointMoment moment) {
    if (moment == CheckpointMoment::before_stop) from.checkpoint = make();
  };
  ASSERT_EQ(march(p, observer, {.threads = 1}).outcome, Outcome::stopped);
  const RunResult again = march(p, {}, {.threads = 1}, &from);
  ASSERT_EQ(again.lane[0].samples.size(), whole.lane[0].samples.size());
  EXPECT_EQ(again.lane[0].changes, whole.lane[0].changes);
  ASSERT_FALSE(whole.lane[0].samples.empty());
  for (std::size_t k = 0; k < whole.lane[0].samples.size(); ++k) {
    EXPECT_EQ(again.lane[0].samples[k].step, whole.lane[0].samples[k].step);
    EXPECT_EQ(again.lane[0].samples[k].fracture_j, whole.lane[0].samples[k].fracture_j);
  }
}

TEST(MeasuredRun, FollowsItsHistoryAndItsPathToTheEnd) {
  const Prepared p =
      small_plate({"crack.history=[[\"5 us\", \"4 mm\"], [\"9 us\", \"7 mm\"], [\"14 us\", \"13 mm\"]]",
                   "crack.smoothing=none", "crack.damage_zone_ratio=2", "crack.end=13 mm"});
  const LanePlan& lane = p.lane[0];
  EXPECT_NEAR(history::tip_at(lane.scenario.history, 0.0), 4e-3 - 2.0 * p.lattice.mean_radius, 1e-12);
  EXPECT_NEAR(lane.lead * 750.0, 2.0 * p.lattice.mean_radius, 1e-9);  // as fast as the history begins
  EXPECT_NEAR(history::tip_at(lane.scenario.history, lane.lead), 4e-3, 1e-12);
  EXPECT_NEAR(history::tip_at(lane.scenario.history, lane.lead + 4e-6), 7e-3, 1e-12);
  const RunResult run = march(p, {}, {.threads = 1});
  EXPECT_EQ(run.outcome, Outcome::finished);
  EXPECT_LT(run.lane[0].worst_residual, 1e-10);
  EXPECT_NEAR(run.lane[0].samples.back().tip_m, 13e-3, p.step.dt * 1300.0);
}

TEST(InclinedRun, ReleasesTheBeamsThatItsPathCrosses) {
  const Prepared p =
      small_plate({"crack.path=[[\"0 mm\", \"4 mm\"], [\"12 mm\", \"7 mm\"], [\"30 mm\", \"9 mm\"]]",
                   "crack.end=20 mm", "output.window=[0.1, 0.4]"});
  const RunResult run = march(p, {}, {.threads = 1});
  EXPECT_EQ(run.outcome, Outcome::finished);
  EXPECT_LT(run.lane[0].worst_residual, 1e-10);
  for (const fracture::Crossing& c : not_empty(fracture::crossings(p.path, p.lattice))) {
    const auto& [i, j] = p.lattice.ends[c.beam];
    const Eigen::Vector2d at = fracture::point_on(p.path, c.position);
    const Eigen::Vector2d a = p.lattice.centre[i].head<2>(), b = p.lattice.centre[j].head<2>();
    EXPECT_LT(std::abs((b - a).x() * (at - a).y() - (b - a).y() * (at - a).x()) / (b - a).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace rift::simulation
