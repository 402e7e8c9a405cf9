#include "studio/terminal/crash.hpp"

#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>

namespace rift::studio {
namespace {

constexpr std::array signals{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

/// Text that a handler may read: never moved, never half written where it matters.
template <std::size_t Size>
struct Text {
  std::array<char, Size> bytes{};
  std::size_t length = 0;
  void set(const std::string& text) {
    length = 0;
    const std::size_t kept = std::min(text.size(), Size);
    std::memcpy(bytes.data(), text.data(), kept);
    length = kept;
  }
  void write_to(int descriptor) const {
    if (::write(descriptor, bytes.data(), length) < 0) return;  // nothing can be done about it here
  }
};

Text<200> restore_codes;
Text<400> last_words;
termios modes;
bool have_modes = false;
std::array<struct sigaction, signals.size()> before;
bool guarded = false;

void write_text(const char* text) {
  if (::write(STDERR_FILENO, text, std::strlen(text)) < 0) return;
}

void on_crash(int number) {
  if (tcgetpgrp(STDIN_FILENO) == getpgrp()) {  // another job's terminal is left alone
    restore_codes.write_to(STDOUT_FILENO);
    if (have_modes) tcsetattr(STDIN_FILENO, TCSANOW, &modes);
  }
  char digits[] = "rift: crashed (signal ..)\n";
  char* at = std::strchr(digits, '.');
  at[0] = static_cast<char>('0' + number / 10 % 10);
  at[1] = static_cast<char>('0' + number % 10);
  write_text(digits);
  last_words.write_to(STDERR_FILENO);
  std::signal(number, SIG_DFL);
  std::raise(number);
}

}  // namespace

void keep_modes() { have_modes = tcgetattr(STDIN_FILENO, &modes) == 0; }

void guard_terminal(const std::string& restore) {
  restore_codes.set(restore);
  struct sigaction action {};
  action.sa_handler = on_crash;
  action.sa_flags = SA_NODEFER;
  for (std::size_t k = 0; k < signals.size(); ++k) sigaction(signals[k], &action, &before[k]);
  guarded = true;
}

void unguard_terminal() {
  if (!guarded) return;
  for (std::size_t k = 0; k < signals.size(); ++k) sigaction(signals[k], &before[k], nullptr);
  guarded = false;
}

void say_in_a_crash(const std::string& text) { last_words.set(text); }

}  // namespace rift::studio
