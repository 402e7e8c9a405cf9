#include "tests/studio/commands/tiny_plate.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace rift::studio {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

Ran accuracy(const TinyPlate& plate, const std::string& arguments = "") {
  return run_rift("accuracy '" + plate.preset().string() +
                      "' --quick --threads 1 --seeds 2 --elements 1250 --out '" + plate.out().string() +
                      "' " + arguments,
                  plate.environment());
}

std::string first_line(const fs::path& file) {
  const std::string text = read_text(file);
  return text.substr(0, text.find('\n'));
}

TEST(AccuracyCommand, PrintsErrorsAndWallTimesAndARecommendation) {
  const TinyPlate plate;
  const Ran ran = accuracy(plate, "--goal 0.5");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* part :
       {"parameter", "std. uncertainty", "total error", "efficient", "diff. to Broberg", "wall [s]",
        "0.05 of critical", "1,250 elements", "900 elements", "corotational", "another model",
        "recommended on this lattice: ", "error of the lattice: ", "lanes side by side", "(goal 0.5)",
        "elements: compared with the mean of 2 specimens"})
    EXPECT_TRUE(contains(ran.out, part));
  EXPECT_FALSE(contains(ran.out, "pre-stress"));  // --quick
}

TEST(AccuracyCommand, LeavesTableChartsAndReport) {
  const TinyPlate plate;
  const Ran ran = accuracy(plate);
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const std::string head = first_line(plate.out() / "table.csv");
  for (const char* name :
       {"knob", "variant", "error_knob", "error_converged", "error_broberg", "wall_march_s"})
    EXPECT_TRUE(contains(head, name));
  for (const char* file :
       {"charts/work_precision.png", "charts/work_precision.svg", "charts/ratio_elements.csv"})
    EXPECT_GT(fs::file_size(plate.out() / file), 100u) << file;
  const std::string report = read_text(plate.out() / "report.html");
  for (const char* part : {"<svg", "Recommended", "What is compared with what"})
    EXPECT_TRUE(contains(report, part));
  EXPECT_EQ(report.find("src="), std::string::npos);  // self-contained
}

TEST(AccuracyCommand, GoesOnFromWhatIsThere) {
  const TinyPlate plate;
  const Ran late = accuracy(plate, "--budget '0.3 s'");
  EXPECT_EQ(late.exit_code, 4);
  EXPECT_TRUE(contains(late.err, "rift accuracy: the budget ran out; "));
  EXPECT_TRUE(contains(accuracy(plate, "--no-cache").out, " reused, "));
  EXPECT_TRUE(contains(accuracy(plate).out, "\n0 computed, "));
  EXPECT_FALSE(fs::exists(plate.out() / "cache"));
}

TEST(AccuracyCommand, GivesProgramsTheSame) {
  const TinyPlate plate;
  const Ran ran = accuracy(plate, "--json --goal 0.5");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const Json result = Json::parse(ran.out);
  EXPECT_TRUE(result.at("recommended").at("wall_s").is_number());
  for (const Json& line : not_empty(result.at("lines"))) {
    EXPECT_EQ(line.at("error_converged").is_number(), line.at("knob") != "kinematics") << line;
    EXPECT_TRUE(line.at("wall_s").is_number()) << line;
  }
  for (const Json& row : not_empty(result.at("scenarios")))
    EXPECT_EQ(row.at("error_converged").is_number(), row.at("knob") != "kinematics") << row.at("variant");
}

TEST(AccuracyCommand, TellsWhatCannotBeAndGoesOn) {
  const TinyPlate plate;
  write_text(plate.preset(), read_text(plate.preset()) + "[damping]\nregion = \"all\"\nalpha = 0.2\n");
  const Ran ran = accuracy(plate);
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(contains(ran.out, "not computed: solver.dt_fraction = 0.98: makes a step of"));
}

struct AccuracyMistake {
  const char* arguments;
  const char* message;
};

class AccuracyBadInput : public testing::TestWithParam<AccuracyMistake> {};

TEST_P(AccuracyBadInput, IsRefusedWithAMessageAndNothingIsWritten) {
  const TinyPlate plate;
  const Ran ran = accuracy(plate, GetParam().arguments);
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.out, "");
  EXPECT_TRUE(contains(ran.err, GetParam().message));
  EXPECT_FALSE(fs::exists(plate.out()));
}

INSTANTIATE_TEST_SUITE_P(
    OfOptions, AccuracyBadInput,
    testing::Values(
        AccuracyMistake{"--goal 0", "--goal: Value 0 not in range"},
        AccuracyMistake{"--goal nearly", "--goal"},
        AccuracyMistake{"--elements 5", "--elements: Value 5 not in range"},
        AccuracyMistake{"--seeds 0", "--seeds: Value 0 not in range"},
        AccuracyMistake{"--budget 10", "rift accuracy: --budget 10: expected a time with its unit"},
        AccuracyMistake{"--set solver.dt=1e-12", "--yes starts it, --budget TIME computes what fits"},
        AccuracyMistake{"--set solver.dt_fraction=2", "solver.dt_fraction=2: must lie in"}),
    [](const auto& mistake) { return "Case" + std::to_string(mistake.index); });

TEST(AccuracyBadInputOfThePreset, IsAStudy) {
  const TinyPlate plate;
  write_text(plate.preset(), read_text(plate.preset()) + "[study]\nseed = [1, 2]\n");
  const Ran ran = accuracy(plate);
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(
      contains(ran.err, "holds a study: 'rift accuracy' varies one scene and takes a preset without"));
}

TEST(AccuracyOut, OfAnotherSceneOrSomethingElseIsRefused) {
  const TinyPlate plate;
  fs::create_directory(plate.out());
  write_text(plate.out() / "thesis.tex", "years of work");
  Ran ran = accuracy(plate);
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.err,
            "rift: " + plate.out().string() +
                " is not empty and holds no results of 'rift accuracy': choose another folder with --out\n");
  fs::remove(plate.out() / "thesis.tex");
  accuracy(plate, "--budget '0.1 s'");
  ran = accuracy(plate, "--set specimen.seed=9");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.err, "rift: " + plate.out().string() +
                         " holds the results of 'rift accuracy' for another scene (of " +
                         plate.preset().string() +
                         "): specimen.seed was 1, is now 9; nothing was changed: choose another folder with "
                         "--out\n");
}

TEST(AccuracyOut, OfTheSameSceneInAFileOfAnotherNameIsContinued) {
  const TinyPlate plate;
  accuracy(plate, "--budget '0.1 s'");
  const fs::path renamed = plate.preset().parent_path() / "renamed.toml";
  fs::rename(plate.preset(), renamed);
  const Ran ran = run_rift("accuracy '" + renamed.string() + "' --quick --threads 1 --out '" +
                               plate.out().string() + "' --budget '0.1 s'",
                           plate.environment());
  EXPECT_EQ(ran.exit_code, 4) << ran.err;
}

}  // namespace
}  // namespace rift::studio
