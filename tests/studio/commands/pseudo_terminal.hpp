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
  explicit PseudoTerminal(const std::string& command, void (*hang_up)(int) = SIG_DFL) {
    master_ = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (master_ < 0 || grantpt(master_) != 0 || unlockpt(master_) != 0)
      throw std::runtime_error("no pseudo-terminal");
    const winsize size{.ws_row = 30, .ws_col = 100, .ws_xpixel = 0, .ws_ypixel = 0};
    ioctl(master_, TIOCSWINSZ, &size);
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
      pollfd master{master_, POLLIN, 0};
      char buffer[4096];
      const bool ready = poll(&master, 1, 100) > 0;
      const ssize_t count = ready ? read(master_, buffer, sizeof buffer) : 0;
      if (count > 0) said_.append(buffer, static_cast<std::size_t>(count));
      if (count < 0 || std::chrono::steady_clock::now() > until) return false;
    }
    return true;
  }
  [[nodiscard]] testing::AssertionResult shows(const std::string& part) {
    if (reads_until([&] { return said_.find(part) != std::string::npos; }))
      return testing::AssertionSuccess();
    return testing::AssertionFailure() << "no \"" << part << "\" in:\n" << said_;
  }
  /// Closes the terminal under the command.
  void hang_up() {
    if (master_ >= 0) close(master_);
    master_ = -1;
  }
  /// Waits for the command's end; 128 + n where signal n ended it.
  int exit_code() {
    int status = 0;
    if (waitpid(child_, &status, 0) < 0) return -1;
    child_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

 private:
  int master_ = -1;
  pid_t child_ = -1;
  std::string said_;
};

}  // namespace rift::studio
