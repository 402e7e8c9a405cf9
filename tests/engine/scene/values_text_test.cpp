#include "engine/scene/values_text.hpp"

#include "engine/scene/preset.hpp"

#include <gtest/gtest.h>

namespace rift::scene {
namespace {

TEST(ValuesText, NamesEachValueThatCountsAndNoDoc) {
  const std::string text = values_text(default_scene());
  EXPECT_TRUE(text.starts_with("specimen.")) << text;
  EXPECT_NE(text.find("\nspecimen.elements = 20000\n"), std::string::npos) << text;
  EXPECT_EQ(text.find('#'), std::string::npos) << text;
  for (const Parameter& row : parameters()) EXPECT_EQ(text.find(row.doc), std::string::npos) << row.key;
}

TEST(ValuesText, DiffersWhereAnyParameterDiffers) {
  const std::string standard = values_text(default_scene());
  for (const char* change : {"specimen.seed=2", "crack.velocity=0.31 c_r", "output.samples=77",
                             "film.title=A", "solver.dt_fraction=0.3", "crack.damage_zone_ratio=3"}) {
    const Preset other = read_preset_text("", "x.toml", {change});
    ASSERT_TRUE(other.issues.empty()) << to_text(other.issues.front());
    EXPECT_NE(values_text(other.scene), standard) << change;
  }
}

TEST(ValuesText, LeavesOutWhatDoesNotCount) {
  const Preset pulled = read_preset_text("", "x.toml", {"loading.force=100 N"}),
               both = read_preset_text("", "x.toml", {"loading.force=100 N", "calibration.elements=3000"});
  EXPECT_EQ(values_text(pulled.scene).find("loading.displacement"), std::string::npos);
  EXPECT_EQ(values_text(pulled.scene), values_text(both.scene)) << "beams of this scene need no calibration";
  const auto of_specimen = [](const Parameter& row) { return row.key == "specimen.seed"; };
  EXPECT_EQ(values_text(pulled.scene, of_specimen), "specimen.seed = 1\n");
}

}  // namespace
}  // namespace rift::scene
