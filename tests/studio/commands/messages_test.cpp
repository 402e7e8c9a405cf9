#include "engine/results/run_folder.hpp"
#include "tests/studio/commands/pseudo_terminal.hpp"
#include "tests/studio/commands/terminal.hpp"
#include "tests/studio/commands/tiny_plate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>

namespace rift::studio {
namespace {

namespace fs = std::filesystem;

// Some seconds of marching, so that progress is said.
constexpr const char* some_seconds = "--threads 1 --set 'crack.velocity=0.003 c_r' ";
// The same, where progress must be said on the fastest machine too.
constexpr const char* more_seconds = "--threads 1 --set 'crack.velocity=0.001 c_r' ";
// Minutes on any machine.
constexpr const char* very_long =
    "--threads 1 --set solver.dt_fraction=0.003 --set 'crack.velocity=0.01 c_r' --set output.samples=50000 ";

std::string command_of(const TinyPlate& plate, const std::string& arguments) {
  return "env " + plate.environment() + " '" RIFT_EXE "' run '" + plate.preset().string() + "' --out '" +
         plate.out().string() + "' " + arguments;
}

bool marches(const TinyPlate& plate) {
  std::error_code not_yet;
  const std::uintmax_t size = fs::file_size(plate.out() / "series.csv", not_yet);
  return !not_yet && size > 0;
}

/// The bytes of series.csv that a run whose streams are sound leaves.
std::string series_of(const TinyPlate& plate, const std::string& arguments) {
  const fs::path out = plate.path() / "whole";
  const Ran ran =
      run_rift("run '" + plate.preset().string() + "' --out '" + out.string() + "' --quiet " + arguments,
               plate.environment());
  EXPECT_EQ(ran.exit_code, 0) << ran.err;
  return read_text(out / "series.csv");
}

TEST(Messages, ThatCannotBeWrittenLeaveTheExitCodeToTheCommand) {
  for (const char* nowhere : {"2>/dev/full", "2>&-"}) {
    for (const std::string arguments : {"run no_such_preset", "--frobnicate"})
      EXPECT_EQ(run_shell("('" RIFT_EXE "' " + arguments + " " + nowhere + ")").exit_code, 2)
          << arguments << nowhere;
  }
}

TEST(Messages, ThatCannotBeWrittenLeaveTheRunAsItIs) {
  const TinyPlate plate;
  const std::string whole = series_of(plate, some_seconds);
  for (const char* nowhere : {"2>/dev/full", "2>&-", "<&- >&- 2>&-"}) {
    const Ran ran = run_shell("(" + command_of(plate, some_seconds) + "--plain --force " + nowhere + ")");
    EXPECT_EQ(ran.exit_code, 0) << nowhere;
    EXPECT_EQ(read_text(plate.out() / "series.csv"), whole) << nowhere;
    const std::string journal = read_text(plate.out() / "journal.rift");
    EXPECT_EQ(journal.find(" left, done at "), std::string::npos) << nowhere;
    EXPECT_EQ(results::inspect_run(plate.out()).condition, results::RunCondition::finished) << nowhere;
  }
}

TEST(Results, ThatCannotBePrintedAreAFailureOfTheWorldOnceTheRunIsWhole) {
  const TinyPlate plate;
  const Ran ran = run_shell(command_of(plate, ">/dev/full"));
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_EQ(ran.err, "rift: cannot write to standard output: No space left on device\n");
  EXPECT_EQ(results::inspect_run(plate.out()).condition, results::RunCondition::finished);
}

TEST(Results, ThatNobodyReadsAreAFailureOfTheWorldAndNoSignal) {
  const TemporaryFolder folder;
  const std::string code = (folder.path() / "code").string();
  const Ran ran = run_shell("{ sleep 0.3; '" RIFT_EXE "' theory; echo $? >'" + code + "'; } | true");
  EXPECT_EQ(read_text(code), "1\n");
}

TEST(TerminalGone, LetsARunWithLinesGoOnWhereSighupIsIgnored) {
  const TinyPlate plate;
  const std::string whole = series_of(plate, more_seconds);
  PseudoTerminal terminal(command_of(plate, more_seconds) + "--plain >/dev/null", SIG_IGN);
  ASSERT_TRUE(terminal.shows("crack"));
  terminal.hang_up();
  EXPECT_EQ(terminal.exit_code(), 0);
  EXPECT_EQ(read_text(plate.out() / "series.csv"), whole);
}

TEST(TerminalGone, LetsARunInThePanelGoOnWhereSighupIsIgnored) {
  const TinyPlate plate;
  const std::string whole = series_of(plate, some_seconds);
  PseudoTerminal terminal(command_of(plate, some_seconds), SIG_IGN);
  ASSERT_TRUE(terminal.reads_until([&] { return marches(plate); }));
  terminal.hang_up();
  EXPECT_EQ(terminal.exit_code(), 1) << "the table has nowhere to go";
  EXPECT_EQ(read_text(plate.out() / "series.csv"), whole);
}

TEST(TerminalGone, StopsARunWithACheckpoint) {
  for (const char* panel_or_lines : {"", "--plain"}) {
    const TinyPlate plate;
    PseudoTerminal terminal(command_of(plate, very_long) + panel_or_lines);
    ASSERT_TRUE(terminal.reads_until([&] { return marches(plate); })) << panel_or_lines;
    terminal.hang_up();
    EXPECT_EQ(terminal.exit_code(), 128 + SIGHUP) << panel_or_lines;
    EXPECT_TRUE(fs::exists(plate.out() / "checkpoint.h5")) << panel_or_lines;
    EXPECT_TRUE(fs::exists(plate.out() / "summary.json")) << panel_or_lines;
  }
}

TEST(Background, ARunStartedThereShowsLinesAndGoesOn) {
  if (!RealTerminal::there()) GTEST_SKIP() << "no tmux";
  const TinyPlate plate;
  const RealTerminal terminal(plate.path().filename().string(), "bash --norc");
  write_text(plate.path() / "command", command_of(plate, some_seconds) + " &\n");
  terminal.send("'stty tostop; . " + (plate.path() / "command").string() + "' Enter");
  EXPECT_TRUE(terminal.shows("crack "));
  EXPECT_TRUE(terminal.shows("summary.json, series.csv"));
  EXPECT_EQ(results::inspect_run(plate.out()).condition, results::RunCondition::finished);
}

TEST(Background, APanelPutThereGoesOnUnseenAndComesBackWithFg) {
  if (!RealTerminal::there()) GTEST_SKIP() << "no tmux";
  const TinyPlate plate;
  const RealTerminal terminal(plate.path().filename().string(), "bash --norc");
  write_text(plate.path() / "command", command_of(plate, very_long) + "\n");
  terminal.send("'. " + (plate.path() / "command").string() + "' Enter");
  ASSERT_TRUE(terminal.shows("running"));
  terminal.send("C-z");
  ASSERT_TRUE(terminal.shows("Stopped"));
  terminal.send("'clear; bg' Enter");
  const std::uintmax_t before = fs::file_size(plate.out() / "series.csv");
  EXPECT_TRUE(terminal.shows("run   "));
  terminal.send("'clear; jobs' Enter");
  EXPECT_TRUE(terminal.shows("Running"));
  terminal.send("'clear; fg' Enter");
  EXPECT_TRUE(terminal.shows("running"));
  EXPECT_GT(fs::file_size(plate.out() / "series.csv"), before);
  terminal.send("q");
  EXPECT_TRUE(terminal.shows("rift resume"));
}

}  // namespace
}  // namespace rift::studio
