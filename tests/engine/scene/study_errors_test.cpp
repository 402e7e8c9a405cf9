#include "engine/scene/preset.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rift::scene {
namespace {

std::string complaints_of_study(const std::string& text, const std::vector<std::string>& overrides = {}) {
  std::string lines;
  for (const Issue& issue : read_preset_text(text, "x.toml", overrides).issues)
    lines += to_text(issue) + '\n';
  return lines;
}

TEST(StudyErrors, AreAllReportedAtOnceInTheOrderOfTheFile) {
  EXPECT_EQ(
      complaints_of_study(
          "[study]\ntechnique = \"simple\"\nlayers = []\nseed = [1, 2, 1]\n"
          "damge_zone_ratio = [1]\nelements = [5000, \"many\", 0]\ncrack_velocity = [0.5, \"5 c_r\"]\n"
          "[[study.rows]]\n[[study.rows]]\nbeta = 2\nalpha = 1\n"),
      "x.toml:2: study.technique = \"simple\": expected a list of values: write technique = "
      "[\"simple\"]\n"
      "x.toml:3: study.layers = []: needs at least one value\n"
      "x.toml:4: study.seed = [1, 2, 1]: 1 twice\n"
      "x.toml:5: unknown axis 'damge_zone_ratio', did you mean 'damage_zone_ratio'?\n"
      "x.toml:6: specimen.elements = \"many\": expected a whole number, got text\n"
      "x.toml:6: specimen.elements = 0: must lie in [2, 5000000]\n"
      "x.toml:7: crack.velocity = 0.5: needs a speed with its unit, such as \"0.5 c_r\" or \"1100 m/s\"\n"
      "x.toml:7: crack.velocity = \"5 c_r\": must lie in (0, 2] c_r\n"
      "x.toml:8: [[study.rows]] is empty: name an axis and its value\n"
      "x.toml:10: solver.beta = 2: must lie in (0, 1]\n"
      "x.toml:11: unknown axis 'alpha', did you mean 'damping_alpha'?\n");
}

TEST(StudyErrors, NameWhatIsNoListOrTable) {
  EXPECT_EQ(complaints_of_study("[study.layers]\nx = 1\n"),
            "x.toml:1: study.layers = (a table): expected a list of values, got a table\n");
  EXPECT_EQ(complaints_of_study("[study]\nrows = 3\n"),
            "x.toml:2: study.rows = 3: expected tables [[study.rows]], got a whole number\n");
  EXPECT_EQ(complaints_of_study("[study]\nrows = []\n"),
            "x.toml:2: study.rows = []: expected tables [[study.rows]], got an empty list\n");
  EXPECT_EQ(complaints_of_study("study = 3\nlanes = [{relaxation = 2}, 1]\n"),
            "x.toml:1: study = 3: expected a table [study], got a whole number\n"
            "x.toml:2: lanes = [(a table), 1]: expected tables [[lanes]], got a list with something else\n"
            "x.toml:2: [[lanes]] beside [study] (line 1): a preset has one or the other\n");
  EXPECT_EQ(complaints_of_study("[[study]]\nseed = [1]\n"),
            "x.toml:1: a study is one table: write [study]\n");
  EXPECT_EQ(complaints_of_study("[lanes]\nrelaxation = 2\n"),
            "x.toml:1: lanes are a list of tables: write [[lanes]]\n");
  EXPECT_EQ(complaints_of_study("[study]\n"),
            "x.toml:1: [study] names no axis: write one list of values per axis, or [[study.rows]]\n");
}

TEST(StudyErrors, FindOneValueInTwoSpellings) {
  EXPECT_EQ(complaints_of_study("[study]\nrelaxation = [\"linear\", 2, 1.0]\n"),
            "x.toml:2: study.relaxation = [\"linear\", 2, 1]: \"linear\" and 1 are the same value\n");
}

TEST(StudyErrors, FindRowsThatAreOneScenario) {
  EXPECT_EQ(complaints_of_study("[study]\nseed = [1, 2]\n[[study.rows]]\nseed = 3\n[[study.rows]]\nseed = 3\n"
                                "[[study.rows]]\nseed = 2\n"),
            "x.toml:5: the same scenario as in line 3\n"
            "x.toml:7: the same scenario as in the grid\n");
  EXPECT_EQ(
      complaints_of_study("[[study.rows]]\ntechnique = \"simple\"\ndamage_zone_ratio = 2\n[[study.rows]]\n"
                          "technique = \"simple\"\n[[study.rows]]\ndamage_zone_ratio = 2\n"),
      "x.toml:4: the same scenario as in line 1\n");
}

TEST(StudyErrors, FindContradictionsAtTheLineOfTheListOrRow) {
  EXPECT_EQ(
      complaints_of_study("[specimen]\nthickness = \"3 mm\"\n[study]\nlayers = [1, 2]\nseed = [1, 2]\n"),
      "x.toml:2: specimen.thickness = \"3 mm\": excludes specimen.layers (line 4): give one of them\n");
  EXPECT_EQ(complaints_of_study("[study]\nlayers = [0.9, 2]\nseed = [1, 2]\n"),
            "x.toml:2: specimen.layers = 0.9: a plate of 603.738 um is thinner than one element, 653.658 um "
            "across on average: make it thicker, or raise specimen.elements\n");
  EXPECT_EQ(
      complaints_of_study("[[study.rows]]\ndamping_alpha = 0.01\ndamping_region = \"none\"\n[[study.rows]]\n"
                          "damping_alpha = 0\ndamping_region = \"all\"\n"),
      "x.toml:2: damping.alpha = 0.01: damps nothing with damping.region = \"none\": choose \"surface\" "
      "or \"all\"\n"
      "x.toml:6: damping.region = \"all\": damps nothing with damping.alpha = 0: give an alpha above 0\n");
  EXPECT_EQ(
      complaints_of_study("[study]\ndamping_alpha = [0, 0.01]\n"),
      "x.toml:2: damping.alpha = 0.01: damps nothing with damping.region = \"none\": choose \"surface\" "
      "or \"all\"\n");
}

TEST(StudyErrors, OfTheBaseAreReportedOnce) {
  EXPECT_EQ(
      complaints_of_study("[crack]\npath = \"50 mm\"\n[specimen]\nlength = -1\n[study]\nseed = [1, 2, 3]\n"),
      "x.toml:2: crack.path = \"50 mm\": must lie inside the plate, (0, 40 mm)\n"
      "x.toml:4: specimen.length = -1: must lie in (0, 100] m\n");
  EXPECT_EQ(complaints_of_study("[crack]\npath = \"50 mm\"\n[study]\nsed = [1, 2, 3]\n"),
            "x.toml:2: crack.path = \"50 mm\": must lie inside the plate, (0, 40 mm)\n"
            "x.toml:4: unknown axis 'sed', did you mean 'seed'?\n");
}

TEST(StudyErrors, AreNotBuiltOnValuesThatAreWrongThemselves) {
  EXPECT_EQ(complaints_of_study(
                "[study]\nlength = [-1]\ncrack_velocity = [\"0.3 c_r\"]\n[[study.rows]]\nelements = 1\n"),
            "x.toml:2: specimen.length = -1: must lie in (0, 100] m\n"
            "x.toml:5: specimen.elements = 1: must lie in [2, 5000000]\n");
}

TEST(StudyErrors, FindValuesThatNoScenarioHas) {
  EXPECT_EQ(complaints_of_study(
                "[crack]\ntechnique = \"simple\"\n[study]\ndamage_zone_ratio = [1, 2]\nseed = [1, 2]\n"),
            "x.toml:4: study.damage_zone_ratio = [1, 2]: 1 applies to no scenario: all have technique = "
            "\"simple\"\n");
  EXPECT_EQ(complaints_of_study("[study]\ndamping_region = [\"none\"]\ndamping_alpha = [0, 0.01]\n"),
            "x.toml:3: study.damping_alpha = [0, 0.01]: 0.01 applies to no scenario: all have damping_region "
            "= \"none\"\n");
  EXPECT_EQ(complaints_of_study("[study]\ndamping_region = [\"none\", \"all\"]\ndamping_alpha = [0]\n"),
            "x.toml:2: study.damping_region = [\"none\", \"all\"]: \"all\" applies to no scenario: all have "
            "damping_alpha = 0\n");
  EXPECT_EQ(complaints_of_study("[[study.rows]]\ntechnique = \"simple\"\nrelaxation = 2\n"),
            "x.toml:3: study.rows.relaxation = 2: applies to no scenario: all have technique = \"simple\"\n");
  EXPECT_EQ(complaints_of_study("[crack]\ntechnique = \"simple\"\n[[lanes]]\nrelaxation = 2\n"),
            "x.toml:4: lanes.relaxation = 2: applies to no scenario: all have technique = \"simple\"\n");
}

TEST(StudyErrors, LimitTheNumberOfScenarios) {
  std::string seeds = "0";
  for (int i = 1; i <= 100; ++i) seeds += ", " + std::to_string(i);
  const std::string samples = seeds.substr(seeds.find("10"));
  EXPECT_EQ(complaints_of_study("[study]\nseed = [" + seeds + "]\nsamples = [" + samples +
                                ", 101, 102, 103, 104, 105, 106, 107, 108, 109, 110]\n"),
            "x.toml:2: 10201 scenarios, the limit is 10000: leave out some values\n");
  std::string rows;
  for (int i = 0; i <= 10000; ++i) rows += "[[study.rows]]\nseed = " + std::to_string(i) + "\n";
  EXPECT_EQ(complaints_of_study(rows),
            "x.toml:1: 10001 scenarios, the limit is 10000: leave out some values\n");
}

TEST(LaneErrors, NameWhatLanesShare) {
  EXPECT_EQ(
      complaints_of_study("[[lanes]]\nrelaxation = 2\nelements = 5000\n[[lanes]]\nbetta = 1\n"),
      "x.toml:3: lanes.elements = 5000: lanes share one lattice and one step: they may differ in "
      "technique, relaxation, damage_zone_ratio, damping_alpha, damping_region, crack_velocity and friction "
      "only\n"
      "x.toml:5: unknown axis 'betta', did you mean 'beta'?\n");
}

TEST(LaneErrors, AreThoseOfTheKeysThemselves) {
  EXPECT_EQ(
      complaints_of_study("[[lanes]]\ncrack_velocity = 0.5\n[[lanes]]\n[[lanes]]\ndamping_region = \"al\"\n"
                          "[[lanes]]\ndamping_alpha = 0.1\n"),
      "x.toml:2: crack.velocity = 0.5: needs a speed with its unit, such as \"0.5 c_r\" or \"1100 m/s\"\n"
      "x.toml:3: [[lanes]] is empty: name an axis and its value\n"
      "x.toml:5: damping.region = \"al\": must be \"none\", \"surface\" or \"all\"\n"
      "x.toml:7: damping.alpha = 0.1: damps nothing with damping.region = \"none\": choose \"surface\" "
      "or \"all\"\n");
}

TEST(LaneErrors, FindLanesThatAreOneScenario) {
  EXPECT_EQ(complaints_of_study("[[lanes]]\nrelaxation = 2\n[[lanes]]\nrelaxation = \"quadratic\"\n"),
            "x.toml:3: the same scenario as in line 1\n");
}

TEST(LaneErrors, ForbidAStudyBesideThem) {
  EXPECT_EQ(complaints_of_study("[study]\nseed = [1, 2]\n\n[[lanes]]\nrelaxation = 2\n"),
            "x.toml:4: [[lanes]] beside [study] (line 1): a preset has one or the other\n");
}

TEST(OverrideErrors, NameWhatStudyAndLanesVary) {
  EXPECT_EQ(complaints_of_study("[study]\nseed = [1, 2]\n[[study.rows]]\nlayers = 1\n",
                                {"specimen.seed=3", "specimen.layers=2", "solver.beta=0.9"}),
            "--set specimen.seed=3: varied by the study (line 2): change it there\n"
            "--set specimen.layers=2: varied by the study (line 4): change it there\n");
  EXPECT_EQ(complaints_of_study("[[lanes]]\nrelaxation = 2\n", {"crack.relaxation=3"}),
            "--set crack.relaxation=3: varied by the lanes (line 2): change it there\n");
}

}  // namespace
}  // namespace rift::scene
