#include "engine/base/files.hpp"
#include "tests/studio/commands/study_table.hpp"
#include "tests/studio/commands/tiny_study.hpp"

#include <nlohmann/json.hpp>

#include <regex>
#include <string>
#include <vector>

namespace rift::studio {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

TEST(StudyCommand, LeavesTableChartsAndReport) {
  const TinyStudy plate;
  const Ran ran = plate.study();
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  for (const char* name :
       {"G_ID/G_I0 ± along the window", "difference to Broberg", "run time [s]", "simple",
        "mean ± scatter between specimens", "G_ID/G_I0 ± between specimens", "8 computed, 0 reused"})
    EXPECT_TRUE(contains(ran.out, name));
  EXPECT_TRUE(contains(ran.err, "[8/8]"));
  EXPECT_EQ(table_in(plate.out()).size(), 8U);
  for (const char* file : {"study.json", "charts/ratio_velocity.svg", "charts/ratio_velocity.png",
                           "charts/ratio_tip.csv", "charts/ratio_tip.gp", "charts/work_precision.svg"})
    EXPECT_GT(fs::file_size(plate.out() / file), 100U) << file;
  const std::string report = read_text(plate.out() / "report.html");
  for (const char* part :
       {"<svg", "Difference to Broberg against run time", "This study holds no converged reference",
        "± between specimens", "Fixed parameters", "specimen.height", "Left out", "CPU", "rift study "})
    EXPECT_TRUE(contains(report, part));
  EXPECT_EQ(report.find("src="), std::string::npos);  // self-contained
  const Ran again = plate.study();
  EXPECT_TRUE(contains(again.out, "0 computed, 8 reused"));
}

TEST(StudyCommand, AgreesWithTheRunOfOneOfItsScenarios) {
  const TinyStudy plate;
  ASSERT_EQ(plate.study().exit_code, 0);
  const Json scenarios = Json::parse(plate.study("--json").out).at("scenarios");
  const TinyPlate alone;
  ASSERT_EQ(alone.run("--set crack.technique=simple --set specimen.seed=2").exit_code, 0);
  const Json run = Json::parse(read_text(alone.out() / "summary.json")).at("scenarios")[0];
  const Json& row = scenarios.at(3);
  EXPECT_EQ(row.at("axes"), Json({{"technique", "simple"}, {"crack_velocity", "0.5 c_r"}, {"seed", "2"}}));
  for (const char* name : {"ratio", "ratio_fracture", "g_i0_j_m2", "energy_elastic_j", "ledger_residual"})
    EXPECT_EQ(row.at(name), run.at(name)) << name;
}

// Some seconds of work, cut short at moments that fall into packing, pre-stress and crack.
TEST(StudyCommand, KilledAtAnyMomentGivesTheSameTable) {
  const TinyStudy plate(CacheOf::this_test);
  const std::string slower = "--threads 1 --set solver.dt_fraction=0.02";
  ASSERT_EQ(plate.study(slower + " --no-cache").exit_code, 0);
  const fs::path folder = plate.path() / "killed";
  int kills = 0;
  for (const char* after : {"0.15", "0.4", "0.9", "1.3", "0.6"})
    if (plate.study_under(std::string("timeout -s KILL ") + after, slower, folder).exit_code == 137) ++kills;
  EXPECT_GT(kills, 1);
  const Ran ran = plate.study_under("", slower, folder);
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_EQ(table_in(folder), table_in(plate.out()));
}

TEST(StudyCommand, StopsInGoodOrderAndGoesOn) {
  const TinyStudy plate;
  // As soon as it has begun, however slow the machine is.
  const std::string begun =
      "while [ ! -e '" + (plate.out() / "study.json").string() + "' ]; do sleep 0.05; done";
  const Ran ran = run_shell("{ env " + plate.environment() + " '" RIFT_EXE "' " +
                            plate.command("--set solver.dt_fraction=0.001", plate.out()) + " & study=$!; " +
                            begun + "; kill -INT $study; wait $study; exit $?; }");
  EXPECT_EQ(ran.exit_code, 130);
  EXPECT_TRUE(contains(ran.err, "rift study: stopped; the same command continues from here\n"));
  const Ran late = plate.study("--set solver.dt_fraction=0.001 --budget '0.5 s'");
  EXPECT_EQ(late.exit_code, 4);
  EXPECT_TRUE(contains(late.err, "rift study: the budget ran out; the same command continues from here\n"));
  EXPECT_TRUE(contains(late.out, "not computed yet"));
  EXPECT_FALSE(contains(late.out, "report.html")) << "an interrupted study names no file that is not there";
  EXPECT_FALSE(fs::exists(plate.out() / "report.html"));
}

TEST(StudyCommand, CommandsOfRunsSayOfAStudyWhatItIs) {
  const TinyStudy plate;
  ASSERT_EQ(plate.study("--quiet").exit_code, 0);
  const std::string folder = "'" + plate.out().string() + "'";
  for (const std::string& command : {"export " + folder + " --to csv", "verify " + folder, "resume " + folder,
                                     "measure " + folder, "watch " + folder})
    if (const Ran ran = run_rift(command, plate.environment()); !contains(ran.err, "built without")) {
      EXPECT_EQ(ran.exit_code, 2) << command;
      EXPECT_TRUE(contains(ran.err, plate.out().string() + ": holds a study, not a run: ")) << ran.err;
      EXPECT_TRUE(contains(ran.err, "'rift study PRESET --out " + plate.out().string() + "'")) << ran.err;
    }
  EXPECT_FALSE(fs::exists(plate.out() / "measure"));
}

TEST(StudyCommand, ReportsWhatCouldNotBeMadeAndAllTheRest) {
  const TinyStudy plate;
  std::string text = read_text(plate.preset());
  text.replace(text.find("seed = [1, 2]"), 13, "layers = [1, 2]");
  write_text(plate.preset(), text);
  const Ran stopped = plate.study("--quiet --budget '0.001 s'");
  EXPECT_EQ(stopped.exit_code, 4) << "a stop is a stop, whatever could not be made: " << stopped.err;
  const Ran ran = plate.study("--quiet");
  EXPECT_EQ(ran.exit_code, 6);
  EXPECT_TRUE(contains(ran.err, "rift study: 4 of 8 scenarios could not be made\n")) << ran.err;
  for (const char* part :
       {"could not be made\n", "a coordination of 5.7 is out of reach", "4 computed",
        "specimen.coordination = 4.8 or less is within reach, and so is 5.7 from two layers on",
        "table.csv, report.html, charts, runs"})
    EXPECT_TRUE(contains(ran.out, part)) << part << ran.out;
  EXPECT_EQ(table_in(plate.out()).size(), 4U);
  EXPECT_TRUE(contains(read_text(plate.out() / "report.html"), "Scenarios that could not be made"));
  const auto json = nlohmann::json::parse(plate.study("--quiet --json").out);
  EXPECT_EQ(json.at("not_made")[0].at("rows").size(), 4U);
}

TEST(StudyCommand, GathersShards) {
  const TinyStudy plate;
  const Ran first = plate.study("--shard 2/2");
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_TRUE(contains(first.out, "4 of 8 scenarios are not computed yet"));
  const Ran second = plate.study("--shard 1/2");
  EXPECT_TRUE(contains(second.out, "4 computed, 4 reused"));
  for (const char* name : {"table.csv", "report.html", "charts"})  // left to the call that gathers
    EXPECT_FALSE(fs::exists(plate.out() / name)) << name;
  const Ran all = plate.study();
  EXPECT_TRUE(contains(all.out, "0 computed, 8 reused"));
  EXPECT_EQ(table_in(plate.out()).size(), 8U);
}

// The Slurm array of docs/studies.md, all of its parts at once, and with them two calls for the whole.
TEST(StudyCommand, PartsThatRunAtOnceDoNotDisturbEachOther) {
  const TinyStudy plate;
  std::string script;
  for (int k = 1; k <= 4; ++k)
    script += "(env " + plate.environment() + " '" RIFT_EXE "' " +
              plate.command("--quiet --yes --threads 1 " +
                                (k <= 2 ? "--shard " + std::to_string(k) + "/2" : std::string()),
                            plate.out()) +
              " >/dev/null; echo rc $?) & ";
  const Ran ran = run_shell("bash -c \"" + script + "wait\"");
  EXPECT_EQ(ran.out, "rc 0\nrc 0\nrc 0\nrc 0\n") << ran.err;
  EXPECT_EQ(table_in(plate.out()).size(), 8U);
  EXPECT_TRUE(contains(read_text(plate.out() / "report.html"), "</html>"));
  for (const auto& entry : fs::recursive_directory_iterator(plate.out()))
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();
}

TEST(StudyCommand, ThatWasStoppedNamesOnlyWhatIsThere) {
  const TinyStudy plate;
  const Ran ran = plate.study("--set solver.dt_fraction=0.001 --budget '0.5 s'");
  ASSERT_EQ(ran.exit_code, 4);
  for (const char* name : {"table.csv", "report.html", "charts"})
    EXPECT_EQ(ran.out.find(name) != std::string::npos, fs::exists(plate.out() / name)) << name << ran.out;
}

TEST(StudyCommand, RemovesWhatAKilledProcessHasLeft) {
  const TinyStudy plate;
  ASSERT_EQ(plate.study().exit_code, 0);
  const Ran gone = run_shell("sh -c 'echo $$'");
  const std::string name = base::temporary_name(plate.out() / "runs" / "a.json").filename().string();
  const std::string dead = std::regex_replace(name, std::regex("-[0-9]+-([0-9a-f]{8})"),
                                              "-" + std::to_string(std::stoi(gone.out)) + "-$1");
  write_text(plate.out() / "runs" / dead, "half");
  ASSERT_EQ(plate.study().exit_code, 0);
  EXPECT_FALSE(fs::exists(plate.out() / "runs" / dead));
}

struct StudyMistake {
  const char* arguments;
  const char* message;
};

class StudyBadInput : public testing::TestWithParam<StudyMistake> {};

TEST_P(StudyBadInput, IsRefusedWithAMessageAndNothingIsWritten) {
  const TinyStudy plate;
  const Ran ran = plate.study(GetParam().arguments);
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.out, "");
  EXPECT_TRUE(contains(ran.err, GetParam().message));
  EXPECT_FALSE(fs::exists(plate.out()));
}

