#include "engine/scene/needs.hpp"

#include "engine/scene/parameters.hpp"

#include <gtest/gtest.h>

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

TEST(LeftOut, SaysWhatAndWhy) {
  Scene scene = default_scene();
  scene.crack.technique = fracture::Technique::simple;
  scene.output.frames = 0;
  EXPECT_EQ(left_out(scene),
            (std::vector<std::string>{
                "damping: alpha = 0, no damped beams are built", "numerical damping: beta = 1",
                "damage zone: technique = simple", "ramp: method = static, the pre-stress is one solve",
                "moving grip: no loading.curve, the grips stand still while the crack runs",
                "corotation: kinematics = linear, the beam axes stay fixed",
                "contact: no friction, the crack's faces do not touch",
                "energy balance of every step: no dissipation and no external work, energies are computed at "
                "samples only",
                "frames: frames = 0, no fields are written", "gauges: output.gauges has no points"}));
}

TEST(LeftOut, IsEmptyWhereAllIsNeeded) { EXPECT_TRUE(left_out(scene_with_everything()).empty()); }

}  // namespace
}  // namespace rift::scene
