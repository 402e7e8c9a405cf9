#include "engine/scene/preset.hpp"
#include "tests/expectations.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace rift::scene {
namespace {
namespace fs = std::filesystem;

std::vector<fs::path> shipped() {
  std::vector<fs::path> paths;
  for (const auto& file : fs::directory_iterator(fs::path(RIFT_SOURCE_DIR) / "presets"))
    if (file.path().extension() == ".toml") paths.push_back(file.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

TEST(ShippedPresets, HaveNoIssues) {
  EXPECT_FALSE(shipped().empty());
  for (const fs::path& path : shipped())
    for (const Issue& issue : read_preset(path).issues) ADD_FAILURE() << to_text(issue);
}

/// The paper's studies are its figures from the sixth to the fifteenth and its sections; what stands before
/// are single runs, what comes after are calibrations.
bool is_study(const fs::path& path) {
  const std::string name = path.stem().string();
  return (name.starts_with("fig") && name >= "fig06" && name < "fig16") || name.starts_with("sec");
}

TEST(ShippedPresets, OfThePaperHaveThreeSpecimensOfBothStiffnesses) {
  int studies = 0;
  for (const fs::path& path : shipped()) {
    if (!is_study(path)) continue;
    ++studies;
    const Preset preset = read_preset(path);
    int of_seed[4] = {}, bulk = 0;
    for (const StudyRow& row : not_empty(preset.study)) {
      ASSERT_TRUE(row.scene.specimen.seed >= 1 && row.scene.specimen.seed <= 3) << path;
      ++of_seed[row.scene.specimen.seed];
      if (row.scene.material.stiffness == StiffnessChoice::bulk) ++bulk;
    }
    EXPECT_GT(of_seed[1], 0) << path;
    EXPECT_EQ(of_seed[1], of_seed[2]) << path;
    EXPECT_EQ(of_seed[1], of_seed[3]) << path;
    EXPECT_EQ(2 * bulk, static_cast<int>(preset.study.size())) << path;
  }
  EXPECT_GT(studies, 10);
}

// What two figures both show is computed once where the whole scene is the same to the last key.
TEST(ShippedPresets, OfThePaperShareTheirScenarios) {
  std::vector<std::string> scenes;
  int listed = 0;
  for (const fs::path& path : shipped()) {
    if (!is_study(path)) continue;
    for (const StudyRow& row : read_preset(path).study) scenes.push_back(preset_text(row.scene)), ++listed;
  }
  std::sort(scenes.begin(), scenes.end());
  scenes.erase(std::unique(scenes.begin(), scenes.end()), scenes.end());
  // 12 velocities x (2 techniques + 2 dampings + 2 relaxations + 2 lengths of the zone), 2 x 11 for the
  // elements, 6 for the time step, 5 for the longer plate, 6 for the paths; x 3 specimens x 2 stiffnesses
  EXPECT_EQ(scenes.size(), 6u * (12 * 8 + 22 + 6 + 5 + 6));
  EXPECT_GT(listed, 1500);
}

}  // namespace
}  // namespace rift::scene
