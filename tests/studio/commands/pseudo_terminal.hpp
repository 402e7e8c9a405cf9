#pragma once

#include "tests/expectations.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string>

namespace rift::studio {

/// A shell command that is the foreground of a terminal of its own, which can be closed under it.
class PseudoTerminal {
 public:
  /// @param hang_up  what SIGHUP does when it begins: SIG_DFL, or SIG_IGN as under nohup
  /// @param columns, rows  of the terminal
  explicit PseudoTerminal(const std::string& command, void (*hang_up)(int) = SIG_DFL,
                          unsigned short columns = 100, unsigned short rows = 30) {
    master_ = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (master_ < 0 || grantpt(master_) != 0 || unlockpt(master_) != 0)
      throw std::runtime_error("no pseudo-terminal");
    resize(columns, rows);
    const std::string name = ptsname(master_);
    child_ = fork();
    if (child_ != 0) return;
    setsid();
    const int terminal = open(name.c_str(), O_RDWR);  // becomes the session's
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(terminal, descriptor);
    close(terminal);
    signal(SIGHUP, hang_up);
    setenv("TERM", "xterm-256color", 1);
    execl("/bin/sh", "sh", "-c", ("exec " + command).c_str(), nullptr);
    _exit(127);
  }
  ~PseudoTerminal() {
    if (child_ > 0) kill(child_, SIGKILL), (void)exit_code();
    hang_up();
  }
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  /// Reads what the command writes until something is so. @return whether it was within 20 s
  [[nodiscard]] bool reads_until(const std::function<bool()>& is_so) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(patience_s);
    while (!is_so()) {
      if (read_some() < 0 || std::chrono::steady_clock::now() > until) return false;
    }
    return true;
  }
  [[nodiscard]] testing::AssertionResult shows(const std::string& part) {
    if (reads_until([&] { return said_.find(part) != std::string::npos; }))
      return testing::AssertionSuccess();
    return testing::AssertionFailure() << "no \"" << part << "\" in:\n" << said_;
  }
  /// What was read so far, and the process that runs the command.
  [[nodiscard]] const std::string& said() const { return said_; }
  [[nodiscard]] pid_t process() const { return child_; }
  void type(const std::string& text) const {
    EXPECT_EQ(write(master_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  void resize(unsigned short columns, unsigned short rows) const {
    const winsize size{.ws_row = rows, .ws_col = columns, .ws_xpixel = 0, .ws_ypixel = 0};
    ioctl(master_, TIOCSWINSZ, &size);
  }
  /// Closes the terminal under the command.
  void hang_up() {
    if (master_ >= 0) close(master_);
    master_ = -1;
  }
  /// Waits for the command's end, reading what it still writes; 128 + n where signal n ended it.
  int exit_code() {
    int status = 0;
    pid_t ended = 0;
    while ((ended = waitpid(child_, &status, WNOHANG)) == 0) read_some();
    if (ended < 0) return -1;
    child_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  /// What the command writes in the next tenth of a second at most. @return bytes, or -1 where it has ended
  ssize_t read_some() {
    if (master_ < 0) {  // hung up: nothing comes any more
      usleep(10000);
      return -1;
    }
    pollfd master{master_, POLLIN, 0};
    char buffer[4096];
    const bool ready = poll(&master, 1, 100) > 0;
    const ssize_t count = ready ? read(master_, buffer, sizeof buffer) : 0;
    if (count > 0) said_.append(buffer, static_cast<std::size_t>(count));
    return count;
  }

  int master_ = -1;
  pid_t child_ = -1;
  std::string said_;
};

}  // namespace rift::studio
