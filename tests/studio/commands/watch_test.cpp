#include "tests/studio/commands/terminal.hpp"
#include "tests/studio/commands/tiny_plate.hpp"

namespace rift::studio {
namespace {

TEST(Watch, WithoutATerminalSaysWhatToUse) {
  const TinyPlate plate;
  ASSERT_EQ(plate.run().exit_code, 0);
  const Ran ran = run_rift("watch '" + plate.out().string() + "'");
  EXPECT_EQ(ran.exit_code, ran.err.find("built without") == std::string::npos ? 2 : 1);
  EXPECT_TRUE(contains(ran.err, "rift watch: "));
  EXPECT_EQ(ran.out, "");
}

TEST(Watch, OfAFolderThatIsNotThereSaysSoFirst) {
  const Ran ran = run_rift("watch runs/none");
  EXPECT_EQ(ran.exit_code, 1);
  if (contains(ran.err, "built without")) return;
  EXPECT_EQ(ran.err, "rift: cannot watch runs/none: there is no run\n");
}

TEST(Watch, ShowsARunInATerminalAndGivesItBack) {
  if (!RealTerminal::there()) GTEST_SKIP() << "no tmux";
  const TinyPlate plate;
  ASSERT_EQ(plate.run("--set 'output.fields=[\"displacement\"]'").exit_code, 0);
  const RealTerminal terminal("watch_" + plate.path().filename().string(),
                              "'" RIFT_EXE "' watch '" + plate.out().string() + "'", 100, 30);
  EXPECT_TRUE(terminal.shows("out  finished"));
  EXPECT_TRUE(terminal.shows("within 1e-10"));
  EXPECT_TRUE(terminal.shows("G_ID/G_I0"));
  terminal.resize(50, 12);
  EXPECT_TRUE(terminal.shows("50x12 is too small: 60x16 needed"));
  terminal.resize(100, 30);
  EXPECT_TRUE(terminal.shows("out  finished"));
  terminal.send("q");
  EXPECT_TRUE(terminal.shows("left with 0"));
}

}  // namespace
}  // namespace rift::studio
