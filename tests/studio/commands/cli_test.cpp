#include "tests/studio/run_rift.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

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
  EXPECT_EQ(ran.err, "rift: 'thory' is not expected, did you mean 'theory'?\nTry 'rift --help'.\n");
  EXPECT_EQ(run_rift("stud").err,
            "rift: 'stud' is not expected, did you mean 'study'?\nTry 'rift --help'.\n");
  EXPECT_EQ(run_rift("frobnicate").err, "rift: 'frobnicate' is not expected\nTry 'rift --help'.\n");
}

TEST(CommandLine, AMisspeltOptionNamesTheNearestOfItsCommand) {
  EXPECT_EQ(run_rift("run quickstart --budgt 3").exit_code, 2);
  EXPECT_EQ(run_rift("run quickstart --budgt 3").err,
            "rift run: there is no option '--budgt', did you mean '--budget'?\nTry 'rift run --help'.\n");
}

TEST(CommandLine, ParametersAndOptionsThatAreTakenForEachOtherAreNamed) {
  const auto says = [](const std::string& arguments, const std::string& text) {
    const Ran ran = run_rift("run quickstart " + arguments);
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_TRUE(ran.err.starts_with(text)) << ran.err;
  };
  says("--elements 3",
       "rift run: there is no option '--elements': --set specimen.elements=VALUE sets this "
       "parameter\nTry");
  says("--film.boundaries=true",
       "rift run: there is no option '--film.boundaries=true': --set "
       "film.boundaries=true sets this parameter\nTry");
  says("crack.velocity=3",
       "rift run: 'crack.velocity=3' is not expected, did you mean '--set "
       "crack.velocity=3'?\nTry");
  says("extra --bogus", "rift run: 'extra' is not expected\nrift run: there is no option '--bogus'\nTry");
  says("--set threads=3",
       "--set threads=3: unknown key 'threads': docs/parameters.md lists them all; "
       "'--threads' is an option of run\n");
  says("--set crack.damagezone=2",
       "--set crack.damagezone=2: unknown key 'crack.damagezone', did you mean "
       "'crack.damage_zone_ratio'?\n");
}

TEST(CommandLine, ShortOptionsAreTheLongOnes) {
  EXPECT_EQ(run_rift("-V").out, run_rift("--version").out);
  EXPECT_EQ(run_rift("list -j").out, run_rift("list --json").out);
  for (const std::string command : {"run", "experiment", "pack", "measure", "compare", "stability"}) {
    const std::string help = run_rift(command + " --help").out;
    for (const char* names : {"-o,--out FOLDER", "-f,--force", "-q,--quiet", "-j,--json"})
      EXPECT_TRUE(contains(help, names)) << command << ": " << names;
  }
}

/// The names of all commands of this build, as a shell completes them.
std::vector<std::string> all_commands() {
  std::vector<std::string> names;
  const std::string text = run_rift("completion fish").out;
  const std::regex name("__fish_use_subcommand -f -a ([a-z]+) -d '(.*)'");
  for (auto it = std::sregex_iterator(text.begin(), text.end(), name); it != std::sregex_iterator(); ++it)
    if (!contains(it->str(2), "not in this build")) names.push_back(it->str(1));
  return names;
}

TEST(Help, FitsEightyColumnsSaysWhatValuesAreAndEndsWithExamplesCodesAndVariables) {
  EXPECT_GT(all_commands().size(), 18U);
  for (const std::string& command : all_commands()) {
    const std::string help = run_rift(command + " --help").out;
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);)
      EXPECT_LE(std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; }), 80)
          << line;
    EXPECT_FALSE(contains(help, " TEXT")) << command;
    for (const char* part :
         {"Examples:\n  ", "Exit codes:\n", "128+n", "RIFT_SIMD", "NO_COLOR", "XDG_CACHE_HOME"})
      EXPECT_TRUE(contains(help, part)) << command << ": " << part;
  }
}

TEST(Cli, RefusesAnInstructionSetThatIsNone) {
  const Ran ran = run_rift("list", "RIFT_SIMD=AVX3");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.err, "rift: RIFT_SIMD=AVX3: expected baseline, AVX2 or AVX-512\n");
}

TEST(Help, HasExamplesWhoseOptionsTheCommandKnows) {
  for (const std::string& command : all_commands()) {
    const std::string help = run_rift(command + " --help").out;
    const std::string from = "Examples:\n", to = "\n\nExit codes";
    const std::string examples =
        help.substr(help.find(from) + from.size(), help.find(to) - help.find(from) - from.size());
    EXPECT_EQ(std::count(examples.begin(), examples.end(), '\n'), 1) << command;  // two lines
    const std::regex option("(?: )(--?[a-z][a-z-]*)");
    for (auto it = std::sregex_iterator(examples.begin(), examples.end(), option);
         it != std::sregex_iterator(); ++it)
      if (!contains(examples, "man -l") || it->str(1) != "-l") {
        EXPECT_TRUE(contains(help.substr(0, help.find(from)), it->str(1))) << command << ": " << it->str(1);
      }
  }
}

TEST(Help, IsACommandToo) {
  EXPECT_EQ(run_rift("help study").out, run_rift("study --help").out);
  EXPECT_EQ(run_rift("help").out, run_rift("--help").out);
  const Ran ran = run_rift("help stdy");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.err, "rift help: no such command 'stdy', did you mean 'study'?\n");
}

TEST(CommandLine, AnUnknownOptionPointsToTheHelpOfItsCommand) {
  const Ran ran = run_rift("list --frobnicate");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.err, "rift list: there is no option '--frobnicate'\nTry 'rift list --help'.\n");
}

TEST(CommandLine, OneCommandAtATime) { EXPECT_EQ(run_rift("theory list").exit_code, 2); }

TEST(CommandLine, AFullDiskUnderStdoutIsAFailureOfTheWorld) {
  const Ran ran = run_rift("theory >/dev/full");
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_EQ(ran.err, "rift: cannot write to standard output: No space left on device\n");
}

TEST(CommandLine, AReaderThatReadsNoMoreGetsNoMessage) {
  const Ran ran = run_shell("( { sleep 0.2; '" RIFT_EXE "' theory; echo $? >&2; } | true )");
  EXPECT_EQ(ran.err, "1\n") << "the code and nothing else";
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
