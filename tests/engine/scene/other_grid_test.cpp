#include "engine/base/files.hpp"
#include "engine/scene/preset.hpp"
#include "tests/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rift::scene {
namespace {

/// A preset of two scenarios of the grid and one more.
struct OtherGrid : testing::Test {
  TemporaryFolder folder;
  std::filesystem::path path = folder.path() / "x.toml";
  OtherGrid() { base::write_whole_file(path, "[study]\nseed = [1, 2]\n[[study.rows]]\nlayers = 1\n"); }
};

TEST_F(OtherGrid, TakesThePlaceOfTheFilesOwn) {
  const Preset other = read_preset(path, {"crack.damage_zone_ratio=3"},
                                   {{"crack_velocity", {"0.3 c_r", "\"0.4 c_r\"", "0.5 c_r"}}});
  for (const Issue& issue : other.issues) ADD_FAILURE() << to_text(issue);
  ASSERT_EQ(other.study.size(), 4u);  // the row stays
  EXPECT_EQ(other.study[1].axes.front(), (std::pair<std::string, std::string>("crack_velocity", "0.4 c_r")));
  EXPECT_EQ(other.study[2].scene.crack.damage_zone_ratio, 3);
  EXPECT_EQ(other.study[3].scene.specimen.layers, 1);
  ASSERT_EQ(other.grid.size(), 1u);
  EXPECT_EQ(other.grid[0].values, (std::vector<std::string>{"\"0.3 c_r\"", "\"0.4 c_r\"", "\"0.5 c_r\""}));
}

TEST_F(OtherGrid, MayBeNone) {
  EXPECT_EQ(read_preset(path, {}).study.size(), 3u);
  EXPECT_EQ(read_preset(path, {}, {}).study.size(), 1u);
  base::write_whole_file(path, "[study]\nseed = [1, 2]\n");
  const Preset scene = read_preset(path, {}, {});
  EXPECT_TRUE(scene.issues.empty());
  EXPECT_TRUE(scene.study.empty());
}

TEST_F(OtherGrid, IsCheckedAsTheFilesOwn) {
  const Preset wrong =
      read_preset(path, {}, {{"seed", {"1", "1"}}, {"relaxation", {"linaer"}}, {"layers", {}}});
  std::string keys;
  for (const Issue& issue : wrong.issues) keys += issue.key + " ";
  EXPECT_EQ(keys, "study.seed crack.relaxation study.layers ");
  base::write_whole_file(path, "[[lanes]]\ntechnique = \"simple\"\n");
  const Preset both = read_preset(path, {}, {{"seed", {"1", "2"}}});
  ASSERT_EQ(both.issues.size(), 1u);
  EXPECT_NE(both.issues[0].text.find("[[lanes]] beside [study] (line 3)"), std::string::npos)
      << both.issues[0].text;
}

std::string complaints(const Preset& preset) {
  std::string lines;
  for (const Issue& issue : preset.issues) lines += to_text(issue) + '\n';
  return lines;
}

TEST_F(OtherGrid, MayBeSetAxisByAxis) {
  const Preset set = read_preset(path, {"study.seed=[7, 8, 9]", "study.crack_velocity=[\"0.3 c_r\", 0.4]"});
  EXPECT_EQ(complaints(set),
            "--set crack.velocity=0.4: needs a speed with its unit, such as \"0.5 c_r\" or \"1100 m/s\"\n");
  const Preset other = read_preset(path, {"study.seed=[7, 8, 9]", "study.crack_velocity=[\"0.3 c_r\"]"});
  EXPECT_EQ(complaints(other), "");
  ASSERT_EQ(other.study.size(), 4u);  // the row stays
  EXPECT_EQ(other.study[0].scene.specimen.seed, 7u);
  ASSERT_EQ(other.grid.size(), 2u);
  EXPECT_EQ(other.grid[1].name, "crack_velocity");
  base::write_whole_file(path, "");
  EXPECT_EQ(read_preset(path, {"study.seed=[1, 2]"}).study.size(), 2u);
}

TEST_F(OtherGrid, NamesTheOptionThatIsWrong) {
  EXPECT_EQ(complaints(read_preset(path, {"study.sed=[1]"})),
            "--set study.sed=[1]: unknown axis 'sed', did you mean 'seed'?\n");
  EXPECT_EQ(complaints(read_preset(path, {"study.seed=3"})),
            "--set study.seed=3: expected a list of values: write seed = [3]\n");
  EXPECT_EQ(complaints(read_preset(path, {"study.seed=[1, 2]", "specimen.seed=3"})),
            "--set specimen.seed=3: varied by --set study.seed: change it there\n");
  base::write_whole_file(path, "[[lanes]]\ntechnique = \"simple\"\n");
  EXPECT_EQ(complaints(read_preset(path, {"study.seed=[1, 2]"})),
            "--set study.seed=[1, 2]: a preset has lanes or a study, and this one has [[lanes]] (line 1)\n");
}

}  // namespace
}  // namespace rift::scene
