#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <chrono>
#include <functional>
#include <stdexcept>
#include <string>

namespace rift::studio {

/// The two ends of a terminal: the test is its screen and keyboard.
class Ends {
 public:
  Ends() : master(posix_openpt(O_RDWR | O_NOCTTY)) {
    if (master < 0 || grantpt(master) != 0 || unlockpt(master) != 0)
      throw std::runtime_error("no pseudo-terminal");
    terminal = open(ptsname(master), O_RDWR | O_NOCTTY);
  }
  ~Ends() { close(master), close(terminal); }
  Ends(const Ends&) = delete;
  Ends& operator=(const Ends&) = delete;

  void type(const std::string& text) const {
    ASSERT_EQ(write(master, text.data(), text.size()), std::ssize(text));
  }
  int master, terminal = -1;
};

inline double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace rift::studio
