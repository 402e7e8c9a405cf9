#include "tests/studio/run_rift.hpp"

#include <gtest/gtest.h>

#include <string>

namespace rift::studio {
namespace {

TEST(Preset, MissingOneIsBadInputAndNamesTheNearest) {
  const TemporaryFolder folder;
  write_text(folder.path() / "quickstart.toml", "# A plate\n# Cost: 10 s\n");
  for (const std::string name : {"quikstart.toml", "quikstart"}) {
    const Ran ran = run_rift("check " + name, presets_at(folder.path()));
    EXPECT_EQ(ran.exit_code, 2);
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(ran.err, "rift: no such preset '" + name +
                           "', did you mean 'quickstart'? ('rift list' shows those in " +
                           folder.path().string() + ")\n");
  }
}

TEST(Preset, MissingOneThatResemblesNothingGetsNoSuggestion) {
  const TemporaryFolder folder;
  const Ran ran = run_rift("check some/where/else.toml", presets_at(folder.path()));
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(ran.err, "rift: no such preset 'some/where/else.toml' ('rift list' shows those in " +
                         folder.path().string() + ")\n");
}

TEST(Preset, FolderIsNone) {
  const TemporaryFolder folder;
  const Ran ran = run_rift("check " + folder.path().string());
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_TRUE(contains(ran.err, "rift: '" + folder.path().string() + "' is a folder, not a preset"));
}

// An empty preset is refused or taken on its merits, but it is found.
TEST(Preset, IsFoundByBareNameByFileNameAndByPath) {
  const TemporaryFolder folder;
  write_text(folder.path() / "own.toml", "nonsense = 1\n");
  for (const std::string& name :
       {std::string("own"), std::string("own.toml"), (folder.path() / "own.toml").string()}) {
    const Ran ran = run_rift("check " + name, presets_at(folder.path()));
    EXPECT_TRUE(contains(ran.err, "own.toml:1")) << name;
  }
}

}  // namespace
}  // namespace rift::studio
