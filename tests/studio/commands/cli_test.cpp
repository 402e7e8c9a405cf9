#include "tests/studio/run_rift.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <regex>
#include <string>

namespace rift::studio {
namespace {

TEST(CommandLine, HelpGoesToStdoutAndIsNoError) {
  for (const std::string arguments : {"--help", "-h", "theory --help", "list --help"}) {
    const Ran ran = run_rift(arguments);
    EXPECT_EQ(ran.exit_code, 0) << arguments;
    EXPECT_TRUE(contains(ran.out, "Usage: rift")) << arguments;
    EXPECT_EQ(ran.err, "") << arguments;
  }
}

TEST(CommandLine, VersionNamesBuildCompilerInstructionSetCommitAndLibraries) {
  const Ran ran = run_rift("--version");
  EXPECT_EQ(ran.exit_code, 0);
  const std::regex expected(
      "rift [0-9]+\\.[0-9]+\\.[0-9]+ \\((optimised, asserts off|asserts on); "
      "(GCC|Clang) [^;]+; (AVX-512|AVX2|AVX|baseline)\\)\n"
      "commit     (unknown|[0-9a-f]+ of [0-9]{4}-[0-9]{2}-[0-9]{2}(, changed)?)\n"
      "libraries  Eigen [0-9.]+, HDF5 [0-9.]+, fmt [0-9.]+, toml\\+\\+ [0-9.]+, CLI11 [0-9.]+, "
      "nlohmann-json [0-9.]+(, VTK [0-9.]+)?\n");
  EXPECT_TRUE(std::regex_match(ran.out, expected)) << ran.out;
  EXPECT_EQ(ran.err, "");
}

TEST(CommandLine, AnUnknownCommandIsAUsageErrorWithAHint) {
  const Ran ran = run_rift("thory");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(ran.err, "rift: The following argument was not expected: thory\nTry 'rift --help'.\n");
}

TEST(CommandLine, AnUnknownOptionPointsToTheHelpOfItsCommand) {
  const Ran ran = run_rift("list --frobnicate");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.err,
            "rift list: The following argument was not expected: --frobnicate\nTry 'rift list --help'.\n");
}

TEST(CommandLine, OneCommandAtATime) { EXPECT_EQ(run_rift("theory list").exit_code, 2); }

TEST(CommandLine, AFullDiskUnderStdoutIsAFailureOfTheWorld) {
  const Ran ran = run_rift("theory >/dev/full");
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_EQ(ran.err, "rift: cannot write to standard output: No space left on device\n");
}

TEST(Color, IsAbsentFromPipesUnlessAskedFor) {
  const std::string escape = "\033[";
  EXPECT_FALSE(contains(run_rift("theory").out, escape));
  EXPECT_FALSE(contains(run_rift("theory --color never").out, escape));
  EXPECT_TRUE(contains(run_rift("theory --color always", "NO_COLOR=1").out, escape));
  EXPECT_FALSE(contains(run_rift("theory --color always --csv").out, escape));
}

// script(1) gives the command a terminal of its own.
TEST(Color, OnATerminalGivesWayToNoColor) {
  const auto on_terminal = [](const std::string& environment) {
    return run_shell("env " + environment + " script -qec \"'" RIFT_EXE "' theory\" /dev/null");
  };
  if (std::system("command -v script >/dev/null 2>&1") != 0) GTEST_SKIP() << "no script(1) here";
  EXPECT_TRUE(contains(on_terminal("-u NO_COLOR").out, "\033["));
  EXPECT_TRUE(contains(on_terminal("NO_COLOR=").out, "\033["));
  EXPECT_FALSE(contains(on_terminal("NO_COLOR=1").out, "\033["));
}

TEST(Color, KnowsThreeAnswers) {
  const Ran ran = run_rift("list --color sometimes");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(contains(ran.err, "rift list: --color: sometimes not in {auto,always,never}\n"));
}

}  // namespace
}  // namespace rift::studio
