#include "engine/scene/preset.hpp"

#include "engine/scene/parameters.hpp"
#include "tests/expectations.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <type_traits>
#include <vector>

namespace rift::scene {
namespace {

/// Compares every member of two scenes, bit for bit.
void expect_same(Scene a, Scene b) {
  const auto same = [](auto x, auto y) {
    if constexpr (!std::is_same_v<decltype(x), decltype(y)>) {
      return false;
    } else if constexpr (std::is_pointer_v<decltype(x)>) {
      return *x == *y;
    } else {
      return *x.p == *y.p;
    }
  };
  for (const Parameter& row : not_empty(parameters()))
    EXPECT_TRUE(std::visit(same, row.slot(a), row.slot(b))) << row.key;
}

Scene scene_with(const std::vector<std::string>& overrides) {
  const Preset preset = read_preset_text("", "x.toml", overrides);
  for (const Issue& issue : preset.issues) ADD_FAILURE() << to_text(issue);
  return preset.scene;
}

TEST(Preset, WithoutAnyTextIsAllDefaults) {
  const Preset preset = read_preset_text("", "x.toml");
  EXPECT_TRUE(preset.issues.empty());
  EXPECT_TRUE(preset.origins.empty());
  expect_same(preset.scene, default_scene());
}

TEST(Preset, TakesSiNumbersAndTextsWithUnits) {
  const Preset preset = read_preset_text(
      "specimen.length = 0.1\n[specimen]\nheight = \"20 mm\"\nseed = 7\n[crack]\npath = 0.01\nrelaxation = "
      "3\n",
      "x.toml");
  // TOML forbids to open a table again that dotted keys made.
  ASSERT_EQ(preset.issues.size(), 1u);
  const Preset good = read_preset_text(
      "[specimen]\nlength = 0.1\nheight = \"20 mm\"\nseed = 7\n[crack]\npath = 0.01\nrelaxation = 3\n",
      "x.toml");
  EXPECT_TRUE(good.issues.empty());
  EXPECT_EQ(good.scene.specimen.length, 0.1);
  EXPECT_EQ(good.scene.specimen.height, 0.02);
  EXPECT_EQ(good.scene.specimen.seed, 7);
  EXPECT_EQ(good.scene.crack.path, (CrackLine{0.01, false}));
  EXPECT_EQ(good.scene.crack.relaxation, 3.0);
}

TEST(Preset, RemembersWhereEachKeyWasSet) {
  const Preset preset =
      read_preset_text("[specimen]\n\nlength = \"100 mm\"\n", "x.toml", {"solver.beta = 0.9"});
  EXPECT_EQ(preset.origins.size(), 2u);
  EXPECT_EQ(preset.origins.at("specimen.length").line, 3);
  EXPECT_EQ(preset.origins.at("specimen.length").file, "x.toml");
  EXPECT_EQ(preset.origins.at("solver.beta").file, "--set");
  EXPECT_EQ(preset.scene.solver.beta, 0.9);
}

TEST(Preset, GivenAlternativeTakesThePlaceOfTheDefault) {
  const Scene scene = scene_with({"specimen.thickness=3 mm", "material.density=700"});
  EXPECT_EQ(scene.specimen.thickness, 0.003);
  EXPECT_FALSE(scene.specimen.layers);
  EXPECT_EQ(scene.material.density, 700.0);
  EXPECT_FALSE(scene.material.rayleigh_speed);
}

TEST(Preset, IsReadFromAFile) {
  const auto path =
      std::filesystem::temp_directory_path() / ("rift-preset-" + std::to_string(::getpid()) + ".toml");
  std::ofstream(path) << "[specimen]\nelements = 5000\nx = 1\n";
  const Preset preset = read_preset(path, {"specimen.seed=3"});
  EXPECT_EQ(preset.scene.specimen.elements, 5000);
  EXPECT_EQ(preset.scene.specimen.seed, 3);
  ASSERT_EQ(preset.issues.size(), 1u);
  EXPECT_EQ(preset.issues[0].file, path.string());
  EXPECT_EQ(preset.issues[0].line, 3);
  std::filesystem::remove(path);
}

TEST(Override, ReplacesTheFileAndTheLastOneWins) {
  const Preset preset = read_preset_text("[specimen]\nelements = 0\nseed = 2\n", "x.toml",
                                         {"specimen.elements=100", "specimen.elements=5000"});
  EXPECT_TRUE(preset.issues.empty());  // the file's wrong value is replaced as well
  EXPECT_EQ(preset.scene.specimen.elements, 5000);
  EXPECT_EQ(preset.scene.specimen.seed, 2);
}

TEST(Override, OfTheCrackTakesAwayTheTitleThatTheFileGaveIt) {
  const std::string text =
      "[crack]\nvelocity = \"0.5 c_r\"\n[film]\ntitle = \"At half the Rayleigh speed\"\n";
  const auto title_with = [&](const std::vector<std::string>& overrides) {
    return read_preset_text(text, "x.toml", overrides).scene.film.title;
  };
  const std::string of_file = title_with({});
  EXPECT_EQ(of_file, "At half the Rayleigh speed");
  EXPECT_EQ(title_with({"crack.velocity=0.3 c_r"}), "");
  EXPECT_EQ(title_with({"material.young_modulus=3.2 GPa"}), "");
  EXPECT_EQ(title_with({"crack.velocity=0.5 c_r", "specimen.elements=2000", "film.camera=tip"}), of_file);
  EXPECT_EQ(title_with({"crack.velocity=0.3 c_r", "film.title=Mine"}), "Mine");
}

TEST(Override, TakesBareWordsQuotedTextAndLists) {
  const Scene scene =
      scene_with({"crack.velocity=0.3 c_r", "crack.technique=simple", "loading.method=\"ramp\"",
                  "output.window = [0.1, 0.3]", "solver.dt='20 ns'"});
  EXPECT_EQ(scene.crack.velocity, (std::vector<VelocityPiece>{{{0.3, true}, {}}}));
  EXPECT_EQ(scene.crack.technique, fracture::Technique::simple);
  EXPECT_EQ(scene.loading.method, LoadingMethod::ramp);
  EXPECT_EQ(scene.output.window, (std::array{0.1, 0.3}));
  EXPECT_EQ(scene.solver.dt, 2e-8);
}

TEST(IssueAt, PointsAtTheLineTheOverrideOrTheDefault) {
  const Preset preset = read_preset_text("[crack]\npath = \"0.9 H\"\n", "x.toml", {"solver.dt=1e-6"});
  EXPECT_EQ(to_text(issue_at(preset, "crack.path", "crosses no beam")),
            "x.toml:2: crack.path = \"0.9 H\": crosses no beam");
  EXPECT_EQ(to_text(issue_at(preset, "solver.dt", "too long")), "--set solver.dt=1e-6: too long");
  EXPECT_EQ(to_text(issue_at(preset, "crack.velocity", "too fast")),
            "x.toml: crack.velocity = \"0.5 c_r\" (default): too fast");
  EXPECT_EQ(to_text(issue_at(preset, "crack.end", "missing")), "x.toml: crack.end: missing");
}

TEST(PresetText, ReadsBackToTheDefaultScene) {
  const Preset again = read_preset_text(preset_text(default_scene()), "again.toml");
  for (const Issue& issue : again.issues) ADD_FAILURE() << to_text(issue);
  expect_same(again.scene, default_scene());
}

TEST(PresetText, ReadsBackToAnySceneBitForBit) {
  const Scene scene = scene_with({"specimen.length=0.30000000000000004",
                                  "specimen.height=33.3333333333 mm",
                                  "specimen.thickness=0.0031415926535897",
                                  "specimen.elements=12345",
                                  "specimen.radius_spread=0.1",
                                  "specimen.coordination=5.7",
                                  "specimen.contact_tolerance=1.01",
                                  "specimen.seed=9007199254740991",
                                  "material.young_modulus=12345678901.234567",
                                  "material.poisson_ratio=0.27",
                                  "material.plane=strain",
                                  "material.density=667.1234567890123",
                                  "material.stiffness=explicit",
                                  "material.micro_young_modulus=219 GPa",
                                  "material.micro_poisson_ratio=0.1",
                                  "material.micro_radius_ratio=0.3",
                                  "loading.displacement=1.7 mm",
                                  "loading.method=ramp",
                                  "loading.ramp_steps=17",
                                  "loading.hold_steps=0",
                                  "loading.ramp_beta=0.95",
                                  "crack.velocity=0.2 c_r until 50 mm, 1100.5 m/s",
                                  "crack.path=0.0123456789012345",
                                  "crack.start=7 mm",
                                  "crack.end=111 mm",
                                  "crack.technique=simple",
                                  "crack.relaxation=1.7",
                                  "crack.damage_zone_ratio=8",
                                  "damping.alpha=0.001",
                                  "damping.region=surface",
                                  "damping.surface_width=2.5",
                                  "solver.dt=2.35e-8",
                                  "solver.beta=0.99",
                                  "output.samples=500",
                                  "output.frames=0",
                                  "output.fields=[]",
                                  "output.window=[0.15, 0.25]"});
  const Preset again = read_preset_text(preset_text(scene), "again.toml");
  for (const Issue& issue : again.issues) ADD_FAILURE() << to_text(issue);
  expect_same(again.scene, scene);
  expect_same(read_preset_text(preset_text(scene_with({"solver.dt_fraction=0.17"})), "again.toml").scene,
              scene_with({"solver.dt_fraction=0.17"}));
}

TEST(PresetText, KeepsATitleWithQuotesAndLineBreaks) {
  Scene scene = default_scene();
  scene.film.title = "a \"crack\"\n\\ at α = 0";
  expect_same(read_preset_text(preset_text(scene), "x.toml").scene, scene);
}

TEST(PresetText, ExplainsEveryKey) {
  Scene scene = default_scene();
  scene.specimen.shape = packing::Shape::cylinder;  // which alone has a [calibration]
  const std::string text = preset_text(scene);
  for (const Parameter& row : not_empty(parameters()))
    EXPECT_NE(text.find(row.doc), std::string::npos) << row.key;
  EXPECT_NE(text.find("# thickness is not given\n"), std::string::npos);
  EXPECT_NE(text.find("\nlength = \"200 mm\"\n"), std::string::npos);
}

}  // namespace
}  // namespace rift::scene
