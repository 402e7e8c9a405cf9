#include "studio/text/progress.hpp"

#include "engine/base/console.hpp"
#include "engine/base/text.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
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

ProgressStyle progress_style(bool quiet, bool json, bool plain) {
  if (quiet) return ProgressStyle::none;
  if (json) return ProgressStyle::json;
  return !plain && isatty(STDERR_FILENO) ? ProgressStyle::line : ProgressStyle::plain;
}

void Pace::note(double now, double done) {
  constexpr double shortest_s = 5.0, share = 0.25;
  if (!noted_.empty() && !(done > noted_.back().second)) return;
  const double apart = std::max(0.1, 0.005 * now);  // so that few are kept, however often it is noted
  if (noted_.size() > 1 && now - noted_[noted_.size() - 2].first < apart) noted_.pop_back();
  noted_.emplace_back(now, done);
  const double from = now - std::max(shortest_s, share * now);
  while (noted_.size() > 2 && noted_[1].first <= from) noted_.pop_front();
}

double Pace::remaining(double now) const {
  if (noted_.size() < 2) return -1.0;
  const auto& [then, done_then] = noted_.front();
  const auto& [last, done] = noted_.back();
  // What stands still for longer than it took so far in this while is not known to go on.
  if (now - last > last - then) return -1.0;
  constexpr double for_ever = 1e9;
  const double left = (1.0 - done) * (now - then) / (done - done_then);
  return left < for_ever ? left : -1.0;
}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::show(std::string_view stage, double done, std::string_view rate) {
  if (style_ == ProgressStyle::none) return;
  const std::lock_guard lock(mutex_);
  if (stage != stage_) stage_ = stage, stage_start_ = Clock::now(), last_ = {}, pace_ = {};
  done_ = done >= 0.0 ? std::min(done, 1.0) : 0.0, rate_ = rate, goes_on_ = true;
  pace_.note(elapsed(), done_);
  if (!beside_.joinable())
    beside_ = std::jthread([this](const std::stop_token& ended) { keep_showing(ended); });
  show_if_due();
}

/// Signals are for the thread that works.
void ProgressLine::keep_showing(const std::stop_token& ended) {
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
  std::unique_lock lock(mutex_);
  while (!ended.stop_requested()) {
    wake_.wait_for(lock, ended, std::chrono::seconds(1), [] { return false; });
    if (!ended.stop_requested() && goes_on_) show_if_due();
  }
}

void ProgressLine::show_if_due() {
  const auto now = Clock::now();
  const double since = elapsed(), pause = redrawn() ? redraw_s : plain_s;
  const bool first = last_ == Clock::time_point{};
  if (since < quiet_start_s || (!first && std::chrono::duration<double>(now - last_).count() < pause)) return;
  last_ = now;
  print(since);
}

void ProgressLine::print(double elapsed) {
  const double left = pace_.remaining(elapsed);
  if (style_ == ProgressStyle::json) {
    nlohmann::ordered_json line{{"stage", stage_}, {"done", done_}, {"elapsed_s", elapsed}};
    line["remaining_s"] = left < 0.0 ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(left);
    base::message("{}\n", base::json_text(line));
    return;
  }
  std::string text = fmt::format("{:<13}", stage_);
  const bool in_place = redrawn();
  if (in_place) text += fmt::format(" {}", bar(done_));
  text += fmt::format(" {:3.0f} %", 100.0 * done_);
  if (left < 0.0) text += fmt::format("  for {} so far", duration_text(elapsed));
  if (left >= 0.0) text += fmt::format("  {} left, done at {}", duration_text(left), clock_in(left));
  if (!rate_.empty()) text += fmt::format("  {}", rate_);
  if (in_place) {
    base::message("\r{}\x1b[K", text);
    drawn_ = true;
  } else {
    base::message("{}\n", text);
  }
}

bool ProgressLine::redrawn() const {
  return style_ == ProgressStyle::line && base::in_foreground(STDERR_FILENO);
}

void ProgressLine::clear() {
  const std::lock_guard lock(mutex_);
  goes_on_ = false;
  if (!drawn_) return;
  if (redrawn()) base::message("\r\x1b[K");
  drawn_ = false;
}

}  // namespace rift::studio
