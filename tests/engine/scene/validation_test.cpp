#include "engine/scene/preset.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rift::scene {
namespace {

std::string complaints(const char* text, const std::vector<std::string>& overrides = {}) {
  std::string lines;
  for (const Issue& issue : read_preset_text(text, "x.toml", overrides).issues)
    lines += to_text(issue) + '\n';
  return lines;
}

std::string with(const std::vector<std::string>& overrides) { return complaints("", overrides); }

TEST(Contradictions, BetweenAlternativesNameBoth) {
  EXPECT_EQ(complaints(
                "[specimen]\nlayers = 2\nthickness = \"2 mm\"\n"
                "[material]\ndensity = 667\nrayleigh_speed = 2200\n[solver]\ndt = 1e-8\ndt_fraction = 0.5\n"),
            "x.toml:3: specimen.thickness = \"2 mm\": excludes specimen.layers (line 2): give one of them\n"
            "x.toml:5: material.density = 667: excludes material.rayleigh_speed (line 6): give one of them\n"
            "x.toml:8: solver.dt = 1e-08: excludes solver.dt_fraction (line 9): give one of them\n");
}

TEST(Contradictions, HoldBetweenTwoOverrides) {
  EXPECT_EQ(with({"specimen.thickness=2 mm", "specimen.layers=2"}),
            "--set specimen.thickness=2 mm: excludes specimen.layers (--set): give one of them\n");
}

TEST(Override, TakesThePlaceOfTheFilesRivalsAndSaysSo) {
  const auto notes = [](const std::string& text, const std::vector<std::string>& overrides) {
    const Preset preset = read_preset_text(text, "x.toml", overrides);
    EXPECT_TRUE(preset.issues.empty()) << to_text(preset.issues.front());
    return preset.notes;
  };
  using Notes = std::vector<std::string>;
  EXPECT_EQ(notes("[specimen]\nlayers = 2\n", {"specimen.thickness=2 mm"}),
            Notes{"--set specimen.thickness replaces specimen.layers = 2 (x.toml:2)"});
  EXPECT_EQ(notes("[specimen]\nthickness = 0.002\n", {"specimen.layers=2"}),
            Notes{"--set specimen.layers replaces specimen.thickness = 0.002 (x.toml:2)"});
  EXPECT_EQ(notes("[crack]\nvelocity = \"0.5 c_r\"\nstart = \"1 mm\"\n",
                  {"crack.history=[[0, 0.01], [1e-5, 0.014]]"}),
            (Notes{"--set crack.history replaces crack.velocity = \"0.5 c_r\" (x.toml:2)",
                   "--set crack.history replaces crack.start = \"1 mm\" (x.toml:3)"}));
  EXPECT_EQ(notes("[loading]\nforce = \"20 kN\"\n", {"loading.displacement=2 mm"}),
            Notes{"--set loading.displacement replaces loading.force = \"20 kN\" (x.toml:2)"});
  EXPECT_EQ(notes("[crack]\nvelocity = \"0.5 c_r\"\n", {"crack.velocity=0.3 c_r"}), Notes{});
}

TEST(Contradictions, DoNotAriseFromDefaults) {
  EXPECT_EQ(with({"specimen.thickness=2 mm", "material.density=667", "solver.dt=2.35e-8"}), "");
}

TEST(Contradictions, MicroKeysGoWithExplicitOnly) {
  EXPECT_EQ(with({"material.micro_young_modulus=356 GPa", "material.micro_radius_ratio=0.3"}),
            "--set material.micro_young_modulus=356 GPa: goes with material.stiffness = \"explicit\" only\n"
            "--set material.micro_radius_ratio=0.3: goes with material.stiffness = \"explicit\" only\n");
  EXPECT_EQ(with({"material.stiffness=explicit", "material.micro_young_modulus=356 GPa"}),
            "--set material.stiffness=explicit: needs material.micro_poisson_ratio and "
            "material.micro_radius_ratio as "
            "well\n");
  EXPECT_EQ(with({"material.stiffness=explicit", "material.micro_young_modulus=356 GPa",
                  "material.micro_poisson_ratio=0.3", "material.micro_radius_ratio=0.3"}),
            "");
}

TEST(Contradictions, DampingNeedsAlphaAndRegion) {
  EXPECT_EQ(with({"damping.alpha=0.001"}),
            "--set damping.alpha=0.001: damps nothing with damping.region = \"none\": choose \"surface\" or "
            "\"all\"\n");
  EXPECT_EQ(with({"damping.region=all"}),
            "--set damping.region=all: damps nothing with damping.alpha = 0: give an alpha above 0\n");
  EXPECT_EQ(with({"damping.region=all", "damping.alpha=0.001"}), "");
}

TEST(Contradictions, ThinSpecimensBlameTheKeyThatWasGiven) {
  EXPECT_EQ(
      with({"specimen.thickness=0.5 mm"}),
      "--set specimen.thickness=0.5 mm: is thinner than one element, 613.844 um across on average: make it "
      "thicker, or raise specimen.elements\n");
  EXPECT_EQ(
      with({"specimen.layers=0.9"}),
      "--set specimen.layers=0.9: a plate of 603.738 um is thinner than one element, 653.658 um across on "
      "average: make it thicker, or raise specimen.elements\n");
  EXPECT_EQ(with({"specimen.layers=1"}), "");
}

TEST(Contradictions, ElementsMustFitIntoThePlate) {
  EXPECT_EQ(complaints("[specimen]\nelements = 2\n"),
            "x.toml:2: specimen.elements = 2: too few for specimen.length and specimen.height: the plate is "
            "smaller than one element, 97.4416 mm across on "
            "average\n");
}

TEST(Contradictions, PathLiesInsideThePlate) {
  EXPECT_EQ(with({"crack.path=40 mm"}), "--set crack.path=40 mm: must lie inside the plate, (0, 40 mm)\n");
  EXPECT_EQ(with({"crack.path=0.05"}), "--set crack.path=0.05: must lie inside the plate, (0, 40 mm)\n");
  EXPECT_EQ(with({"crack.path=39 mm"}), "");
}

TEST(Contradictions, SpeedsAreHeldAgainstTheRayleighSpeed) {
  EXPECT_EQ(with({"crack.velocity=4401 m/s"}),
            "--set crack.velocity=4401 m/s: must lie in (0, 2] c_r, here (0, 4400 m/s]\n");
  EXPECT_EQ(with({"crack.velocity=4400 m/s"}), "");
  EXPECT_EQ(with({"crack.velocity=4400 m/s", "material.density=700"}),
            "--set crack.velocity=4400 m/s: must lie in (0, 2] c_r, here (0, 4295.28 m/s]\n");
}

TEST(Contradictions, StartAndEndLieInOrderOnThePlate) {
  EXPECT_EQ(with({"crack.start=200 mm"}),
            "--set crack.start=200 mm: must lie before the end of the plate, 200 mm\n");
  EXPECT_EQ(with({"crack.end=201 mm"}),
            "--set crack.end=201 mm: must not lie beyond the end of the plate, 200 mm\n");
  EXPECT_EQ(with({"crack.start=90 mm", "crack.end=90 mm"}),
            "--set crack.end=90 mm: must lie beyond crack.start = 90 mm\n");
  EXPECT_EQ(with({"crack.start=40 mm", "crack.end=80 mm"}), "");
}

TEST(Contradictions, WindowLiesOnTheCracksWay) {
  EXPECT_EQ(with({"crack.end=60 mm"}),
            "--set crack.end=60 mm: the measuring window, 40 mm to 80 mm, ends beyond crack.end = 60 mm\n");
  EXPECT_EQ(
      with({"crack.start=50 mm"}),
      "--set crack.start=50 mm: the measuring window, 40 mm to 80 mm, begins before crack.start = 50 mm\n");
  EXPECT_EQ(
      with({"output.window=[0.1, 0.5]", "crack.start=30 mm", "crack.end=90 mm"}),
      "--set output.window=[0.1, 0.5]: the measuring window, 20 mm to 100 mm, ends beyond crack.end = 90 mm\n"
      "--set output.window=[0.1, 0.5]: the measuring window, 20 mm to 100 mm, begins before crack.start = 30 "
      "mm\n");
  EXPECT_EQ(
      with({"crack.end=100 mm", "crack.velocity=0.9 c_r"}),
      "--set crack.end=100 mm: the measuring window, 80 mm to 120 mm, ends beyond crack.end = 100 mm\n");
}

TEST(Contradictions, TwoTipsMeetTheEndsOfThePlateAtHalfItsLength) {
  EXPECT_EQ(with({"crack.tips=2", "crack.start=100 mm"}),
            "--set crack.start=100 mm: must lie before the ends of the plate, 100 mm from its middle\n");
  EXPECT_EQ(with({"crack.tips=2", "crack.end=101 mm"}),
            "--set crack.end=101 mm: must not lie beyond the ends of the plate, 100 mm from its middle\n");
  EXPECT_EQ(
      with({"crack.tips=2", "output.window=[0.2, 0.6]"}),
      "--set output.window=[0.2, 0.6]: the measuring window, 40 mm to 120 mm, ends beyond the ends of the "
      "plate, 100 mm from its middle\n");
  EXPECT_EQ(with({"crack.tips=2", "output.window=[0.2, 0.5]"}), "");
}

TEST(Contradictions, TwoTipsNeedAWindowBetweenTheirZoneAndTheFirstEcho) {
  EXPECT_EQ(with({"crack.tips=2"}), "");
  // A mean radius of 0.487 mm: an empty window, one shorter than ten of them, and one of larger elements.
  EXPECT_EQ(
      with({"crack.tips=2", "crack.damage_zone_ratio=8"}),
      "--set crack.damage_zone_ratio=8: leaves two tips (crack.tips) no window: five damage zones end at a "
      "half length of 19.4883 mm, the first boundary reflection returns at 11.2623 mm, and 7.79533 mm are "
      "needed between: raise specimen.elements, or height and length, or give output.window\n");
  EXPECT_EQ(
      with({"crack.tips=2", "crack.damage_zone_ratio=3.5"}),
      "--set crack.damage_zone_ratio=3.5: leaves two tips (crack.tips) no window: five damage zones end at a "
      "half length of 8.52614 mm, the first boundary reflection returns at 11.2623 mm, and 4.87208 mm are "
      "needed between: raise specimen.elements, or height and length, or give output.window\n");
  EXPECT_EQ(with({"crack.tips=2", "crack.technique=simple", "specimen.elements=5000"}),
            "--set specimen.elements=5000: leaves two tips (crack.tips) no window: five mean radii end at a "
            "half length of 4.87208 mm, the first boundary reflection returns at 11.2623 mm, and 9.74416 mm "
            "are needed between: raise specimen.elements, or height and length, or give output.window\n");
  EXPECT_EQ(with({"crack.tips=2", "crack.damage_zone_ratio=8", "output.window=[0.1, 0.2]"}), "");
  EXPECT_EQ(with({"crack.tips=2", "crack.velocity=0.2 c_r until 20 mm, 0.6 c_r"}),
            "--set crack.velocity=0.2 c_r until 20 mm, 0.6 c_r: changes along the path, so two tips have no "
            "default window: give output.window\n");
}

TEST(Contradictions, GriffithsReferenceGoesWithTwoTips) {
  EXPECT_EQ(with({"output.g_i0_reference=griffith"}),
            "--set output.g_i0_reference=griffith: goes with crack.tips = 2 only, because it is the "
            "reference of a central crack\n");
  EXPECT_EQ(with({"output.g_i0_reference=griffith", "crack.tips=2"}), "");
  EXPECT_EQ(with({"output.g_i0_reference=griffith", "crack.tips=3"}),
            "--set crack.tips=3: must lie in [1, 2]\n");
}

TEST(Contradictions, UntilsLieOnTheCracksWay) {
  EXPECT_EQ(with({"crack.velocity=0.2 c_r until 100 mm, 0.6 c_r"}),
            "--set crack.velocity=0.2 c_r until 100 mm, 0.6 c_r: 'until 100 mm' lies outside the crack's "
            "path, 0 m to 80 mm\n");
  EXPECT_EQ(with({"crack.velocity=0.2 c_r until 60 mm, 0.6 c_r"}), "");
}

TEST(Contradictions, AreNotBuiltOnValuesThatAreWrongThemselves) {
  EXPECT_EQ(with({"specimen.length=-1", "crack.end=300 mm"}),
            "--set specimen.length=-1: must lie in (0, 100] m\n");
  EXPECT_EQ(with({"material.density=nan", "crack.velocity=9000 m/s"}),
            "--set material.density=nan: must be a finite number\n");
}

}  // namespace
}  // namespace rift::scene
