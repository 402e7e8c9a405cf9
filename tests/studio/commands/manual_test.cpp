#include "tests/studio/run_rift.hpp"

#include <regex>
#include <set>

namespace rift::studio {
namespace {

std::set<std::string> options_in(const std::string& text) {
  std::set<std::string> names;
  const std::regex option("--[a-z][a-z-]*");
  for (auto it = std::sregex_iterator(text.begin(), text.end(), option); it != std::sregex_iterator(); ++it)
    names.insert(it->str());
  return names;
}

/// A man page as text, without the escapes of roff.
std::string plain(std::string page) {
  return std::regex_replace(std::regex_replace(page, std::regex("\\\\f[BIR]"), ""), std::regex("\\\\-"), "-");
}

TEST(Manual, OfACommandHasEveryOptionOfItsHelp) {
  for (const std::string command : {"run", "study", "measure"}) {
    const Ran help = run_rift(command + " --help"), page = run_rift("manual " + command);
    ASSERT_EQ(page.exit_code, 0) << page.err;
    ASSERT_GT(options_in(help.out).size(), 5U);
    const std::set<std::string> there = options_in(plain(page.out));
    for (const std::string& option : options_in(help.out)) EXPECT_TRUE(there.contains(option)) << option;
  }
}

TEST(Manual, OfTheProgramNamesCommandsExitCodesAndVariables) {
  const std::string page = plain(run_rift("manual").out);
  for (const char* part :
       {"rift-run(1)", "rift-stability(1)", ".SH EXIT STATUS", "RIFT_PRESETS", "XDG_CACHE_HOME"})
    EXPECT_TRUE(contains(page, part)) << part;
}

TEST(Manual, OfAnUnknownCommandNamesTheNearest) {
  const Ran ran = run_rift("manual stdy");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.err, "rift manual: no such command 'stdy', did you mean 'study'?\n");
}

/// What bash offers after these words.
std::string offered_by_bash(const std::string& words, int at) {
  const TemporaryFolder folder;
  write_text(folder / "complete.sh", "source <('" RIFT_EXE "' completion bash)\nCOMP_WORDS=(" + words +
                                         ")\nCOMP_CWORD=" + std::to_string(at) +
                                         "\n_rift\necho \"${COMPREPLY[@]}\"\n");
  const Ran ran = run_shell("bash '" + (folder / "complete.sh").string() + "'");
  EXPECT_EQ(ran.err, "");
  return ran.out;
}

TEST(Completion, OfBashOffersCommandsOptionsChoicesAndPresets) {
  EXPECT_EQ(offered_by_bash("rift stu", 1), "studio study\n");
  EXPECT_EQ(offered_by_bash("rift run --check", 2), "--checkpoint\n");
  EXPECT_EQ(offered_by_bash("rift list --color a", 3), "auto always\n");
  EXPECT_EQ(offered_by_bash("'" RIFT_EXE "' run plate_", 2), "plate_pnrt plate_snrt\n");
}

TEST(Completion, OfOtherShellsKnowsEveryCommandToo) {
  for (const std::string shell : {"zsh", "fish"}) {
    const Ran ran = run_rift("completion " + shell);
    EXPECT_EQ(ran.exit_code, 0);
    for (const char* word : {"reproduce", "stability", "resamples", "list --names"})
      EXPECT_TRUE(contains(ran.out, word)) << shell << ": " << word;
  }
  EXPECT_EQ(run_rift("completion tcsh").exit_code, 2);
}

}  // namespace
}  // namespace rift::studio
