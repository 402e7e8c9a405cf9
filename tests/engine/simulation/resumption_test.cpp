#include "engine/results/checkpoint.hpp"
#include "engine/simulation/march.hpp"
#include "tests/engine/simulation/small_plate.hpp"

#include <nlohmann/json.hpp>

namespace rift::simulation {
namespace {

/// Marches until about `steps` of all lanes are done, and keeps what is needed to go on.
Resumption stopped_at(const Prepared& p, std::int64_t steps, const MarchOptions& options = {}) {
  Resumption from;
  Observer observer;
  observer.steer = [&](const RunSnapshot& moment) {
    SteeringCommands orders;
    orders.steps = 1;
    orders.stop = moment.progress.step >= steps;
    return orders;
  };
  observer.sample = [&](const results::Sample& s) { from.samples.push_back(s); };
  bool last = false;
  observer.checkpoint = [&](const std::function<results::Checkpoint()>& make, CheckpointMoment moment) {
    if (moment == CheckpointMoment::before_stop) from.checkpoint = make(), last = true;
  };
  EXPECT_EQ(march(p, observer, options).outcome, Outcome::stopped);
  EXPECT_TRUE(last);
  return from;
}

void expect_same(const RunResult& a, const RunResult& b) {
  ASSERT_FALSE(a.lane.empty());
  ASSERT_EQ(a.lane.size(), b.lane.size());
  EXPECT_EQ(a.outcome, b.outcome);
  EXPECT_EQ(a.lane_steps, b.lane_steps);
  for (std::size_t k = 0; k < a.lane.size(); ++k) {
    const LaneResult &x = a.lane[k], &y = b.lane[k];
    EXPECT_EQ(x.steps, y.steps);
    EXPECT_EQ(x.worst_residual, y.worst_residual);
    EXPECT_EQ(x.energy_at_crack_start, y.energy_at_crack_start);
    EXPECT_EQ(x.wake.kinetic_j, y.wake.kinetic_j);
    ASSERT_FALSE(x.samples.empty());
    ASSERT_EQ(x.samples.size(), y.samples.size());
    for (std::size_t n = 0; n < x.samples.size(); ++n) {
      EXPECT_EQ(x.samples[n].step, y.samples[n].step);
      for (double results::Sample::*column :
           {&results::Sample::elastic_j, &results::Sample::kinetic_translation_j,
            &results::Sample::kinetic_rotation_j, &results::Sample::step_correction_j,
            &results::Sample::fracture_j, &results::Sample::damping_j, &results::Sample::numerical_damping_j,
            &results::Sample::work_external_j, &results::Sample::residual})
        ASSERT_EQ(x.samples[n].*column, y.samples[n].*column) << "lane " << k << ", row " << n;
    }
  }
}

TEST(Resumption, GoesOnToTheSameBitsInEveryKindOfScene) {
  const std::vector<std::vector<std::string>> scenes{
      {},
      {"crack.technique=simple"},
      {"damping.alpha=0.05", "damping.region=surface"},
      {"damping.alpha=0.02", "damping.region=all"},
      {"solver.beta=0.98"},
      {"solver.kinematics=corotational"},
      {"solver.precision=single"},
      {"crack.friction=0.3", "loading.displacement=-0.6 mm", "loading.shear=-2"},
      {"loading.curve=[[0, \"0.6 mm\"], [\"4 us\", \"0.6 mm\"], [\"12 us\", \"0.7 mm\"]]"},
      {"crack.friction=0.3", "loading.shear=3", "damping.alpha=0.02", "damping.region=surface"},
      {"loading.method=ramp", "loading.ramp_steps=300", "loading.hold_steps=100",
       "loading.displacement=0.1 mm"},
      {"loading.method=ramp", "loading.ramp_steps=300", "loading.hold_steps=100",
       "loading.displacement=0.1 mm", "damping.alpha=0.02", "damping.region=surface"},
      {"loading.method=ramp", "loading.ramp_steps=300", "loading.hold_steps=100",
       "loading.displacement=0.1 mm", "solver.kinematics=corotational"},
      {"loading.method=ramp", "loading.ramp_steps=300", "loading.hold_steps=100",
       "loading.displacement=0.1 mm", "solver.precision=single"},
      {"fracture.law=cohesive", "fracture.release_rate=2 kJ/m2", "fracture.strength=200 MPa",
       "fracture.duration=30 us", "crack.start=12 mm", "loading.traction=13 MPa"},
  };
  for (const auto& scene : scenes) {
    const Prepared p = small_plate(scene);
    const RunResult whole = march(p, {}, {.threads = 2});
    const LanePlan& lane = p.lane[0];
    const auto steps_of = [&](double part) {
      return lane.schedule.crack_start() +
             static_cast<std::int64_t>(part * static_cast<double>(lane.schedule.fracture));
    };
    std::vector<std::int64_t> moments{steps_of(0.1), steps_of(0.6)};
    if (lane.schedule.ramp >
        0)  // while it pulls, as the grip comes to rest, while it holds, as the crack starts
      for (const std::int64_t moment :
           {lane.schedule.ramp / 2, lane.schedule.ramp, lane.schedule.ramp + lane.schedule.hold / 2,
            lane.schedule.crack_start()})
        moments.push_back(moment);
    for (const std::int64_t at : moments) {
      const Resumption from = stopped_at(p, at, {.threads = 1});
      expect_same(whole, march(p, {}, {.threads = 2}, &from));
      if (HasFailure()) FAIL() << (scene.empty() ? "plain" : scene[0]) << " at step " << at;
    }
  }
}

TEST(Resumption, LanesThatHaveEndedAndThoseThatWaitGoOnToo) {
  scene::Preset preset = small_preset();
  std::vector<scene::Scene> lanes;
  for (const double v : {0.9, 0.3, 0.5, 0.7}) {
    lanes.push_back(preset.scene);
    lanes.back().crack.velocity.front().speed.value = v;
  }
  const Prepared p = prepare(preset, lanes, shared_cache());
  std::int64_t total = 0;
  for (const LanePlan& lane : p.lane) total += lane.schedule.total();
  for (const int width : {4, 2}) {
    const RunResult whole = march(p, {}, {.threads = 1, .lanes = width});
    for (const double part : {0.2, 0.5, 0.8}) {
      const Resumption from = stopped_at(p, static_cast<std::int64_t>(part * static_cast<double>(total)),
                                         {.threads = 2, .lanes = width});
      expect_same(whole, march(p, {}, {.threads = 1, .lanes = width}, &from));
      if (HasFailure()) FAIL() << width << " lanes at " << part;
    }
  }
}

TEST(Resumption, ALaneAtItsLastStepMarchesNoFurther) {
  scene::Preset preset = small_preset();
  std::vector<scene::Scene> lanes{preset.scene, preset.scene};
  lanes.front().crack.velocity.front().speed.value = 0.9;
  lanes.back().crack.velocity.front().speed.value = 0.5;
  const Prepared p = prepare(preset, lanes, shared_cache());
  const std::int64_t first = p.lane.front().schedule.total();
  ASSERT_LT(first, p.lane.back().schedule.total());
  const RunResult whole = march(p, {}, {.threads = 1});
  const Resumption from = stopped_at(p, 2 * first, {.threads = 1});
  expect_same(whole, march(p, {}, {.threads = 1}, &from));
}

TEST(March, AStopAfterTheLastStepStopsNothing) {
  const Prepared p = small_plate({});
  Observer observer;
  observer.steer = [&](const RunSnapshot& moment) {
    SteeringCommands orders;
    orders.steps = 1;
    orders.stop = moment.progress.step >= p.lane.front().schedule.total();
    return orders;
  };
  const RunResult stopped = march(p, observer, {.threads = 1});
  EXPECT_EQ(stopped.outcome, Outcome::finished);
  expect_same(march(p, {}, {.threads = 1}), stopped);
}

TEST(Resumption, ASteeredRunGoesOnWithItsChanges) {
  Prepared p = small_plate({"crack.velocity=0.4 c_r"});
  const std::int64_t total = p.lane[0].schedule.total();
  p.preset.steering = {{0, total / 5, "damage_zone_ratio", "6"},
                       {0, total / 4, "damping_alpha", "0.05"},
                       {0, total / 3, "crack_velocity", "0.25 c_r"},
                       {0, total / 2, "relaxation", "quadratic"}};
  const RunResult whole = march(p, {});
  for (const double part : {0.2, 0.3, 0.45, 0.9}) {
    const Resumption from = stopped_at(p, static_cast<std::int64_t>(part * static_cast<double>(total)));
    const RunResult resumed = march(p, {}, {}, &from);
    expect_same(whole, resumed);
    EXPECT_EQ(resumed.lane[0].changes, whole.lane[0].changes);
    if (HasFailure()) FAIL() << part;
  }
}

TEST(Resumption, ACheckpointOfAnotherRunIsRefused) {
  const Prepared p = small_plate();
  Resumption from = stopped_at(p, 50);
  EXPECT_THROW(march(small_plate({"solver.dt_fraction=0.25"}), {}, {}, &from), std::invalid_argument);
  EXPECT_THROW(march(small_plate({"specimen.elements=800"}), {}, {}, &from), std::invalid_argument);
  from.checkpoint.notes = "{}";
  EXPECT_THROW(march(p, {}, {}, &from), std::invalid_argument);
}

TEST(CheckpointFile, ComesBackToTheBitAndIsSealed) {
  const TemporaryFolder folder;
  const results::Checkpoint written{
      R"({"a":1,"b":[0.1]})",
      {{"x", {0.1, -0.0, 1e-308, 3e300}}, {"none", {}}, {"many", std::vector<double>(5000, 0.3)}},
      77};
  results::write_checkpoint(folder.path(), written);
  std::string damaged;
  auto read = results::read_checkpoint(folder.path(), 1000, damaged);
  ASSERT_TRUE(read) << damaged;
  EXPECT_EQ(read->notes, written.notes);
  EXPECT_EQ(read->state, written.state);
  EXPECT_EQ(read->journal_bytes, 77U);
  results::Checkpoint later = written;
  later.journal_bytes = 99;
  results::write_checkpoint(folder.path(), later);
  EXPECT_EQ(results::read_checkpoint(folder.path(), 1000, damaged)->journal_bytes, 99U);
  const std::filesystem::path file = folder.path() / results::checkpoint_name;
  std::string bytes = read_text(file);
  for (const std::size_t at : {std::size_t{20}, bytes.size() / 2, bytes.size() - 3}) {
    std::string broken = bytes;
    broken[at] = static_cast<char>(broken[at] ^ 4);
    write_text(file, broken);
    damaged.clear();
    read = results::read_checkpoint(folder.path(), 1000, damaged);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->journal_bytes, 77U);  // the one before
    EXPECT_NE(damaged.find("checkpoint.h5"), std::string::npos) << damaged;
  }
  write_text(file, bytes.substr(0, bytes.size() / 2));
  EXPECT_EQ(results::read_checkpoint(folder.path(), 1000, damaged)->journal_bytes, 77U);
  results::remove_checkpoints(folder.path());
  EXPECT_FALSE(results::read_checkpoint(folder.path(), 1000, damaged));
}

}  // namespace
}  // namespace rift::simulation
