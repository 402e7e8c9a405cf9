#include "engine/scene/needs.hpp"

#include "engine/scene/parameters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace rift::scene {
namespace {

TEST(Needs, OfTheDefaultSceneAreTheDamageZoneAndFrames) {
  const Needs needs = needs_of(default_scene());
  EXPECT_FALSE(needs.damping);
  EXPECT_FALSE(needs.numerical_damping);
  EXPECT_TRUE(needs.damage_zone);
  EXPECT_FALSE(needs.ramp);
  EXPECT_FALSE(needs.corotation);
  EXPECT_FALSE(needs.step_energies);
  EXPECT_TRUE(needs.frames);
}

Scene scene_with_everything() {
  Scene scene = default_scene();
  scene.damping.alpha = 0.001;
  scene.damping.region = DampingRegion::surface;
  scene.solver.beta = 0.9;
  scene.loading.method = LoadingMethod::ramp;
  scene.solver.kinematics = lattice::Kinematics::corotational;
  scene.crack.friction = 0.0;
  scene.output.gauges = {{0.1, 0.03}};
  return scene;
}

TEST(UsedParameters, AreThoseThatTheSceneDependsOn) {
  Scene scene = default_scene();
  for (const char* key : {"crack.velocity", "crack.damage_zone_ratio", "loading.displacement",
                          "output.fields", "specimen.coordination", "solver.beta"})
    EXPECT_TRUE(is_used(scene, key)) << key;
  for (const char* key :
       {"crack.smoothing", "crack.toughness_window", "damping.alpha", "damping.surface_width",
        "loading.ramp_steps", "output.gauge_length", "crack.path_shape"})
    EXPECT_FALSE(is_used(scene, key)) << key;
  scene.crack.history = {{0, 0.01, 0}, {1e-5, 0.02, 0}};
  scene.crack.technique = fracture::Technique::simple;
  scene.loading.force = 100.0;
  scene.specimen.solid_fraction = 0.64;
  for (const char* key :
       {"crack.velocity", "crack.damage_zone_ratio", "loading.displacement", "specimen.coordination"})
    EXPECT_FALSE(is_used(scene, key)) << key;
  for (const char* key : {"crack.smoothing", "crack.toughness_window"})
    EXPECT_TRUE(is_used(scene, key)) << key;
}

// A rule about a key that is not there would be about nothing.
TEST(UsedParameters, ThatDependOnTheSceneAreParameters) {
  Scene scene = scene_with_everything();
  std::set<std::string> unused;
  for (const Parameter& row : parameters())
    if (!is_used(scene, row.key)) unused.insert(std::string(row.key));
  const std::set<std::string> of_other_scenes{
      "crack.history_gap", "crack.path_shape", "crack.smoothing",       "crack.toughness_window",
      "fracture.duration", "fracture.kappa",   "fracture.release_rate", "fracture.strength",
      "loading.rise_time", "loading.rollers"};
  EXPECT_EQ(unused, of_other_scenes);
}

TEST(Needs, FollowTheScene) {
  const Needs needs = needs_of(scene_with_everything());
  EXPECT_TRUE(needs.damping);
  EXPECT_TRUE(needs.numerical_damping);
  EXPECT_TRUE(needs.ramp);
  EXPECT_TRUE(needs.corotation);
  EXPECT_TRUE(needs.contact);
  EXPECT_TRUE(needs.gauges);
  EXPECT_TRUE(needs.step_energies);
  Scene none = scene_with_everything();
  none.damping.region = DampingRegion::none;
  EXPECT_FALSE(needs_of(none).damping);
  none.output.fields.clear();
  EXPECT_FALSE(needs_of(none).frames);
}

TEST(Needs, OfALoadCurveAreBooksOfTheMovingGrip) {
  Scene scene = default_scene();
  scene.loading.curve.row = {{0.0, 1e-3}, {1e-3, 2e-3}};
  EXPECT_TRUE(needs_of(scene).moving_grip);
  EXPECT_TRUE(needs_of(scene).step_energies);
  scene.loading.curve.of = LoadCurve::Of::force;
  EXPECT_FALSE(needs_of(scene).moving_grip);
  EXPECT_FALSE(needs_of(scene).step_energies);
}

std::vector<std::string> lines(const std::vector<Scene>& lanes) { return left_out_by_lanes(lanes); }

TEST(LeftOut, SaysWhatAndWhy) {
  Scene scene = default_scene();
  scene.crack.technique = fracture::Technique::simple;
  scene.output.frames = 0;
  EXPECT_EQ(lines({scene}),
            (std::vector<std::string>{
                "damping: alpha = 0, no damped beams are built", "numerical damping: beta = 1",
                "damage zone: technique = simple", "ramp: method = static, the pre-stress is one solve",
                "moving grip: no loading.curve, the grips stand still while the crack runs",
                "corotation: kinematics = linear, the beam axes stay fixed",
                "contact: no friction, the crack's faces do not touch",
                "step energies: no dissipation and no external work, energies are computed at samples only",
                "frames: frames = 0, no fields are written", "gauges: output.gauges has no points"}));
}

TEST(LeftOut, IsEmptyWhereAllIsNeeded) {
  EXPECT_TRUE(lines({scene_with_everything()}).empty());
  EXPECT_TRUE(left_out(scene_with_everything()).empty());
}

TEST(LeftOut, HasAShortNameForEachLine) {
  const std::vector<std::string> names = left_out(default_scene());
  EXPECT_EQ(names, (std::vector<std::string>{"damping", "numerical_damping", "ramp", "moving_grip",
                                             "corotation", "contact", "step_energies", "gauges"}));
  EXPECT_EQ(names.size(), lines({default_scene()}).size());
  for (const std::string& name : names) EXPECT_NE(find_optional_part(name), nullptr) << name;
  EXPECT_EQ(find_optional_part("no_such_part"), nullptr);
}

TEST(LeftOut, OfARampIsNoMovingGrip) {
  Scene scene = default_scene();
  scene.loading.method = LoadingMethod::ramp;
  const std::vector<std::string> names = left_out(scene);
  for (const char* name : {"ramp", "moving_grip", "step_energies"})
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 0) << name;
}

