#include "engine/scene/derived.hpp"

#include "engine/scene/preset.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace rift::scene {
namespace {

Scene scene_of(const std::vector<std::string>& overrides) {
  const Preset preset = read_preset_text("", "x.toml", overrides);
  for (const Issue& issue : preset.issues) ADD_FAILURE() << to_text(issue);
  return preset.scene;
}

TEST(Thickness, KeepsTwoLayersForAnyNumberOfElements) {
  EXPECT_NEAR(thickness_m(scene_of({})), 2e-3, 1e-15);
  EXPECT_NEAR(thickness_m(scene_of({"specimen.elements=5000"})), 4e-3, 1e-15);
  EXPECT_NEAR(thickness_m(scene_of({"specimen.elements=80000"})), 1e-3, 1e-15);
  // The half-size plate at a quarter of the elements has the paper's thickness, and radius.
  EXPECT_NEAR(
      thickness_m(scene_of({"specimen.elements=5000", "specimen.length=100 mm", "specimen.height=20 mm"})),
      2e-3, 1e-15);
}

TEST(Thickness, GrowsWithLayersToThreeHalves) {
  EXPECT_NEAR(thickness_m(scene_of({"specimen.layers=8"})), 16e-3, 1e-14);
  EXPECT_EQ(thickness_m(scene_of({"specimen.thickness=3 mm"})), 3e-3);
}

TEST(MeanRadius, IsTheMeasuredOneOfThePaperPlate) {
  EXPECT_NEAR(expected_mean_radius_m(scene_of({})), 0.487e-3, 0.0005e-3);  // model.md §1 gives three digits
}

TEST(Density, FollowsFromTheRayleighSpeedInEitherPlane) {
  EXPECT_NEAR(density(scene_of({})), 667, 0.5);  // model.md §5 gives three digits
  EXPECT_NEAR(density(scene_of({"material.plane=strain"})), 683, 0.5);
  EXPECT_EQ(density(scene_of({"material.density=700"})), 700.0);
}

TEST(RayleighSpeed, IsTheInverseOfDensity) {
  Scene scene = scene_of({});
  scene.material.density = density(scene);
  scene.material.rayleigh_speed.reset();
  EXPECT_NEAR(rayleigh_speed(scene), 2200, 1e-8);
  EXPECT_EQ(rayleigh_speed(scene_of({})), 2200.0);
}

TEST(HighestVelocity, IsThatOfTheFastestPieceInRayleighSpeeds) {
  EXPECT_DOUBLE_EQ(highest_velocity(scene_of({"crack.velocity=1100 m/s"})), 0.5);
  EXPECT_DOUBLE_EQ(
      highest_velocity(scene_of({"crack.velocity=0.2 c_r until 20 mm, 1540 m/s until 50 mm, 0.3 c_r"})), 0.7);
  EXPECT_EQ(speed_m_s({0.5, true}, 2200), 1100.0);
  EXPECT_EQ(speed_m_s({900, false}, 2200), 900.0);
}

TEST(PathHeightInMetres, IsAFractionOfTheHeightOrALength) {
  EXPECT_DOUBLE_EQ(path_height_m(scene_of({"crack.path=0.25 H"})), 0.01);
  EXPECT_EQ(path_height_m(scene_of({"crack.path=30 mm"})), 0.03);
}

TEST(Window, LiesFurtherOnForFastCracks) {
  using Window = std::array<double, 2>;
  EXPECT_EQ(window_over_length(scene_of({})), (Window{0.2, 0.4}));
  EXPECT_EQ(window_over_length(scene_of({"crack.velocity=0.8 c_r"})), (Window{0.2, 0.4}));
  EXPECT_EQ(window_over_length(scene_of({"crack.velocity=0.9 c_r"})), (Window{0.4, 0.6}));
  EXPECT_EQ(window_over_length(scene_of({"crack.velocity=2000 m/s"})), (Window{0.4, 0.6}));
  EXPECT_EQ(window_over_length(scene_of({"crack.velocity=0.2 c_r until 20 mm, 1 c_r"})), (Window{0.4, 0.6}));
  EXPECT_EQ(window_over_length(scene_of({"crack.velocity=1 c_r", "output.window=[0.1, 0.2]"})),
            (Window{0.1, 0.2}));
}

/// A plate five times as high as the paper's, opened from its middle.
std::vector<std::string> two_tips(const std::vector<std::string>& more) {
  std::vector<std::string> all{"crack.tips=2", "specimen.length=300 mm", "specimen.height=200 mm",
                               "specimen.elements=160000"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

TEST(Window, OfTwoTipsReachesFromFiveDamageZonesToTheFirstEcho) {
  for (const double zones : {1.0, 4.0}) {
    const Scene scene = scene_of(two_tips({"crack.damage_zone_ratio=" + std::to_string(zones)}));
    const auto [from, to] = window_over_length(scene);
    EXPECT_NEAR(from * 0.3, 5.0 * zones * expected_mean_radius_m(scene), 1e-15);
    EXPECT_NEAR(to * 0.3, 5.0 * 11.3e-3, 5.0 * 0.05e-3);  // model.md §9.4, H = 200 mm instead of 40
    EXPECT_NEAR(crack_end(scene), to * 0.3, 1e-15);
  }
}

TEST(Window, OfTwoTipsReleasedSimplyBeginsAfterFiveMeanRadii) {
  const Scene scene = scene_of(two_tips({"crack.technique=simple", "crack.damage_zone_ratio=9"}));
  EXPECT_NEAR(window_over_length(scene)[0] * 0.3, 5.0 * expected_mean_radius_m(scene), 1e-15);
  EXPECT_EQ(expected_zone_m(scene), 0.0);
}

TEST(Window, OfTwoTipsCountsFromTheEndOfTheirNotch) {
  const auto whole = window_over_length(scene_of(two_tips({})));
  const auto notched = window_over_length(scene_of(two_tips({"crack.start=15 mm"})));
  for (int end : {0, 1}) EXPECT_NEAR(notched[end] - whole[end], 0.05, 1e-12);
}

// At 0.9 c_r the echo of the ends, W = 150 mm ahead, is the first: 2 W v / (c_d + v) with v = 0.48784 c_d.
TEST(Window, OfTwoTipsEndsWithTheFirstEchoOfTheEndsWhereThatIsFirst) {
  const Scene scene = scene_of(two_tips({"crack.velocity=0.9 c_r"}));
  EXPECT_NEAR(window_over_length(scene)[1] * 0.3, 0.3 * 0.48784 / 1.48784, 1e-6);
  EXPECT_EQ(window_over_length(scene_of(two_tips({"crack.velocity=1.9 c_r"})))[1], 0.5);  // no echo
}

TEST(Window, OfTwoTipsIsTheOneThatIsGiven) {
  const Scene scene = scene_of(two_tips({"output.window=[0.1, 0.5]"}));
  EXPECT_EQ(window_over_length(scene), (std::array<double, 2>{0.1, 0.5}));
}

TEST(CrackEnd, IsTheEndOfTheWindowUnlessGiven) {
  EXPECT_NEAR(crack_end(scene_of({})), 0.08, 1e-15);
  EXPECT_NEAR(crack_end(scene_of({"crack.velocity=0.9 c_r"})), 0.12, 1e-15);
  EXPECT_EQ(crack_end(scene_of({"crack.end=150 mm"})), 0.15);
}

TEST(EchoFreeTip, IsTheAdvanceFromTheStart) {
  EXPECT_NEAR(echo_free_tip_m(scene_of({})), 11.3e-3, 0.05e-3);  // model.md §9.4 gives three digits
  EXPECT_NEAR(echo_free_tip_m(scene_of({"crack.velocity=1 c_r"})), 25.8e-3, 0.05e-3);
  const double advance = echo_free_tip_m(scene_of({}));
  EXPECT_NEAR(echo_free_tip_m(scene_of({"crack.velocity=1100 m/s"})), advance, 1e-12);
  EXPECT_NEAR(echo_free_tip_m(scene_of({"crack.start=30 mm"})), 0.03 + advance, 1e-12);
  // In linear elasticity time scales with c_r: the advance does not depend on it.
  EXPECT_NEAR(echo_free_tip_m(scene_of({"material.density=1000"})), advance, 1e-12);
}

TEST(EchoFreeTip, ComesFromTheNearerGripOrTheEndOfThePlate) {
  const double advance = echo_free_tip_m(scene_of({}));
  for (const char* path : {"crack.path=0.1 H", "crack.path=0.9 H"})
    EXPECT_NEAR(echo_free_tip_m(scene_of({path})), 0.2 * advance, 1e-12);
  // 2 W v / (c_d + v) with W = 2 mm, v = 0.2710 c_d
  EXPECT_NEAR(echo_free_tip_m(scene_of({"crack.start=198 mm", "output.window=[0.992, 1]"})),
              0.198 + 4e-3 * 0.2710 / 1.2710, 1e-7);
}

TEST(EchoFreeTip, DependsOnTheVelocityOverThatOfThePlatesOwnWaves) {
  EXPECT_NEAR(echo_free_tip_m(scene_of({"crack.velocity=1 c_r"}), 2.0), echo_free_tip_m(scene_of({})), 1e-12);
}

TEST(EchoFreeTip, IsUnknownWhereTheCrackChangesItsVelocity) {
  EXPECT_TRUE(std::isnan(echo_free_tip_m(scene_of({"crack.velocity=0.2 c_r until 20 mm, 1 c_r"}))));
  EXPECT_TRUE(std::isinf(echo_free_tip_m(scene_of({"crack.velocity=1.9 c_r"}))));  // c_d = 1.845 c_r
}

}  // namespace
}  // namespace rift::scene
