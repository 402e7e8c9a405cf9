#include "tests/studio/commands/tiny_plate.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <regex>
#include <sstream>
#include <string>

namespace rift::studio {
namespace {

TEST(List, ShowsNameCommandCostAndLineInAlignedColumns) {
  const TemporaryFolder folder;
  write_text(folder.path() / "small.toml", "# A small plate\n# Cost: 10 s\n\n# Not this line\n[specimen]\n");
  write_text(
      folder.path() / "large_plate.toml",
      "# A large plate\r\n# Cost: an hour on two cores\r\n[output]\nframes = 0\nsamples = 10\n[study]\n"
      "seed = [1, 2]\n");
  write_text(folder.path() / "notes.txt", "# No preset\n# Cost: none\n");
  const Ran ran = run_rift("list", presets_at(folder.path()));
  EXPECT_EQ(ran.exit_code, 0);
  EXPECT_EQ(ran.err, "");
  const std::regex expected(
      "preset +command +cost +disk +shows\n"
      "large_plate  study    an hour on two cores +0 MB +A large plate\n"
      "small        run      10 s +[0-9]+ MB +A small plate\n");
  EXPECT_TRUE(std::regex_match(ran.out, expected)) << ran.out;
}

TEST(List, NamesTheCommandThatTakesEachPreset) {
  const auto all = nlohmann::json::parse(run_rift("list --json", presets_at(RIFT_SOURCE_DIR "/presets")).out);
  std::map<std::string, std::string> command;
  for (const auto& preset : all) command[preset.at("name")] = preset.at("command");
  EXPECT_EQ(command.at("quickstart"), "run");
  EXPECT_EQ(command.at("teach_damping"), "run");
  EXPECT_EQ(command.at("study_release"), "study");
  EXPECT_EQ(command.at("experiment_polymer"), "experiment");
  EXPECT_EQ(command.at("fig17_calibration"), "calibrate");
  for (const auto& [name, takes] : command) EXPECT_NE(takes, "") << name;
}

TEST(List, BeginsWithTheUsersOwn) {
  const TemporaryFolder folder;
  const std::filesystem::path own = folder.path() / "data" / "rift" / "presets";
  std::filesystem::create_directories(own);
  std::filesystem::create_directories(folder.path() / "shipped");
  write_text(own / "mine.toml", "# My plate\n# Cost: 3 s\n");
  write_text(folder.path() / "shipped" / "a_plate.toml", "# A plate\n# Cost: 3 s\n");
  const std::string environment =
      presets_at(folder.path() / "shipped") + " XDG_DATA_HOME='" + (folder.path() / "data").string() + "'";
  EXPECT_EQ(run_rift("list --names", environment).out, "mine\na_plate\n");
  const auto all = nlohmann::json::parse(run_rift("list --json", environment).out);
  EXPECT_EQ(all.at(0).at("own"), true);
  EXPECT_EQ(all.at(1).at("own"), false);
  EXPECT_TRUE(contains(run_rift("list", environment).out, "(own) My plate"));
}

TEST(List, TellsTheDiskThatCheckTells) {
  const TinyPlate plate;
  std::string text = read_text(plate.preset());
  write_text(plate.preset(), text.replace(text.find("frames = 4"), 10, "frames = 60"));
  const auto listed = nlohmann::json::parse(run_rift("list --json", presets_at(plate.path())).out);
  const auto checked = nlohmann::json::parse(plate.check("--json").out);
  const double bytes = checked.at("disk_estimate_bytes").get<double>();
  EXPECT_NEAR(listed.at(0).at("disk_estimate_bytes").get<double>(), bytes, 0.1 * bytes);
}

// script(1) gives the command a terminal of its own.
TEST(List, OnANarrowTerminalPutsWhatAPresetShowsUnderIt) {
  if (std::system("command -v script >/dev/null 2>&1") != 0) GTEST_SKIP() << "no script(1) here";
  const Ran ran = run_shell("env NO_COLOR=1 " + presets_at(RIFT_SOURCE_DIR "/presets") +
                            " script -qec \"stty cols 80; '" RIFT_EXE "' list\" /dev/null");
  EXPECT_TRUE(contains(ran.out, "\r\n    Broberg's problem: a crack that opens "));
  std::istringstream lines(ran.out);
  const auto begins_letter = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
  for (std::string line; std::getline(lines, line);)
    EXPECT_LE(std::count_if(line.begin(), line.end(), begins_letter), 81) << line;  // with its \r
}

TEST(List, GivesTheSameAsJson) {
  const TemporaryFolder folder;
  write_text(folder.path() / "small.toml", "# A \"small\" plate\n# Cost: 10 s\n");
  const Ran ran = run_rift("list --json", presets_at(folder.path()));
  ASSERT_EQ(ran.exit_code, 0);
  const auto all = nlohmann::json::parse(ran.out);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all.at(0).at("name"), "small");
  EXPECT_EQ(all.at(0).at("path"), (folder.path() / "small.toml").string());
  EXPECT_EQ(all.at(0).at("shows"), "A \"small\" plate");
  EXPECT_EQ(all.at(0).at("cost"), "10 s");
}

TEST(List, LeavesEmptyWhatAPresetDoesNotSay) {
  const TemporaryFolder folder;
  write_text(folder.path() / "mute.toml", "[specimen]\n# Cost: not in the opening\n");
  const auto all = nlohmann::json::parse(run_rift("list --json", presets_at(folder.path())).out);
  EXPECT_EQ(all.at(0).at("shows"), "");
  EXPECT_EQ(all.at(0).at("cost"), "");
}

TEST(List, OfAMissingFolderIsAFailureOfTheWorld) {
  const Ran ran = run_rift("list", "RIFT_PRESETS=/nowhere/presets");
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(ran.err, "rift: cannot list the presets in /nowhere/presets: No such file or directory\n");
}

TEST(List, EveryShippedPresetSaysWhatItShowsAndCosts) {
  const Ran ran = run_rift("list --json", presets_at(RIFT_SOURCE_DIR "/presets"));
  ASSERT_EQ(ran.exit_code, 0) << ran.err;
  const auto all = nlohmann::json::parse(ran.out);
  EXPECT_FALSE(all.empty());
  for (const auto& preset : all) {
    EXPECT_NE(preset.at("shows"), "") << preset.at("name");
    EXPECT_NE(preset.at("cost"), "") << preset.at("name");
  }
}

}  // namespace
}  // namespace rift::studio
