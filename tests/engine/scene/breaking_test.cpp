#include "engine/scene/derived.hpp"
#include "engine/scene/preset.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rift::scene {
namespace {

std::string with(std::vector<std::string> overrides) {
  std::string lines;
  for (const Issue& issue : read_preset_text("", "x.toml", overrides).issues) lines += to_text(issue) + '\n';
  return lines;
}

const std::vector<std::string> cohesive{"fracture.law=cohesive", "fracture.release_rate=3 J/m2",
                                        "fracture.strength=3 MPa", "fracture.duration=50 us"};

std::vector<std::string> and_more(std::vector<std::string> some, const std::vector<std::string>& more) {
  some.insert(some.end(), more.begin(), more.end());
  return some;
}

TEST(FreeCrack, NeedsItsMaterialAndItsDuration) {
  EXPECT_EQ(with(cohesive), "");
  EXPECT_EQ(with({"fracture.law=cohesive", "fracture.strength=3 MPa"}),
            "--set fracture.law=cohesive: needs fracture.release_rate and fracture.duration as well\n");
  EXPECT_EQ(with({"fracture.law=snap", "fracture.release_rate=3 J/m2", "fracture.duration=50 us"}), "");
  EXPECT_EQ(
      with({"fracture.law=snap", "fracture.release_rate=3 J/m2", "fracture.duration=50 us",
            "fracture.strength=3 MPa"}),
      "--set fracture.strength=3 MPa: goes with fracture.law = \"cohesive\" only: a beam that snaps bears "
      "what its release rate says\n");
}

TEST(FreeCrack, KeysOfItGoWithItOnly) {
  EXPECT_EQ(with({"loading.traction=1 MPa"}),
            "--set loading.traction=1 MPa: goes with fracture.law = \"cohesive\" or \"snap\" only\n");
  EXPECT_EQ(with({"loading.rollers=true"}),
            "--set loading.rollers=true: goes with loading.traction only: the grips hold the plate\n");
}

TEST(FreeCrack, SaysWhatDoesNotGoWithItYet) {
  EXPECT_EQ(with(and_more(cohesive, {"solver.kinematics=corotational"})),
            "--set solver.kinematics=corotational: does not go with fracture.law = "
            "\"cohesive\" yet\n");
  EXPECT_NE(with(and_more(cohesive, {"crack.friction=0.3"})), "");
  EXPECT_NE(with(and_more(cohesive, {"loading.method=ramp"})), "");
  EXPECT_NE(with(and_more(cohesive, {"damping.region=all", "damping.alpha=0.1"})), "");
  EXPECT_NE(with(and_more(cohesive, {"crack.tips=2"})), "");
  EXPECT_EQ(with(and_more(cohesive, {"crack.release_order=node"})),
            "--set crack.release_order=node: does not go with fracture.law = \"cohesive\" yet\n");
  EXPECT_NE(with(and_more(cohesive, {"crack.toughness=[[\"0 c_r\", 3]]"})), "");
}

TEST(FreeCrack, IsPulledByTractionsInPlaceOfGrips) {
  const auto pulled = and_more(cohesive, {"loading.traction=1 MPa"});
  EXPECT_EQ(with(pulled), "");
  EXPECT_NE(with(and_more(pulled, {"loading.tilt=0.1"})), "");
  EXPECT_EQ(with(and_more(pulled, {"loading.grip_rotation=free"})),
            "--set loading.grip_rotation=free: goes without loading.traction, which takes the place of the "
            "grips\n");
  const Preset preset = read_preset_text("", "x.toml", pulled);
  EXPECT_TRUE(breaks_freely(preset.scene));
  EXPECT_EQ(preset.scene.loading.rise_time, 1e-6);
  // What a run writes of its preset is read again to the same scene, the keys without a say among it.
  const Preset again = read_preset_text(preset_text(preset), "again.toml");
  EXPECT_TRUE(again.issues.empty()) << to_text(again.issues.front());
  EXPECT_EQ(preset_text(again), preset_text(preset));
}

}  // namespace
}  // namespace rift::scene
