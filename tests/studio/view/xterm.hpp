#pragma once

#include "tests/studio/run_rift.hpp"
#include "viz/png.hpp"

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

namespace rift::studio {

/// A real xterm with sixels on a display of its own, in which a command works: it is given keys and looked
/// at. Cells have 9x15 pixels, and the first is in the corner of the display.
class Xterm {
 public:
  static constexpr int columns = 100, rows = 40, cell_width = 9, cell_height = 15;

  [[nodiscard]] static bool there() {
    return run_shell("command -v Xvfb && command -v xterm && command -v import && xterm -version")
               .exit_code == 0;
  }

  /// @param command  of a shell
  explicit Xterm(const std::string& command) {
    start_display();
    start_xterm();
    command_ = start({"/bin/sh", "-c", "read id; exec " + command}, [&] {
      setsid();
      const int terminal = open(name_.c_str(), O_RDWR);  // becomes the session's
      for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(terminal, descriptor);
      setenv("TERM", "xterm-256color", 1);
      setenv("LC_ALL", "C.UTF-8", 1);
      for (const char* variable : {"TMUX", "STY", "COLORTERM"}) unsetenv(variable);
    });
  }
  ~Xterm() {
    for (const pid_t process : {command_, xterm_, display_})
      if (process > 0) kill(process, SIGKILL), waitpid(process, nullptr, 0);
    if (master_ >= 0) close(master_);
  }
  Xterm(const Xterm&) = delete;
  Xterm& operator=(const Xterm&) = delete;

  void type(const std::string& keys) const {
    EXPECT_EQ(write(master_, keys.data(), keys.size()), static_cast<ssize_t>(keys.size()));
  }
  /// What is to be seen now.
  [[nodiscard]] viz::Image screenshot() const {
    const TemporaryFolder folder;
    const std::string file = (folder / "screen.png").string();
    const Ran ran = run_shell("DISPLAY=:" + number_ + " import -window root 'png24:" + file + "'");
    if (ran.exit_code != 0) throw std::runtime_error("no screenshot: " + ran.err);
    return viz::read_png(file);
  }

 private:
  template <typename Prepare>
  static pid_t start(std::vector<std::string> words, Prepare prepare) {
    const pid_t child = fork();
    if (child != 0) return child;
    prepare();
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  /// The display's number is the first that is free, which Xvfb writes.
  void start_display() {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    display_ = start(
        {"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0", "1000x700x24", "-nolisten", "tcp"},
        [] {
          if (freopen("/dev/null", "w", stderr) == nullptr) _exit(127);
        });
    close(ends[1]);
    for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) number_ += c;
    close(ends[0]);
    if (number_.empty()) throw std::runtime_error("no display");
  }
  /// In its slave mode it shows what comes from a terminal that the test has, and writes its window's number
  /// first.
  void start_xterm() {
    master_ = posix_openpt(O_RDWR | O_NOCTTY);
    if (master_ < 0 || grantpt(master_) != 0 || unlockpt(master_) != 0)
      throw std::runtime_error("no pseudo-terminal");
    name_ = ptsname(master_);
    const winsize size{.ws_row = rows, .ws_col = columns, .ws_xpixel = 0, .ws_ypixel = 0};
    ioctl(master_, TIOCSWINSZ, &size);
    const std::string last = name_.substr(name_.rfind('/') + 1);
    xterm_ = start({"xterm", "-S" + last + "/" + std::to_string(master_), "-ti", "vt340", "-xrm",
                    "XTerm*numColorRegisters: 256", "-fn", "9x15", "-b", "0", "-bw", "0", "+sb", "-geometry",
                    std::to_string(columns) + "x" + std::to_string(rows) + "+0+0"},
                   [&] { setenv("DISPLAY", (":" + number_).c_str(), 1); });
  }

  std::string number_, name_;
  int master_ = -1;
  pid_t display_ = -1, xterm_ = -1, command_ = -1;
};

}  // namespace rift::studio
