#include "engine/scene/derived.hpp"
#include "engine/scene/preset.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rift::scene {
namespace {

std::string complaints(const std::vector<std::string>& overrides) {
  std::string lines;
  for (const Issue& issue : read_preset_text("", "x.toml", overrides).issues) lines += to_text(issue) + '\n';
  return lines;
}

Scene shape_of(const std::vector<std::string>& overrides) {
  const Preset preset = read_preset_text("", "x.toml", overrides);
  EXPECT_TRUE(preset.issues.empty()) << complaints(overrides);
  return preset.scene;
}

TEST(Shapes, FillTheirBox) {
  const packing::Box cylinder =
      box_of(shape_of({"specimen.shape=cylinder", "specimen.length=10 mm", "specimen.height=20 mm"}));
  EXPECT_NEAR(cylinder.volume(), 500e-9 * std::numbers::pi, 1e-20);
  const packing::Box sphere = box_of(shape_of({"specimen.shape=sphere", "specimen.length=10 mm"}));
  EXPECT_EQ(sphere.height, 10e-3);
  const packing::Box box = box_of(shape_of({"specimen.shape=periodic", "specimen.thickness=30 mm"}));
  EXPECT_EQ(box.thickness, 30e-3);
  EXPECT_EQ(box.shape, packing::Shape::periodic);
}

TEST(Shapes, TakeTheKeysThatAreTheirs) {
  EXPECT_EQ(complaints({"specimen.shape=block"}),
            "--set specimen.shape=block: needs specimen.thickness as well\n");
  EXPECT_EQ(complaints({"specimen.shape=sphere", "specimen.height=10 mm"}),
            "--set specimen.height=10 mm: a sphere has one size, specimen.length\n");
  EXPECT_EQ(complaints({"specimen.shape=cylinder", "specimen.thickness=10 mm"}),
            "--set specimen.thickness=10 mm: applies to boxes only: the diameter of a round shape is "
            "specimen.length\n");
  EXPECT_EQ(complaints({"specimen.shape=cylinder", "specimen.layers=2"}),
            "--set specimen.layers=2: goes with specimen.shape = \"plate\" only\n");
  EXPECT_EQ(complaints({"calibration.packings=3"}),
            "--set calibration.packings=3: goes with specimen.shape = \"cylinder\" or material.stiffness = "
            "\"calibrated\" only\n");
  EXPECT_EQ(complaints({"calibration.packings=3", "material.stiffness=calibrated"}), "");
}

TEST(Shapes, AreThickerThanTheirElements) {
  EXPECT_EQ(complaints({"specimen.shape=cylinder", "specimen.length=1 mm", "specimen.height=40 mm",
                        "specimen.elements=20"}),
            "--set specimen.elements=20: too few for specimen.length and specimen.height: the specimen is "
            "smaller than one element, 1.22017 mm across on "
            "average\n");
  EXPECT_EQ(complaints({"specimen.shape=periodic", "specimen.thickness=4 mm", "specimen.elements=20"}),
            "--set specimen.elements=20: too few: a periodic box must be wider than three elements, 12.2769 "
            "mm across on "
            "average, for none to touch its own image\n");
}

TEST(Radii, ThatContradictAreRefused) {
  EXPECT_EQ(complaints({"specimen.radii=log-normal", "specimen.radius_spread=0.6"}),
            "--set specimen.radius_spread=0.6: of log-normal radii must lie in [0, 0.4]\n");
  EXPECT_EQ(complaints({"specimen.solid_fraction=0.64", "specimen.coordination=6"}),
            "--set specimen.solid_fraction=0.64: excludes specimen.coordination (--set): give one of them\n");
  EXPECT_EQ(complaints({"calibration.radius_ratios=[0.3, 0.2]", "specimen.shape=cylinder"}),
            "--set calibration.radius_ratios=[0.3, 0.2]: 0.2: must rise\n");
}

TEST(ExpectedRadius, KnowsHowLogNormalRadiiSpread) {
  const Scene scene = shape_of({"specimen.shape=sphere", "specimen.length=10 mm", "specimen.radii=log-normal",
                                "specimen.radius_spread=0.3", "specimen.elements=1000"});
  // (4/3) pi R^3 exp(3 0.3^2) N = 0.615 (pi / 6) D^3
  EXPECT_NEAR(expected_mean_radius_m(scene), 5e-3 * std::cbrt(0.615 / 1000.0 / std::exp(0.27)), 1e-12);
}

}  // namespace
}  // namespace rift::scene
