#include "engine/experiment/experiment.hpp"
#include "tests/engine/simulation/small_plate.hpp"

#include <cmath>

namespace rift::experiment {
namespace {

/// A crack measured at 0.4 c_r in a plate that is thick enough for a crack of its own to be told from waves.
scene::Preset measured_preset() {
  scene::Preset preset =
      simulation::small_preset({"crack.damage_zone_ratio=3", "crack.toughness_window=6", "crack.end=30 mm"});
  preset.scene.crack.start = 4e-3;
  for (int k = 0; k <= 16; ++k)
    preset.scene.crack.history.push_back({2e-6 * k, 4e-3 + 880.0 * 2e-6 * k, 1e-5});
  preset.scene.crack.end.reset();
  return preset;
}

Experiment small_experiment(const scene::Preset& preset, const ExperimentOptions& wishes) {
  const TemporaryFolder folder;
  return run_experiment(preset, wishes, folder.path(), shared_cache(), {},
                        [](std::string_view, double) { return true; });
}

TEST(Experiment, ReadsWhatTheCrackReleasesAndCorrectsItByWhatTheLatticeTakes) {
  const scene::Preset preset = measured_preset();
  const Experiment e = small_experiment(preset, {.resamples = 3, .specimens = 2, .threads = 1});
  EXPECT_EQ(e.outcome, simulation::Outcome::finished);
  EXPECT_LT(e.worst_residual, 1e-10);
  EXPECT_EQ(e.resamples, 3);
  EXPECT_EQ(e.specimens, 2);
  ASSERT_GT(e.along.size(), 30U);
  double corrected = 0.0, over_static = 0.0, packing = 0.0;
  for (const CriticalPoint& p : e.along) {
    EXPECT_NEAR(p.over_cr, 0.4, 0.01);
    EXPECT_NEAR(p.position, 4e-3 + 880.0 * p.time, 1e-4);
    EXPECT_GT(p.as_paper, 0.0);
    EXPECT_LT(p.efficiency, 1.0);
    EXPECT_NEAR(p.corrected * p.efficiency, p.as_paper, 1e-9 * p.as_paper);
    EXPECT_NEAR(p.uncertainty, std::hypot(p.of_noise, p.of_packing, p.of_window), 1e-9);
    EXPECT_LT(p.of_noise, 0.1 * p.as_paper);  // a noise of 0.01 mm is next to nothing
    EXPECT_GT(p.quasi_static_uncertainty, 0.0);
    EXPECT_LT(p.quasi_static_uncertainty, p.quasi_static);
    corrected += p.corrected, over_static += p.quasi_static, packing += p.of_packing;
  }
  EXPECT_GT(packing, 0.0);
  EXPECT_NEAR(e.own_rayleigh_speed / e.rayleigh_speed, 1.0, 0.1);
  EXPECT_NEAR(e.own_poisson_ratio, 0.28, 0.05);
  // In a strip what arrives at a steady tip is what a slow crack would release (Nilsson 1972).
  EXPECT_NEAR(corrected / over_static, 1.0, 0.2);
}

TEST(Experiment, WithoutNoiseAndOtherSpecimensHasTheWindowsBandOnly) {
  const Experiment e = small_experiment(measured_preset(),
                                        {.resamples = 0, .specimens = 1, .application = false, .threads = 1});
  for (const CriticalPoint& p : not_empty(e.along)) {
    EXPECT_EQ(p.of_noise, 0.0);
    EXPECT_EQ(p.of_packing, 0.0);
    EXPECT_EQ(p.uncertainty, p.of_window);
  }
  EXPECT_TRUE(e.application.along.empty());
}

TEST(Experiment, LawRises) {
  const Experiment e = small_experiment(measured_preset(), {.resamples = 0, .specimens = 1, .threads = 1});
  ASSERT_GT(e.law.size(), 1U);
  for (std::size_t k = 1; k < e.law.size(); ++k) {
    EXPECT_GT(e.law[k][0], e.law[k - 1][0]);
    EXPECT_GE(e.law[k][1], e.law[k - 1][1]);
  }
}

}  // namespace
}  // namespace rift::experiment
