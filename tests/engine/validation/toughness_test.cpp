#include "engine/validation/toughness.hpp"

#include "tests/shared_cache.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace rift::validation {
namespace {

/// Realisations whose energy rises with kappa by `slope` from `at_seven` at 0.7, each its own `off` more.
ToughnessGroup group_of(double at_seven, double slope, const std::vector<double>& off) {
  ToughnessGroup group{.elements = 1000, .packings = static_cast<int>(off.size()) / 2, .resolved = 16};
  for (const double more : off) {
    group.realisation.emplace_back();
    for (const double kappa : kappas)
      group.realisation.back().push_back({kappa, at_seven + slope * (kappa - 0.7) + more});
  }
  return group;
}

TEST(Toughness, KappaIsWhereTheMeanEnergyIsThatOfTheMaterial) {
  const Fitted exact = fitted_kappa(group_of(0.9, 2.0, {0.1, -0.1, 0.1, -0.1}));
  EXPECT_NEAR(exact.value, 0.75, 1e-12);
  EXPECT_NEAR(exact.error, 0.0, 1e-12);  // packings with their mirror images are alike
  // Packings 0.1, 0 and -0.1 off: the standard error of their mean, over the slope.
  const Fitted scattered = fitted_kappa(group_of(0.9, 2.0, {0.1, 0.1, 0.0, 0.0, -0.1, -0.1}));
  EXPECT_NEAR(scattered.value, 0.75, 1e-12);
  EXPECT_NEAR(scattered.error, 0.1 / std::sqrt(3.0) / 2.0, 1e-12);
  EXPECT_TRUE(std::isnan(fitted_kappa(group_of(0.9, -2.0, {0.0, 0.0, 0.0, 0.0})).value));
  ToughnessGroup late = group_of(0.9, 2.0, {0.1, -0.1, 0.1, -0.1});
  late.realisation[1].back().energy =
      std::nan("");  // at 0.9 one does not arrive: the others are no mean of all
  late.realisation[0].back().energy = 0.0;
  EXPECT_NEAR(fitted_kappa(late).value, 0.75, 1e-12);
  const Fitted energy =
      mean_at(group_of(0.9, 2.0, {0.1, -0.1}), 0.75, [](const ToughnessRow& row) { return row.energy; });
  EXPECT_NEAR(energy.value, 1.0, 1e-12);
  EXPECT_NEAR(energy.error, 0.1, 1e-12);
}

TEST(Toughness, FinishedRealisationsAreRecalled) {
  const std::filesystem::path file = std::filesystem::path(RIFT_SOURCE_DIR) / "presets" / "freund_wave.toml";
  int reads = 0;
  const auto read = [&](const std::vector<std::string>& more) {
    ++reads;
    return scene::read_preset(file, more);
  };
  std::vector<std::string> stages;
  const auto told = [&](std::string_view stage, double) { return stages.emplace_back(stage), true; };
  std::vector<ToughnessGroup> groups(2, {.elements = 1500, .packings = 1, .resolved = 32});
  for (ToughnessGroup& group : groups) {
    stages.clear();
    compute_toughness(group, read, shared_cache(), told, 1);
    ASSERT_EQ(group.realisation.size(), 2U);
  }
  EXPECT_TRUE(stages.empty());  // the second time nothing is prepared or marched
  EXPECT_EQ(groups[0].mean_radius, groups[1].mean_radius);
  for (int r : {0, 1})
    for (std::size_t k = 0; k < kappas.size(); ++k) {
      const double first = groups[0].realisation[r][k].energy, second = groups[1].realisation[r][k].energy;
      EXPECT_EQ(groups[0].realisation[r][k].kappa, kappas[k]);
      EXPECT_TRUE(first == second || (std::isnan(first) && std::isnan(second)));
    }
}

}  // namespace
}  // namespace rift::validation
