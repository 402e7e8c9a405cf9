#pragma once

#include "tests/studio/run_rift.hpp"

#include <chrono>
#include <string>
#include <thread>

namespace rift::studio {

/// A real terminal (tmux) in which a command works, driven by keys and read as text.
class RealTerminal {
 public:
  [[nodiscard]] static bool there() { return run_shell("command -v tmux").exit_code == 0; }

  /// @param name     of its own for each test; @param command  of a shell, without double quotes
  RealTerminal(const std::string& name, const std::string& command, int width = 120, int height = 40)
      : tmux_("tmux -L rift_test_" + name + " -f /dev/null ") {
    const Ran ran =
        run_shell("TERM=xterm-256color " + tmux_ + "new-session -d -x " + std::to_string(width) + " -y " +
                  std::to_string(height) + " \"LC_ALL=C.UTF-8 TERM=screen-256color; export LC_ALL TERM; " +
                  command + "; echo left with \\$?; cat\"");
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
  }
  ~RealTerminal() { run_shell(tmux_ + "kill-server"); }
  RealTerminal(const RealTerminal&) = delete;
  RealTerminal& operator=(const RealTerminal&) = delete;

  [[nodiscard]] std::string screen() const { return run_shell(tmux_ + "capture-pane -p").out; }
  /// @param keys  as tmux names them: "Enter", "q", "Space"
  void send(const std::string& keys) const { run_shell(tmux_ + "send-keys " + keys); }
  void resize(int width, int height) const {
    run_shell(tmux_ + "resize-window -x " + std::to_string(width) + " -y " + std::to_string(height));
  }
  /// Whether the screen shows this before patience ends.
  [[nodiscard]] testing::AssertionResult shows(const std::string& part) const {
    std::string text;
    for (int k = 0; k < 10 * patience_s; ++k) {
      text = screen();
      if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return contains(text, part);
  }

 private:
  std::string tmux_;
};

}  // namespace rift::studio
