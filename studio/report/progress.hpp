#pragma once

#include <chrono>
#include <cstdio>
#include <string>
#include <string_view>

namespace rift::studio {

/// How progress is told on stderr.
enum class ProgressStyle { none, line, plain, json };

/// A line that is redrawn on a terminal, a line every five seconds elsewhere, or JSON lines; nothing for
/// stages that end within a second.
class ProgressLine {
 public:
  explicit ProgressLine(ProgressStyle style) : style_(style) {}
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// @param done  in [0, 1];  @param rate  such as "2.3 M element-steps/s", or empty
  void tell(std::string_view stage, double done, std::string_view rate = {});

  /// Takes the line off the terminal.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  ProgressStyle style_;
  std::string stage_;
  Clock::time_point stage_start_ = Clock::now(), last_ = {};
  double done_at_start_ = 0;  // a stage may begin in the middle of the whole
  bool drawn_ = false;
};

/// "3 s", "2 min 05 s", "1 h 20 min".
std::string duration_text(double seconds);

/// 1234567 -> "1.23 M", 1500 -> "1.5 k".
std::string magnitude_text(double value);

/// The style for a stream: none if quiet, JSON if asked, a redrawn line only on a terminal.
ProgressStyle progress_style(bool quiet, bool json);

}  // namespace rift::studio
