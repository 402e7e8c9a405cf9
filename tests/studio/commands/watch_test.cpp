#include "tests/studio/commands/tiny_plate.hpp"

#include <thread>

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

/// Drives a real terminal (tmux) and reads its screen.
TEST(Watch, ShowsARunInATerminalAndGivesItBack) {
  if (run_shell("command -v tmux").exit_code != 0) GTEST_SKIP() << "no tmux";
  const TinyPlate plate;
  ASSERT_EQ(plate.run("--set 'output.fields=[\"displacement\"]'").exit_code, 0);
  const std::string tmux = "tmux -L rift_test_" + plate.path().filename().string() + " -f /dev/null ";
  const std::string watching =
      "LC_ALL=C.UTF-8 '" RIFT_EXE "' watch '" + plate.out().string() + "'; echo left with $?; cat";
  ASSERT_EQ(
      run_shell("TERM=xterm-256color " + tmux + "new-session -d -x 100 -y 30 \"" + watching + "\"").exit_code,
      0);
  const auto wait_for = [&](const std::string& part) {
    std::string screen;
    for (int k = 0; k < 100 && screen.find(part) == std::string::npos; ++k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      screen = run_shell(tmux + "capture-pane -p").out;
    }
    return contains(screen, part);
  };
  EXPECT_TRUE(wait_for("out  finished"));
  EXPECT_TRUE(wait_for("within 1e-09"));
  EXPECT_TRUE(wait_for("G_ID/G_I0"));
  run_shell(tmux + "resize-window -x 50 -y 12");
  EXPECT_TRUE(wait_for("50x12 is too small: 60x16 needed"));
  run_shell(tmux + "resize-window -x 100 -y 30");
  EXPECT_TRUE(wait_for("out  finished"));
  run_shell(tmux + "send-keys q");
  EXPECT_TRUE(wait_for("left with 0"));
  run_shell(tmux + "kill-server");
}

}  // namespace
}  // namespace rift::studio
