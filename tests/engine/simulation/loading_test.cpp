#include "engine/lattice/lattice.hpp"
#include "engine/lattice/statics.hpp"
#include "engine/scene/derived.hpp"
#include "engine/study/plan.hpp"
#include "tests/engine/simulation/small_plate.hpp"

#include <cmath>

namespace rift::simulation {
namespace {

// The pull of a grip is what its own displacement gains of energy: F = dU/dd, by differences.
TEST(GripForce, IsTheSlopeOfTheEnergy) {
  const Prepared p = small_plate();
  const std::vector<char> present(p.lattice.beam.size(), 1);
  for (const lattice::Kinematics kinematics :
       {lattice::Kinematics::linear, lattice::Kinematics::corotational}) {
    const auto at_rest = [&](double d) {
      return kinematics == lattice::Kinematics::linear
                 ? lattice::stretched_at_rest(p.lattice, present, d)
                 : lattice::stretched_at_rest_corotational(p.lattice, present, d);
    };
    const auto energy = [&](double d) {
      return lattice::elastic_energy(p.lattice, present, kinematics, at_rest(d));
    };
    const double d = 6e-4, step = 1e-6;
    const double slope = (energy(d + step) - energy(d - step)) / (2 * step);
    EXPECT_NEAR(lattice::grip_force(p.lattice, present, kinematics, at_rest(d)), slope, 1e-6 * slope);
  }
}

TEST(LoadingForce, IsWhatTheGripOfTheNotchedPlatePullsWith) {
  for (const std::vector<std::string>& more : {std::vector<std::string>{},
                                               {"solver.kinematics=corotational"},
                                               {"loading.tilt=0.3"},
                                               {"crack.start=8 mm"}}) {
    std::vector<std::string> overrides{"loading.force=3 kN", "output.window=[0.25, 0.5]"};
    overrides.insert(overrides.end(), more.begin(), more.end());
    const Prepared p = small_plate(overrides);
    const ensemble::CrackedEnsemble plate =
        ready(p, {p.lane[0].scenario}, p.step.dt, {.kinematics = p.preset.scene.solver.kinematics});
    EXPECT_NEAR(plate.grip_force(0), 3000.0, 1e-6) << testing::PrintToString(more);
  }
}

TEST(LoadingForce, IsKeptInTheEffectivePreset) {
  const scene::Preset preset = small_preset({"loading.force=3 kN"});
  const scene::Preset again = scene::read_preset_text(scene::preset_text(preset), "again.toml");
  EXPECT_TRUE(again.issues.empty());
  EXPECT_EQ(again.scene.loading.force, 3000.0);
}

TEST(LoadingForce, OfACurveIsThatAsTheCrackStarts) {
  const std::string curve = "loading.curve=[[\"0 us\", \"1 kN\"], [\"20 us\", \"5 kN\"]]";
  const std::string history = "crack.history=[[10e-6, 4e-3], [20e-6, 14.5e-3], [30e-6, 25e-3]]";
  const Prepared p = small_plate({curve, history});
  EXPECT_EQ(p.pulled, small_plate({"loading.force=3 kN", history}).pulled);
  EXPECT_FALSE(scene::grip_moves(p.preset.scene));
}

/// From 0.6 mm on, faster for 4 us.
const std::string moving =
    R"(loading.curve=[["0 us", "0.6 mm"], ["5 us", "0.6 mm"], ["9 us", "0.62 mm"], ["99 us", "0.62 mm"]])";

TEST(LoadingCurve, MovesTheGripWhileTheCrackRunsAndTheBooksClose) {
  for (const std::vector<std::string>& more : {std::vector<std::string>{},
                                               {"solver.kinematics=corotational", "solver.dt_fraction=0.25"},
                                               {"damping.alpha=0.02", "damping.region=all"}}) {
    std::vector<std::string> overrides{moving};
    overrides.insert(overrides.end(), more.begin(), more.end());
    const Prepared p = small_plate(overrides);
    EXPECT_EQ(p.pulled, 6e-4);
    const RunResult run = march(p, {});
    EXPECT_EQ(run.outcome, Outcome::finished);
    EXPECT_LT(run.lane[0].worst_residual,
              ledger_limit(p.preset.scene.solver.kinematics, ensemble::Precision::double_precision))
        << testing::PrintToString(more);
    // Of a crack that has not come far the force stays about what it is: the work is about F times the way.
    const std::vector<results::Sample>& samples = run.lane[0].samples;
    EXPECT_NEAR(samples.back().work_external_j, samples.front().grip_force_n * 2e-5,
                0.3 * samples.front().grip_force_n * 2e-5);
    int at_rest = 0;
    for (const results::Sample& row : samples)
      if (row.time_s < 5e-6) {
        EXPECT_EQ(row.work_external_j, 0.0);
        ++at_rest;
      }
    EXPECT_GT(at_rest, 0);
  }
}

TEST(LoadingCurve, EndsWhereItSays) {
  const Prepared p = small_plate({moving});
  double top = 0.0;
  Observer observer;
  observer.frame = [&](const results::Frame& frame) {
    for (std::size_t i = 0; i < p.lattice.centre.size(); ++i)
      if (p.lattice.grip[i] == packing::Grip::top) top = frame.displacement[i][1];
  };
  (void)march(p, observer);
  EXPECT_NEAR(top, 6.2e-4, 1e-9);
}

TEST(LoadingCurve, WaitsForTheMeasuredCrack) {
  const Prepared p = small_plate({moving, "crack.history=[[2e-6, 4e-3], [12e-6, 14.5e-3], [22e-6, 25e-3]]"});
  EXPECT_EQ(p.pulled, 6e-4);
  EXPECT_GT(p.lane[0].lead, 0.0);
  const RunResult run = march(p, {});
  // The grip stands until the history's clock shows 5 us, 3 us after its first row.
  int before = 0, after = 0;
  for (const results::Sample& row : run.lane[0].samples) {
    const double clock = row.time_s - p.lane[0].lead + 2e-6;
    if (clock < 5e-6) {
      EXPECT_EQ(row.work_external_j, 0.0) << clock;
      ++before;
    } else if (clock > 5.2e-6) {
      EXPECT_GT(row.work_external_j, 0.0) << clock;
      ++after;
    }
  }
  EXPECT_GT(before, 0);
  EXPECT_GT(after, 0);
}

TEST(LoadingCurve, IsOfAsManyLanesAsGoSideBySide) {
  const scene::Preset preset = small_preset({moving});
  std::vector<scene::Scene> lanes(9, preset.scene);
  for (int k = 0; k < 9; ++k) lanes[k].crack.velocity = {{{0.3 + 0.05 * k, true}, {}}};
  const Prepared p = prepare(preset, lanes, shared_cache());
  try {
    (void)march(p, {});
    FAIL() << "nine lanes in eight";
  } catch (const scene::InputError& error) {
    EXPECT_TRUE(
        contains(error.what(), "moves the grip of all lanes at once: at most 8 go side by side, not 9"));
  }
}

// Zones of two lengths reach the measured start at two moments, and there is one grip.
TEST(LoadingCurve, IsOfLanesWhoseCracksStartTogether) {
  const scene::Preset preset =
      small_preset({moving, "crack.history=[[2e-6, 4e-3], [12e-6, 14.5e-3], [22e-6, 25e-3]]"});
  std::vector<scene::Scene> lanes(2, preset.scene);
  lanes[1].crack.damage_zone_ratio = 3;
  const Prepared p = prepare(preset, lanes, shared_cache());
  EXPECT_THROW(check_grip(p), scene::InputError);
  EXPECT_THROW((void)march(p, {}), scene::InputError);
  EXPECT_EQ(study::passes_of(p.lane).size(), 2U);
  EXPECT_EQ(study::passes_of({p.lane[0], p.lane[0]}).size(), 1U);
}

}  // namespace
}  // namespace rift::simulation
