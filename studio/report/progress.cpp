#include "studio/report/progress.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <ctime>

namespace rift::studio {
namespace {

constexpr double quiet_start_s = 1.0, redraw_s = 0.2, plain_s = 5.0;
constexpr int bar_width = 24;

std::string bar(double done) {
  const int full = static_cast<int>(std::lround(done * bar_width));
  std::string text;
  for (int k = 0; k < bar_width; ++k) text += k < full ? "█" : "░";
  return text;
}

/// Remaining seconds if the pace of a second or more holds; negative while nothing is done yet.
double remaining(double elapsed, double done, double from) {
  return done - from > 1e-4 ? elapsed * (1.0 - done) / (done - from) : -1.0;
}

std::string clock_in(double seconds) {
  const std::time_t then = std::time(nullptr) + static_cast<std::time_t>(seconds);
  return fmt::format("{:%H:%M:%S}", fmt::localtime(then));
}

}  // namespace

std::string duration_text(double seconds) {
  const long s = std::lround(seconds);
  if (seconds < 10.0) return fmt::format("{:.1f} s", seconds);
  if (s < 60) return fmt::format("{} s", s);
  if (s < 3600) return fmt::format("{} min {:02} s", s / 60, s % 60);
  return fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
}

std::string magnitude_text(double value) {
  for (const auto& [unit, suffix] : {std::pair{1e9, "G"}, {1e6, "M"}, {1e3, "k"}})
    if (value >= unit) return fmt::format("{:.3g} {}", value / unit, suffix);
  return fmt::format("{:.3g}", value);
}

ProgressStyle progress_style(bool quiet, bool json) {
  if (quiet) return ProgressStyle::none;
  if (json) return ProgressStyle::json;
  return isatty(fileno(stderr)) ? ProgressStyle::line : ProgressStyle::plain;
}

void ProgressLine::tell(std::string_view stage, double done, std::string_view rate) {
  if (style_ == ProgressStyle::none) return;
  const auto now = Clock::now();
  if (stage != stage_) stage_ = stage, stage_start_ = now, last_ = {}, done_at_start_ = done;
  const double elapsed = std::chrono::duration<double>(now - stage_start_).count();
  const double pause = style_ == ProgressStyle::line ? redraw_s : plain_s;
  const bool first = last_ == Clock::time_point{};
  if (elapsed < quiet_start_s || (!first && std::chrono::duration<double>(now - last_).count() < pause))
    return;
  last_ = now;
  done = std::clamp(done, 0.0, 1.0);
  const double left = remaining(elapsed, done, done_at_start_);
  if (style_ == ProgressStyle::json) {
    nlohmann::ordered_json line{{"stage", stage_}, {"done", done}, {"elapsed_s", elapsed}};
    line["remaining_s"] = left < 0.0 ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(left);
    fmt::print(stderr, "{}\n", line.dump());
    return;
  }
  std::string text = fmt::format("{:<13}", stage_);
  if (style_ == ProgressStyle::line) text += fmt::format(" {}", bar(done));
  text += fmt::format(" {:3.0f} %", 100.0 * done);
  if (left >= 0.0) text += fmt::format("  {} left, done at {}", duration_text(left), clock_in(left));
  if (!rate.empty()) text += fmt::format("  {}", rate);
  if (style_ == ProgressStyle::line) {
    fmt::print(stderr, "\r{}\x1b[K", text);
    drawn_ = true;
  } else {
    fmt::print(stderr, "{}\n", text);
  }
  std::fflush(stderr);
}

void ProgressLine::clear() {
  if (!drawn_) return;
  fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
  drawn_ = false;
}

}  // namespace rift::studio
