#include "engine/scene/scenarios.hpp"
#include "tests/expectations.hpp"

#include <gtest/gtest.h>

#include <string>

namespace rift::scene {
namespace {

TEST(Axes, EachVaryARowOfTheParameterTable) {
  for (const Axis& axis : not_empty(axes())) {
    EXPECT_NE(find_parameter(axis.key), nullptr) << axis.name;
    EXPECT_EQ(find_axis(axis.name), &axis);
  }
  EXPECT_EQ(axes().size(), 20u);
  EXPECT_EQ(find_axis("crack.velocity"), nullptr);
}

TEST(Axes, DifferBetweenLanesOnlyWhereLatticeAndStepStay) {
  EXPECT_EQ(
      lane_axes(),
      "technique, relaxation, damage_zone_ratio, damping_alpha, damping_region, crack_velocity and friction");
}

TEST(AxisText, IsTheValueWithoutQuotes) {
  const Scene scene = default_scene();
  EXPECT_EQ(axis_text(scene, *find_axis("crack_velocity")), "0.5 c_r");
  EXPECT_EQ(axis_text(scene, *find_axis("relaxation")), "linear");
  EXPECT_EQ(axis_text(scene, *find_axis("length")), "200 mm");
  EXPECT_EQ(axis_text(scene, *find_axis("layers")), "2");
}

TEST(AxisText, IsADashWhereTheAxisDoesNotApplyOrHasNoValue) {
  Scene scene = default_scene();
  scene.crack.technique = fracture::Technique::simple;
  EXPECT_EQ(axis_text(scene, *find_axis("relaxation")), "-");
  EXPECT_EQ(axis_text(scene, *find_axis("damage_zone_ratio")), "-");
  EXPECT_EQ(axis_text(scene, *find_axis("dt_fraction")), "-");
  EXPECT_EQ(axis_text(scene, *find_axis("technique")), "simple");
}

TEST(UnknownAxis, PointsToTheNearestNameOrTheAxisOfAKey) {
  EXPECT_EQ(unknown_axis("damge_zone_ratio"),
            "unknown axis 'damge_zone_ratio', did you mean 'damage_zone_ratio'?");
  EXPECT_EQ(unknown_axis("velocity"), "unknown axis 'velocity', did you mean 'crack_velocity'?");
  EXPECT_EQ(unknown_axis("loading.method"),
            "unknown axis 'loading.method', did you mean 'prestress_method'?");
  EXPECT_EQ(
      unknown_axis("young_modulus"),
      "unknown axis 'young_modulus': the axes are technique, relaxation, damage_zone_ratio, "
      "damping_alpha, damping_region, crack_velocity, friction, elements, layers, seed, stiffness, plane, "
      "dt_fraction, beta, precision, kinematics, length, path, prestress_method and samples");
}

}  // namespace
}  // namespace rift::scene
