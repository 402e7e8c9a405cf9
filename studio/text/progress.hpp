#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <deque>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

namespace rift::studio {

/// How progress is shown on stderr.
enum class ProgressStyle { none, line, plain, json };

/// How long the rest of a stage will take, at the pace of its last quarter (of five seconds at least): a
/// stage that slows down is not judged by how fast it began.
class Pace {
 public:
  /// @param now  [s] since the stage began, rising;  @param done  in [0, 1]
  void note(double now, double done);
  /// [s] from `now` on; negative where nothing has been done lately, so that nobody knows.
  double remaining(double now) const;
  std::size_t kept() const { return noted_.size(); }

 private:
  std::deque<std::pair<double, double>> noted_;  // (now, done); done rises from one to the next
};

/// A line that is redrawn on a terminal, a line every five seconds elsewhere and in a
/// terminal's background, or JSON lines; nothing for stages that end within a second. A thread of its own
/// shows a stage that goes on without news of it.
class ProgressLine {
 public:
  explicit ProgressLine(ProgressStyle style) : style_(style) {}
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// @param done  in [0, 1];  @param rate  such as "2.3 M element-steps/s", or empty
  void show(std::string_view stage, double done, std::string_view rate = {});

  /// Takes the line off the terminal, until more is shown.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  double elapsed() const { return std::chrono::duration<double>(Clock::now() - stage_start_).count(); }
  void show_if_due();
  void print(double elapsed);
  [[nodiscard]] bool redrawn() const;  // on a terminal in whose foreground this process is
  void keep_showing(const std::stop_token& ended);

  ProgressStyle style_;
  std::mutex mutex_;  // of all below
  std::string stage_, rate_;
  Clock::time_point stage_start_ = Clock::now(), last_ = {};
  double done_ = 0;
  Pace pace_;
  bool drawn_ = false, goes_on_ = false;
  std::condition_variable_any wake_;
  std::jthread beside_;
};

/// "3 s", "2 min 05 s", "1 h 20 min".
std::string duration_text(double seconds);

/// 1234567 -> "1.23 M", 1500 -> "1.5 k".
std::string magnitude_text(double value);

/// The style for a stream: none if quiet, JSON or plain lines if asked, a redrawn line only on a terminal.
ProgressStyle progress_style(bool quiet, bool json, bool plain = false);

}  // namespace rift::studio