INSTANTIATE_TEST_SUITE_P(
    OfTheIssue, StudyBadInput,
    testing::Values(StudyMistake{"--shard 3/2", "rift study: --shard 3/2: the index must lie in 1 to 2\n"},
                    StudyMistake{"--shard 0/2", "rift study: --shard 0/2: the index must lie in 1 to 2\n"},
                    StudyMistake{"--shard 1/0", "rift study: --shard 1/0: there must be at least 1 part\n"},
                    StudyMistake{"--shard half", "rift study: --shard half: expected i/n, such as 2/8\n"},
                    StudyMistake{"--shard 1/2x", "rift study: --shard 1/2x: expected i/n, such as 2/8\n"},
                    StudyMistake{"--budget 10", "rift study: --budget 10: expected a time with its unit"},
                    StudyMistake{"--budget '-1 s'",
                                 "rift study: --budget -1 s: expected a time with its unit"},
                    StudyMistake{"--set solver.dt_fraction=1e-5",
                                 "--yes starts them, --budget TIME computes what fits\n"},
                    StudyMistake{"--set specimen.seed=3", "varied by the study"}),
    [](const auto& mistake) { return "Case" + std::to_string(mistake.index); });

TEST(StudyBadInputOfThePreset, WithoutAStudySaysHowToWriteOne) {
  const TinyPlate plate;
  const Ran ran = run_rift("study '" + plate.preset().string() + "' --out '" + plate.out().string() + "'");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(contains(ran.err, "holds no [study]: write a table [study] with a list of values per axis"));
  EXPECT_FALSE(fs::exists(plate.out()));
}