/// The one line that begins with this word.
std::string line_of(const std::vector<std::string>& lines, const std::string& word) {
  std::string found;
  for (const std::string& line : lines)
    if (line.starts_with(word + ":")) found += line;
  return found;
}

TEST(LeftOut, OfLanesSaysWhichAndWhatTheirStepComputesForAll) {
  Scene undamped = default_scene(), damped = default_scene();
  damped.damping.alpha = 0.001, damped.damping.region = DampingRegion::surface;
  damped.crack.technique = fracture::Technique::simple;
  const std::vector<std::string> said = lines({undamped, damped, damped});
  EXPECT_EQ(
      line_of(said, "damping"),
      "damping: lane 0 (alpha = 0, no damped beams are built); lanes 1 and 2 need it: the lanes share a "
      "step, which evaluates the damped beams for all of them");
  EXPECT_EQ(
      line_of(said, "damage zone"),
      "damage zone: lanes 1 and 2 (technique = simple); lane 0 needs it: each lane has a release law of "
      "its own, and nothing is computed for the others");
  EXPECT_TRUE(line_of(said, "step energies").starts_with("step energies: lane 0 (")) << said[0];
  EXPECT_EQ(line_of(said, "corotation"), line_of(lines({undamped}), "corotation"));
  EXPECT_EQ(line_of(lines({damped, damped}), "damping"), "");
}

TEST(LeftOut, OfAStudyCountsItsScenarios) {
  const Preset preset = read_preset_text(
      "[study]\ntechnique = [\"simple\", \"progressive\"]\ndamage_zone_ratio = [1, 2]\n", "x.toml");
  EXPECT_EQ(line_of(left_out_lines(preset), "damage zone"),
            "damage zone: 1 of 3 scenarios (technique = simple)");
  EXPECT_EQ(line_of(left_out_lines(preset), "damping"), "damping: alpha = 0, no damped beams are built");
}

}  // namespace
}  // namespace rift::scene
