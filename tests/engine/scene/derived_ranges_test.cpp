#include "engine/scene/derived.hpp"
#include "engine/scene/preset.hpp"
#include "tests/engine/scene/range_ends.hpp"
#include "tests/expectations.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rift::scene {
namespace {

std::string issues_of(const std::vector<std::string>& overrides) {
  std::string text;
  for (const Issue& issue : read_preset_text("", "x.toml", overrides).issues) text += to_text(issue) + "\n";
  return text;
}

TEST(DerivedRange, NamesTheKeysTheNumberAndWhatItMayBe) {
  EXPECT_EQ(issues_of({"material.rayleigh_speed=1e-300"}),
            "--set material.rayleigh_speed=1e-300: with material.young_modulus and material.poisson_ratio it "
            "makes a density of inf kg/m3, which must lie in [1e-12, 1e+15] kg/m3\n");
}

TEST(DerivedRange, IsThatOfAllThatFollowsFromTheScene) {
  for (const auto& [given, number] : {std::pair{"specimen.height=1e-300", "a thickness of"},
                                      {"specimen.length=5e-324", "a thickness of"},
                                      {"specimen.thickness=1e-300", "a thickness of"},
                                      {"material.young_modulus=5e-324", "a shear modulus of"},
                                      {"material.poisson_ratio=-0.9999999999999999", "a shear modulus of"},
                                      {"material.density=1e-300", "a density of"},
                                      {"loading.displacement=1e-300", "a strain of"},
                                      {"crack.damage_zone_ratio=5e-324", "a damage zone of"}}) {
    const std::string text = issues_of({given});
    EXPECT_TRUE(contains(text, std::string("--set ") + given + ": with "));
    EXPECT_TRUE(contains(text, number));
  }
}

TEST(DerivedRange, PointsAtTheGivenKeyThatIsFurthestFromUsual) {
  EXPECT_TRUE(issues_of({"specimen.height=39 mm", "specimen.length=1e-300", "specimen.elements=19000"})
                  .starts_with("--set specimen.length=1e-300: "));
  EXPECT_TRUE(issues_of({"specimen.length=190 mm", "specimen.height=1e-300"})
                  .starts_with("--set specimen.height=1e-300: "));
}

TEST(DerivedRange, IsLeftByTwoKeysEachOfWhichIsFine) {
  EXPECT_EQ(issues_of({"material.young_modulus=1e13"}), "");
  EXPECT_EQ(issues_of({"material.rayleigh_speed=10"}), "");
  EXPECT_TRUE(contains(issues_of({"material.young_modulus=1e13", "material.rayleigh_speed=10 mm/s"}),
                       "a density of"));
}

TEST(DerivedRange, OfTheStrainIsThatOfTheArithmetic) {
  EXPECT_EQ(issues_of({"loading.displacement=1e-20"}), "");
  EXPECT_TRUE(contains(issues_of({"loading.displacement=1e-20", "solver.precision=single"}),
                       "which must lie in [1e-15, 1e+06]"));
  EXPECT_TRUE(contains(issues_of({"loading.displacement=1e-20", "solver.kinematics=corotational"}),
                       "which must lie in [1e-10, 1e+06]"));
}

TEST(DerivedRange, OfNothingIsAskedWhereAKeyOfItIsWrongItself) {
  EXPECT_EQ(issues_of({"specimen.height=-1"}), "--set specimen.height=-1: must lie in (0, 100] m\n");
}

// As the program is driven by ranges_slow_test, up to where a lattice is needed.
TEST(EveryKey, AtTheEndsOfItsRangeIsReadOrRefusedByItsName) {
  int read = 0, refused = 0;
  for (const Parameter& row : parameters())
    for (const std::string& value : ends_of(row)) {
      const std::string given = std::string(row.key) + "=" + value;
      Preset preset;
      ASSERT_NO_THROW(preset = read_preset_text("", "x.toml", {given})) << given;
      ++(preset.issues.empty() ? read : refused);
      if (preset.issues.empty()) continue;
      EXPECT_TRUE(
          std::any_of(preset.issues.begin(), preset.issues.end(),
                      [&](const Issue& issue) { return to_text(issue).find(row.key) != std::string::npos; }))
          << given << "\n"
          << to_text(preset.issues.front());
    }
  EXPECT_GT(read, 200);
  EXPECT_GT(refused, 400);
}

}  // namespace
}  // namespace rift::scene
