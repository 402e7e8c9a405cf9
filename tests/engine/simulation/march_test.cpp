#include "engine/simulation/march.hpp"

#include "engine/simulation/summary.hpp"
#include "tests/engine/simulation/small_plate.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <map>

namespace rift::simulation {
namespace {

/// All that a run told its observer.
struct Heard {
  std::vector<results::Sample> samples;
  std::vector<results::Frame> frames;
  std::vector<results::ReleaseEvent> events;
  std::vector<Progress> progress;
  std::size_t stop_after = 1000000;  // questions

  Observer observer() {
    return {.sample = [&](const results::Sample& s) { samples.push_back(s); },
            .frame = [&](const results::Frame& f) { frames.push_back(f); },
            .event = [&](const results::ReleaseEvent& e) { events.push_back(e); },
            .go_on =
                [&](const Progress& p) {
                  progress.push_back(p);
                  return progress.size() < stop_after;
                }};
  }
};

TEST(SampleOf, AnEnergyBalanceHoldsEveryTerm) {
  const results::Sample sample = sample_of({.elastic = 70.0,
                                            .kinetic_translation = 16.0,
                                            .kinetic_rotation = 4.0,
                                            .step_correction = 2.0,
                                            .fracture = 20.0,
                                            .damping = 12.0,
                                            .numerical_damping = 5.0,
                                            .contact = 3.0,
                                            .work_external = 24.0,
                                            .error = 0.5});
  EXPECT_EQ(sample.elastic_j, 70.0);
  EXPECT_EQ(sample.kinetic_translation_j, 16.0);
  EXPECT_EQ(sample.kinetic_rotation_j, 4.0);
  EXPECT_EQ(sample.step_correction_j, 2.0);
  EXPECT_EQ(sample.fracture_j, 20.0);
  EXPECT_EQ(sample.damping_j, 12.0);
  EXPECT_EQ(sample.numerical_damping_j, 5.0);
  EXPECT_EQ(sample.contact_j, 3.0);
  EXPECT_EQ(sample.work_external_j, 24.0);
  EXPECT_EQ(sample.residual, 0.5);
}

TEST(March, ReadsTheBooksAtEverySampleOfItsSchedule) {
  const Prepared p = small_plate();
  Heard heard;
  const RunResult result = march(p, heard.observer());
  EXPECT_EQ(result.outcome, Outcome::finished);
  EXPECT_EQ(result.lane[0].steps, p.lane[0].schedule.total());
  ASSERT_GT(heard.samples.size(), 50U);
  ASSERT_EQ(heard.samples.size(), p.lane[0].schedule.samples.size());
  ASSERT_EQ(result.lane[0].samples.size(), p.lane[0].schedule.samples.size());
  for (std::size_t k = 0; k < heard.samples.size(); ++k) {
    const results::Sample& s = heard.samples[k];
    EXPECT_EQ(s.step, p.lane[0].schedule.samples[k]);
    EXPECT_EQ(s.phase, results::Phase::fracture);
    EXPECT_DOUBLE_EQ(s.time_s, static_cast<double>(s.step) * p.step.dt);
    EXPECT_DOUBLE_EQ(s.tip_m, history::tip_at(p.lane[0].scenario.history, s.time_s));
    EXPECT_DOUBLE_EQ(s.velocity_m_s, 1100.0);
  }
  EXPECT_NEAR(result.lane[0].samples.front().elastic_j / p.static_energy, 1.0, 1e-12);
  EXPECT_EQ(result.lane[0].energy_at_crack_start, result.lane[0].samples.front().elastic_j);
  EXPECT_TRUE(rates_of(p, result).plateau.reached);
}

TEST(March, TellsHowManyThreadsItTook) {
  const Prepared p = small_plate();
  for (const int threads : {1, 2}) EXPECT_EQ(march(p, {}, {.threads = threads}).threads, threads);
}

TEST(March, WritesFramesOfTheFieldsAskedFor) {
  const Prepared p = small_plate({"output.fields=[\"displacement\", \"velocity\", \"damage\"]"});
  Heard heard;
  march(p, heard.observer());
  ASSERT_EQ(heard.frames.size(), 5U);
  const std::size_t n = p.lattice.centre.size(), crossed = fracture::crossings(p.path, p.lattice).size();
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(heard.frames[k].step, p.lane[0].schedule.frames[k]);
    EXPECT_EQ(heard.frames[k].displacement.size(), n);
    EXPECT_EQ(heard.frames[k].velocity.size(), n);
    EXPECT_EQ(heard.frames[k].damage_factor.size(), crossed);
  }
  EXPECT_EQ(std::count(heard.frames[0].damage_factor.begin(), heard.frames[0].damage_factor.end(), 1.0F),
            static_cast<long>(crossed));
  EXPECT_GT(std::count(heard.frames[4].damage_factor.begin(), heard.frames[4].damage_factor.end(), 0.0F), 20);
  Heard bare;
  march(small_plate({"output.fields=[]"}), bare.observer());
  for (const auto& frame : not_empty(bare.frames))
    EXPECT_TRUE(frame.displacement.empty() && frame.velocity.empty() && frame.damage_factor.empty());
}

// The energy of the elements of a frame is all of the books' elastic energy, softened beams and those of bulk
// units included.
TEST(March, SpreadsTheElasticEnergyOfItsBooksOverTheElements) {
  for (const char* kinematics : {"linear", "corotational"}) {
    const Prepared p =
        small_plate({"output.fields=[\"energy\"]", "output.samples=400", "material.stiffness=bulk",
                     std::string("solver.kinematics=") + kinematics});
    Heard heard;
    march(p, heard.observer());
    ASSERT_EQ(heard.frames.size(), 5U);
    int compared = 0;
    for (const results::Frame& frame : heard.frames)
      for (const results::Sample& sample : not_empty(heard.samples)) {
        if (sample.step != frame.step) continue;
        double sum = 0;
        for (const float energy : frame.elastic_energy) sum += energy;
        EXPECT_NEAR(sum / sample.elastic_j, 1.0, 1e-6) << kinematics << " at step " << frame.step;
        ++compared;
      }
    EXPECT_GE(compared, 2) << kinematics;
  }
}

// The damage of a frame stands in the order of geometry_of().crossing, ascending beams, not in the crack's.
TEST(March, GivesTheDamageOfAFrameToTheRightBeams) {
  const Prepared p = small_plate({"crack.technique=simple"});
  Heard heard;
  march(p, heard.observer());
  ASSERT_EQ(heard.frames.size(), 5U);
  const results::Geometry g = geometry_of(p);
  const results::Frame& frame = heard.frames[2];
  std::map<int, double> position;
  for (const fracture::Crossing& c : fracture::crossings(p.path, p.lattice)) position[c.beam] = c.position;
  ASSERT_EQ(frame.damage_factor.size(), g.crossing.size());
  ASSERT_FALSE(g.crossing.empty());
  for (std::size_t k = 0; k < g.crossing.size(); ++k)
    EXPECT_EQ(frame.damage_factor[k], frame.tip_m >= position.at(g.crossing[k]) ? 0.0F : 1.0F);
}

TEST(March, ReportsEachReleasedBeamOnceWithItsFractureEnergy) {
  for (const std::string technique : {"simple", "progressive"}) {
    const Prepared p = small_plate({"crack.technique=" + technique, "crack.start=0.006"});
    Heard heard;
    const RunResult result = march(p, heard.observer());
    const results::Sample& end = result.lane[0].samples.back();
    std::map<int, double> to_break;
    for (const fracture::Crossing& c : fracture::crossings(p.path, p.lattice))
      if (c.position > 0.006 && c.position <= end.tip_m) to_break[c.beam] = c.position;
    ASSERT_EQ(heard.events.size(), to_break.size()) << technique;
    double sum = 0.0;
    for (const results::ReleaseEvent& e : heard.events) {
      ASSERT_TRUE(to_break.contains(e.beam));
      EXPECT_EQ(e.position_m, to_break[e.beam]);
      const double tip = history::tip_at(p.lane[0].scenario.history, e.time_s), way = 1100.0 * p.step.dt;
      EXPECT_GE(tip, e.position_m);
      EXPECT_LT(tip - e.position_m, way * (1.0 + 1e-9));
      sum += e.energy_j;
      to_break.erase(e.beam);
    }
    EXPECT_TRUE(to_break.empty());
    if (technique == "simple") {
      EXPECT_NEAR(sum / end.fracture_j, 1.0, 1e-12);  // the same numbers, added in another order
    } else {
      EXPECT_LT(sum, end.fracture_j);  // the beams in the zone have given some already
      EXPECT_GT(sum, 0.8 * end.fracture_j);
    }
  }
}

// Wider kernels are slower a lane: beyond a register the others wait for a lane to end.
TEST(March, FillsARegisterWithLanesAndLetsTheOthersWait) {
  if (!ensemble::is_available(ensemble::InstructionSet::baseline))
    GTEST_SKIP() << "built for this processor only (RIFT_KERNELS)";
  ::setenv("RIFT_SIMD", "baseline", 1);
  std::vector<scene::Scene> scenes;
  for (const char* velocity : {"0.4 c_r", "0.5 c_r", "0.6 c_r", "0.7 c_r", "0.8 c_r"})
    scenes.push_back(small_preset({std::string("crack.velocity=") + velocity, "crack.end=12 mm",
                                   "output.window=[0.1, 0.2]"})
                         .scene);
  base::Cache none;
  const Prepared p = prepare(small_preset({"crack.end=12 mm", "output.window=[0.1, 0.2]"}), scenes, none);
  const RunResult narrow = march(p, {}, {.threads = 1}), wide = march(p, {}, {.threads = 1, .lanes = 8});
  EXPECT_EQ(narrow.lanes, ensemble::lanes_in_register(ensemble::Precision::double_precision,
                                                      ensemble::InstructionSet::baseline));
  EXPECT_EQ(wide.lanes, 5);
  ::unsetenv("RIFT_SIMD");
  ASSERT_EQ(narrow.lane.size(), 5U);
  for (std::size_t k = 0; k < 5; ++k) {
    ASSERT_EQ(narrow.lane[k].samples.size(), wide.lane[k].samples.size());
    ASSERT_FALSE(narrow.lane[k].samples.empty());
    EXPECT_EQ(narrow.lane[k].samples.back().fracture_j, wide.lane[k].samples.back().fracture_j) << k;
    EXPECT_EQ(narrow.lane[k].samples.back().elastic_j, wide.lane[k].samples.back().elastic_j) << k;
  }
}

TEST(March, StopsWhenTheObserverSaysSoAndKeepsWhatItHas) {
  const Prepared p = small_plate({"solver.dt_fraction=0.0005"});  // seconds, of which it is asked a few times
  Heard heard;
  heard.stop_after = 2;
  const RunResult result = march(p, heard.observer());
  EXPECT_EQ(result.outcome, Outcome::stopped);
  EXPECT_STREQ(name_of(result.outcome), "stopped");
  ASSERT_EQ(heard.progress.size(), 2U);
  EXPECT_EQ(heard.progress[1].step, result.lane[0].steps);
  EXPECT_EQ(heard.progress[1].total, p.lane[0].schedule.total());
  EXPECT_GT(heard.progress[1].seconds, 0.0);
  EXPECT_LT(result.lane[0].steps, p.lane[0].schedule.total());
  EXPECT_EQ(result.lane[0].where, "step " + std::to_string(result.lane[0].steps) + " of " +
                                      std::to_string(p.lane[0].schedule.total()));
  EXPECT_EQ(result.lane[0].samples.size(), heard.samples.size());
  EXPECT_LE(result.lane[0].samples.back().step, result.lane[0].steps);
  EXPECT_FALSE(rates_of(p, result).plateau.reached);
}

TEST(March, OfARampGoesThroughThreePhases) {
  const Prepared p =
      small_plate({"loading.method=ramp", "loading.ramp_steps=1500", "loading.hold_steps=1000"});
  Heard heard;
  const RunResult result = march(p, heard.observer());
  ASSERT_EQ(result.outcome, Outcome::finished) << result.lane[0].where;
  EXPECT_EQ(heard.samples.size(), p.lane[0].schedule.samples.size());
  int before_the_crack = 0;
  for (const results::Sample& s : heard.samples) {
    EXPECT_EQ(s.phase, s.step < 1500   ? results::Phase::loading
                       : s.step < 2500 ? results::Phase::hold
                                       : results::Phase::fracture);
    if (s.step > 2500) continue;
    ++before_the_crack;
    EXPECT_DOUBLE_EQ(s.tip_m, history::tip_at(p.lane[0].scenario.history, 0.0));
    EXPECT_EQ(s.fracture_j, 0.0);
  }
  EXPECT_GT(before_the_crack, 10);
  EXPECT_NEAR(heard.samples.front().elastic_j, 0.0, 1e-30);
  // Numerical damping is taken out before the crack starts: not a joule more of it from then on.
  const auto start = std::find_if(heard.samples.begin(), heard.samples.end(),
                                  [](const results::Sample& s) { return s.step == 2500; });
  ASSERT_NE(start, heard.samples.end());
  EXPECT_GT(start->numerical_damping_j, 0.0);
  // But for the rounding of sums that go on.
  EXPECT_NEAR(heard.samples.back().numerical_damping_j / start->numerical_damping_j, 1.0, 1e-12);
  EXPECT_NEAR(heard.samples.back().work_external_j / start->work_external_j, 1.0, 1e-12);
}

TEST(March, RefusesToCrackAPlateThatStillSwingsAfterItsRamp) {
  const Prepared p = small_plate({"loading.method=ramp", "loading.ramp_steps=20", "loading.hold_steps=0"});
  const RunResult result = march(p, {});
  EXPECT_EQ(result.outcome, Outcome::diverged);
  EXPECT_GT(result.lane[0].prestress_kinetic, 0.01);
  EXPECT_NE(result.lane[0].where.find("not quasi-static; raise loading.ramp_steps or loading.hold_steps"),
            std::string::npos)
      << result.lane[0].where;
  EXPECT_EQ(result.lane[0].steps, 20);
}

// A step that choose_step() would never let through: what the user would see if it ever did.
TEST(March, StopsAsDivergedWhereTheNumbersBlowUpAndNamesTheStep) {
  Prepared p = small_plate();
  p.step.dt *= 2.2;
  p.lane[0].schedule = make_schedule(p.preset.scene, p.lane[0].scenario.history, 0.01 * p.step.dt,
                                     p.lane[0].crack_end, p.lane[0].window);
  const RunResult result = march(p, {});
  EXPECT_EQ(result.outcome, Outcome::diverged);
  EXPECT_STREQ(name_of(result.outcome), "diverged");
  EXPECT_LT(result.lane[0].steps, p.lane[0].schedule.total());
  EXPECT_TRUE(result.lane[0].where.starts_with("step " + std::to_string(result.lane[0].steps) +
                                               ": the balance error is "))
      << result.lane[0].where;
}

}  // namespace
}  // namespace rift::simulation
