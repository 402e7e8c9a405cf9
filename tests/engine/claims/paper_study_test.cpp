#include "engine/claims/claims.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace rift::claims {
namespace {

scene::Preset paper_preset(const std::string& text) {
  scene::Preset preset = scene::read_preset_text(text, "x.toml");
  for (const scene::Issue& issue : preset.issues) ADD_FAILURE() << scene::to_text(issue);
  return preset;
}

const std::string velocities = "[study]\nseed = [1, 2]\ncrack_velocity = ";

TEST(PaperStudy, HoldsASharedScenarioOnce) {
  const PaperStudy merged = merge_presets({{"a", paper_preset(velocities + R"(["0.2 c_r", "0.5 c_r"])")},
                                           {"b", paper_preset(velocities + R"(["0.5 c_r", "0.8 c_r"])")}},
                                          Effort::full);
  EXPECT_EQ(merged.preset.study.size(), 6u);
  EXPECT_EQ(merged.of.at("a"), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(merged.of.at("b"), (std::vector<int>{1, 4, 3, 5}));
}

TEST(PaperStudy, NamesAllAxesInEveryRow) {
  const PaperStudy merged = merge_presets({{"a", paper_preset(velocities + R"(["0.2 c_r"])")}}, Effort::full);
  ASSERT_EQ(merged.preset.study.size(), 2u);
  const auto& axes = merged.preset.study[1].axes;
  EXPECT_NE(std::find(axes.begin(), axes.end(), std::pair<std::string, std::string>("path", "0.5 H")),
            axes.end());
  EXPECT_NE(std::find(axes.begin(), axes.end(), std::pair<std::string, std::string>("seed", "2")),
            axes.end());
}

TEST(PaperStudy, TakesASingleRunWithBothStiffnesses) {
  const PaperStudy merged = merge_presets({{"a", paper_preset("")}}, Effort::full);
  ASSERT_EQ(merged.preset.study.size(), 2u);
  EXPECT_EQ(merged.preset.study[0].scene.material.stiffness, scene::StiffnessChoice::bulk);
  EXPECT_EQ(merged.preset.study[1].scene.material.stiffness, scene::StiffnessChoice::in_situ);
  EXPECT_EQ(merged.preset.study[1].scene.output.frames, 0);
}

TEST(PaperStudy, QuickIsTheWholePlateWithAFourthOfTheElements) {
  const PaperStudy merged =
      merge_presets({{"a", paper_preset("[study]\nelements = [5000, 20000, 80000]\n")}}, Effort::quick);
  ASSERT_EQ(merged.preset.study.size(), 2u);  // 80,000 are left out
  EXPECT_EQ(merged.preset.study[0].scene.specimen.elements, 1250);
  EXPECT_EQ(merged.preset.study[1].scene.specimen.elements, 5000);
  EXPECT_EQ(plate_elements(Effort::quick), 5000);
}

TEST(PaperStudy, QuickTakesTheSlowestCrackThroughOneSpecimen) {
  const PaperStudy merged =
      merge_presets({{"a", paper_preset(velocities + R"(["0.01 c_r", "0.05 c_r"])")}}, Effort::quick);
  EXPECT_EQ(merged.preset.study.size(), 3u);
}

TEST(PaperStudy, QuickRampsInTheSameTime) {
  const PaperStudy merged = merge_presets(
      {{"a", paper_preset("[loading]\nmethod = \"ramp\"\n[solver]\ndt = \"2e-8 s\"\n")}}, Effort::quick);
  const scene::Scene& scene = merged.preset.study.at(0).scene;
  EXPECT_NEAR(*scene.solver.dt, 8e-8, 1e-20);
  EXPECT_EQ(scene.loading.ramp_steps, 5000);
  EXPECT_EQ(scene.loading.hold_steps, 2500);
}

}  // namespace
}  // namespace rift::claims
