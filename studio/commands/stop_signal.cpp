#include "studio/commands/stop_signal.hpp"

#include "studio/commands/common.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>

namespace rift::studio {

std::optional<double> read_budget(const std::string& command, const std::string& text) {
  if (text.empty()) return std::nullopt;
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  std::string unit(at, end);
  unit.erase(0, std::min(unit.find_first_not_of(' '), unit.size()));
  const double seconds = unit == "s" ? 1.0 : unit == "min" ? 60.0 : unit == "h" ? 3600.0 : 0.0;
  if (error != std::errc() || seconds == 0.0 || !(value > 0.0) || !(value * seconds < 1e9))
    refuse(command,
           fmt::format("--budget {}: expected a time with its unit, such as \"90 s\", \"10 min\" or \"2 h\"",
                       text));
  return value * seconds;
}

namespace {

constexpr std::array stop_signals{SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGXCPU, SIGXFSZ};

volatile std::sig_atomic_t stop_signal = 0;
std::array<struct sigaction, stop_signals.size()> actions_before;

void note_signal(int number, siginfo_t* info, void*) {
  const bool own_write_too_large = number == SIGXFSZ && info->si_pid == getpid();  // the write itself fails
  if (!own_write_too_large) stop_signal = number;
}

}  // namespace

StopSignal::StopSignal(std::optional<double> budget) {
  if (budget)
    until_ = base::Clock::now() +
             std::chrono::duration_cast<base::Clock::duration>(std::chrono::duration<double>(*budget));
  stop_signal = 0;
  struct sigaction action {};
  action.sa_sigaction = note_signal;
  action.sa_flags = SA_SIGINFO | SA_RESTART;
  for (std::size_t k = 0; k < stop_signals.size(); ++k) {
    sigaction(stop_signals[k], nullptr, &actions_before[k]);
    const bool hang_up_ignored = stop_signals[k] == SIGHUP && actions_before[k].sa_handler == SIG_IGN;
    if (!hang_up_ignored) sigaction(stop_signals[k], &action, nullptr);
  }
}

StopSignal::~StopSignal() {
  for (std::size_t k = 0; k < stop_signals.size(); ++k)
    sigaction(stop_signals[k], &actions_before[k], nullptr);
}

int StopSignal::received() const {
  if (stop_signal != 0) return stop_signal;
  return until_ && base::Clock::now() >= *until_ ? time_is_up : 0;
}

void let_large_writes_fail() { std::signal(SIGXFSZ, SIG_IGN); }

}  // namespace rift::studio
