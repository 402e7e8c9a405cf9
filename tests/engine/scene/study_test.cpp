#include "engine/scene/parameters.hpp"
#include "engine/scene/preset.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rift::scene {
namespace {

Preset sound(const std::string& text, const std::vector<std::string>& overrides = {}) {
  Preset preset = read_preset_text(text, "x.toml", overrides);
  for (const Issue& issue : preset.issues) ADD_FAILURE() << to_text(issue);
  return preset;
}

/// One line per scenario: its values, and the names of the axes first.
std::string axes_of(const Preset& preset) {
  std::string names, out;
  for (const StudyRow& row : preset.study) {
    std::string line, heads;
    for (const auto& [name, text] : row.axes) {
      heads += (heads.empty() ? "" : " ") + name;
      line += (line.empty() ? "" : " | ") + text;
    }
    if (heads != names) out += heads + '\n';
    names = heads;
    out += line + '\n';
  }
  return out;
}

/// All that a scene holds, one line per key.
std::string all_of(const Scene& scene) {
  std::string out;
  for (const Parameter& row : parameters()) out += toml_value(scene, row) + '\n';
  return out;
}

void expect_same_scenarios(const Preset& a, const Preset& b) {
  ASSERT_EQ(a.study.size(), b.study.size());
  ASSERT_EQ(a.lanes.size(), b.lanes.size());
  for (std::size_t i = 0; i < a.study.size(); ++i) {
    EXPECT_EQ(all_of(a.study[i].scene), all_of(b.study[i].scene)) << "scenario " << i;
    EXPECT_EQ(a.study[i].axes, b.study[i].axes) << "scenario " << i;
  }
  for (std::size_t i = 0; i < a.lanes.size(); ++i)
    EXPECT_EQ(all_of(a.lanes[i]), all_of(b.lanes[i])) << "lane " << i;
}

TEST(Study, IsEmptyWithoutItsTable) {
  EXPECT_TRUE(sound("").study.empty());
  EXPECT_TRUE(sound("").lanes.empty());
}

TEST(Study, IsAllCombinationsTheFirstListVaryingSlowest) {
  const Preset preset = sound("[study]\nseed = [3, 1]\ncrack_velocity = [\"0.3 c_r\", \"1100 m/s\"]\n");
  EXPECT_EQ(axes_of(preset), "seed crack_velocity\n3 | 0.3 c_r\n3 | 1100 m/s\n1 | 0.3 c_r\n1 | 1100 m/s\n");
  ASSERT_EQ(preset.study.size(), 4u);
  EXPECT_EQ(preset.study[2].scene.specimen.seed, 1);
  EXPECT_EQ(preset.study[2].scene.crack.velocity.front().speed, (Speed{0.3, true}));
  EXPECT_EQ(preset.scene.specimen.seed, default_scene().specimen.seed);
}

TEST(Study, OnOneLineKeepsTheOrderOfTheFileToo) {
  EXPECT_EQ(axes_of(sound("study = { seed = [1, 2], beta = [1, 0.9] }\n")),
            "seed beta\n1 | 1\n1 | 0.9\n2 | 1\n2 | 0.9\n");
}

TEST(Study, HasOneSimpleScenarioForAllDamageZones) {
  const Preset preset = sound(
      "[crack]\nrelaxation = \"quadratic\"\n[study]\ndamage_zone_ratio = [2, 4]\ntechnique = [\"simple\", "
      "\"progressive\"]\nrelaxation = [\"linear\", 0.7]\n");
  EXPECT_EQ(axes_of(preset),
            "damage_zone_ratio technique relaxation\n- | simple | -\n2 | progressive | linear\n"
            "2 | progressive | 0.7\n4 | progressive | linear\n4 | progressive | 0.7\n");
  ASSERT_FALSE(preset.study.empty());
  EXPECT_EQ(preset.study[0].scene.crack.damage_zone_ratio, 1.0);  // as in the base
  EXPECT_EQ(preset.study[0].scene.crack.relaxation, 2.0);
}

TEST(Study, HasOneUndampedScenarioForAllRegionsAndAlphas) {
  const Preset preset =
      sound("[study]\ndamping_region = [\"none\", \"surface\", \"all\"]\ndamping_alpha = [0, 0.001, 0.01]\n");
  EXPECT_EQ(axes_of(preset),
            "damping_region damping_alpha\nnone | 0\nsurface | 0.001\nsurface | 0.01\nall | 0.001\nall | "
            "0.01\n");
}

TEST(Study, OfOneDampingAxisSettlesTheOther) {
  const Preset regions = sound("[damping]\nalpha = 0.01\n[study]\ndamping_region = [\"none\", \"all\"]\n");
  ASSERT_EQ(regions.study.size(), 2u);
  EXPECT_EQ(regions.study[0].scene.damping.alpha, 0.0);
  EXPECT_EQ(regions.study[1].scene.damping.alpha, 0.01);
  const Preset alphas = sound("[damping]\nregion = \"all\"\n[study]\ndamping_alpha = [0, 0.01]\n");
  ASSERT_EQ(alphas.study.size(), 2u);
  EXPECT_EQ(alphas.study[0].scene.damping.region, DampingRegion::none);
  EXPECT_EQ(alphas.study[1].scene.damping.region, DampingRegion::all);
}

TEST(StudyRows, TakeWhatTheyDoNotNameFromTheBase) {
  const Preset preset = sound(
      "[crack]\nrelaxation = \"square-root\"\n[[study.rows]]\nlayers = 3\n[[study.rows]]\nbeta = 0.9\n"
      "layers = 1\n");
  EXPECT_EQ(axes_of(preset), "beta layers\n1 | 3\n0.9 | 1\n");
  ASSERT_EQ(preset.study.size(), 2u);
  EXPECT_EQ(preset.study[1].scene.crack.relaxation, 0.5);
}

TEST(StudyRows, ComeAfterTheGrid) {
  const Preset preset = sound(
      "[study]\nseed = [1, 2]\n[[study.rows]]\nelements = 5000\nseed = 7\n[[study.rows]]\nlength = \"100 "
      "mm\"\n");
  EXPECT_EQ(axes_of(preset),
            "seed elements length\n1 | 20000 | 200 mm\n2 | 20000 | 200 mm\n7 | 5000 | 200 mm\n"
            "1 | 20000 | 100 mm\n");
}

TEST(StudyRows, KeepThePlaceOfAnAxisThatTheFirstOneLeavesOut) {
  EXPECT_EQ(axes_of(sound("[[study.rows]]\ntechnique = \"simple\"\nseed = 2\n[[study.rows]]\n"
                          "technique = \"progressive\"\nrelaxation = 2\ndamage_zone_ratio = 4\nseed = 2\n")),
            "technique relaxation damage_zone_ratio seed\nsimple | - | - | 2\nprogressive | quadratic | 4 | "
            "2\n");
}

TEST(StudyRows, MayBeWrittenOnOneLine) {
  EXPECT_EQ(axes_of(sound("[study]\nrows = [{technique = \"simple\", beta = 0.9}, {beta = 0.8}]\n")),
            "technique beta\nsimple | 0.9\nprogressive | 0.8\n");
}

TEST(StudyRows, WithoutAlphaOrRegionAreUndamped) {
  const Preset preset = sound(
      "[damping]\nalpha = 0.01\nregion = \"all\"\n[[study.rows]]\ndamping_alpha = 0\n[[study.rows]]\n"
      "damping_alpha = 0.02\n");
  ASSERT_EQ(preset.study.size(), 2u);
  EXPECT_EQ(preset.study[0].scene.damping.region, DampingRegion::none);
  EXPECT_EQ(preset.study[1].scene.damping.region, DampingRegion::all);
}

TEST(Lanes, AreTheBaseWithTheirValuesInPlace) {
  const Preset preset =
      sound("[[lanes]]\ntechnique = \"simple\"\n[[lanes]]\ncrack_velocity = \"0.3 c_r\"\nrelaxation = 3\n");
  ASSERT_EQ(preset.lanes.size(), 2u);
  EXPECT_EQ(preset.lanes[0].crack.technique, fracture::Technique::simple);
  EXPECT_EQ(preset.lanes[0].crack.velocity, default_scene().crack.velocity);
  EXPECT_EQ(preset.lanes[1].crack.technique, fracture::Technique::progressive);
  EXPECT_EQ(preset.lanes[1].crack.velocity, (std::vector<VelocityPiece>{{{0.3, true}, {}}}));
  EXPECT_EQ(preset.lanes[1].crack.relaxation, 3.0);
  EXPECT_TRUE(preset.study.empty());
}

TEST(Overrides, ChangeWhatScenariosStartFrom) {
  const Preset preset = sound("[study]\nseed = [1, 2]\n", {"specimen.elements=5000"});
  ASSERT_EQ(preset.study.size(), 2u);
  EXPECT_EQ(preset.study[1].scene.specimen.elements, 5000);
  const Preset ensemble = sound("[[lanes]]\nrelaxation = 2\n", {"solver.beta=0.9"});
  ASSERT_EQ(ensemble.lanes.size(), 1u);
  EXPECT_EQ(ensemble.lanes[0].solver.beta, 0.9);
}

TEST(PresetText, WritesStudiesThatReadBack) {
  for (const char* text :
       {"[study]\nseed = [3, 1]\ncrack_velocity = [\"0.3 c_r\", \"0.2 c_r until 50 mm, 1100.5 m/s\"]\n",
        "[study]\ntechnique = [\"simple\", \"progressive\"]\nrelaxation = [\"linear\", 0.7]\n"
        "damage_zone_ratio = [2, 4]\nseed = [1, 2]\n",
        "[study]\ndamping_region = [\"none\", \"all\"]\ndamping_alpha = [0, 0.001]\n[[study.rows]]\n"
        "technique = \"simple\"\n",
        "[damping]\nregion = \"all\"\n[study]\ndamping_alpha = [0, 0.01]\n",
        "[[study.rows]]\ndt_fraction = 0.1\nbeta = 0.9\n[[study.rows]]\nlength = 0.30000000000000004\n"}) {
    const Preset preset = sound(text);
    EXPECT_FALSE(preset.study.empty());
    expect_same_scenarios(preset, sound(preset_text(preset)));
  }
}

TEST(PresetText, WritesAStudyAsItsGridAndItsRows) {
  const std::string text =
      preset_text(sound("[study]\ntechnique = [\"simple\", \"progressive\"]\nrelaxation = [\"linear\", 0.7]\n"
                        "[[study.rows]]\nrelaxation = 3\n"));
  EXPECT_TRUE(
      text.ends_with("\n[study]\ntechnique = [\"simple\", \"progressive\"]\n"
                     "relaxation = [\"linear\", 0.7]\n\n[[study.rows]]\ntechnique = \"progressive\"\n"
                     "relaxation = 3\n"))
      << text;
}

TEST(Study, KeepsTheCombinationsThatEachScenarioStandsFor) {
  const Preset preset = sound(
      "[study]\ntechnique = [\"simple\", \"progressive\"]\ndamage_zone_ratio = [1, 2]\n"
      "[[study.rows]]\ndamage_zone_ratio = 3\n");
  ASSERT_EQ(preset.study.size(), 4u);
  using Combinations = std::vector<std::vector<std::string>>;
  EXPECT_EQ(preset.study[0].combinations, (Combinations{{"simple", "1"}, {"simple", "2"}}));
  EXPECT_EQ(preset.study[2].combinations, (Combinations{{"progressive", "2"}}));
  EXPECT_TRUE(preset.study[3].combinations.empty());
  ASSERT_EQ(preset.grid.size(), 2u);
  EXPECT_EQ(preset.grid[0].name, "technique");
  EXPECT_EQ(preset.grid[1].values, (std::vector<std::string>{"1", "2"}));
}

TEST(PresetText, WritesLanesThatReadBack) {
  for (const char* text :
       {"[[lanes]]\ntechnique = \"simple\"\n[[lanes]]\ncrack_velocity = \"0.3 c_r\"\nrelaxation = 3\n",
        "[[lanes]]\ntechnique = \"progressive\"\n",
        "[damping]\nregion = \"all\"\n[[lanes]]\ndamping_alpha = 0\n[[lanes]]\ndamping_alpha = 0.01\n"}) {
    const Preset preset = sound(text);
    EXPECT_FALSE(preset.lanes.empty());
    expect_same_scenarios(preset, sound(preset_text(preset)));
  }
}

TEST(PresetText, WritesOnlyAxesThatAreVaried) {
  const std::string text =
      preset_text(sound("[[lanes]]\ntechnique = \"simple\"\n[[lanes]]\nrelaxation = 2\n"));
  EXPECT_TRUE(
      text.ends_with("\n[[lanes]]\ntechnique = \"simple\"\n\n[[lanes]]\ntechnique = "
                     "\"progressive\"\nrelaxation = \"quadratic\"\n"))
      << text;
  EXPECT_EQ(preset_text(sound("")), preset_text(default_scene()));
}

}  // namespace
}  // namespace rift::scene