TEST(StudyOut, OfAFolderWithSomethingElseIsRefused) {
  const TinyStudy plate;
  fs::create_directory(plate.out());
  write_text(plate.out() / "thesis.tex", "years of work");
  const Ran ran = plate.study();
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.err, "rift: " + plate.out().string() +
                         " is not empty and holds no study: choose another folder with --out\n");
}

TEST(Run, SendsAStudyToItsCommand) {
  const TinyStudy plate;
  const Ran ran = plate.run();
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.err, plate.preset().string() + ": holds a study of 8 scenarios: 'rift study " +
                         plate.preset().string() + "' computes it\n");
}

TEST(StudyFolder, IsNamedAsSuchByCommandsThatWantARun) {
  const TinyStudy plate;
  ASSERT_EQ(plate.study("--shard 1/8").exit_code, 0);
  for (const std::string command : {"verify", "watch", "resume", "measure", "export --to csv"}) {
    const Ran ran = run_rift(command + " '" + plate.out().string() + "'");
    if (contains(ran.err, "built without")) continue;
    EXPECT_EQ(ran.exit_code, 2) << command;
    EXPECT_TRUE(contains(ran.err, "holds a study, not a run")) << command << ran.err;
  }
}

TEST(StudyCommand, PrintsItsGridAsItsPreset) {
  const TinyStudy plate;
  const Ran ran = plate.study("--print-config");
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_TRUE(contains(ran.out, "[study]\ntechnique = [\"simple\", \"progressive\"]\n"));
  EXPECT_FALSE(contains(ran.out, "[[study.rows]]"));
}

TEST(StudyCommand, SaysWhatItsScenariosLeaveOut) {
  const TinyStudy plate;
  const Ran ran = plate.study("--plain");
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  EXPECT_TRUE(
      contains(ran.out, "left out: damping, numerical damping, damage zone (4 of 8 scenarios), ramp"));
  EXPECT_TRUE(contains(read_text(plate.out() / "report.html"), "damage zone: 4 of 8 scenarios"));
  EXPECT_TRUE(
      table_in(plate.out()).at(0).at("left_out").starts_with("damping numerical_damping damage_zone "));
}

TEST(RunLanes, GivesOneScenarioPerLane) {
  const TinyPlate plate;
  write_text(plate.preset(),
             read_text(plate.preset()) +
                 "[[lanes]]\ntechnique = \"simple\"\n[[lanes]]\ntechnique = \"progressive\"\n");
  ASSERT_EQ(plate.run().exit_code, 0);
  const Json scenarios = Json::parse(read_text(plate.out() / "summary.json")).at("scenarios");
  ASSERT_EQ(scenarios.size(), 2U);
  EXPECT_EQ(scenarios[0].at("technique"), "simple");
  EXPECT_EQ(scenarios[1].at("technique"), "progressive");
  EXPECT_TRUE(contains(plate.run("--print-config").out, "[[lanes]]"));
}

}  // namespace
}  // namespace rift::studio
