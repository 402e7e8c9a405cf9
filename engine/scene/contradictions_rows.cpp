#include "engine/scene/contradictions_rows.hpp"

#include "engine/scene/derived.hpp"
#include "engine/scene/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace rift::scene {
namespace {

constexpr double forgiven = 3.0;  // standard uncertainties
// What no crack is measured by: it would only overflow.
constexpr double latest = 1000.0, farthest = 100.0, shortest = 1e-12, finest = 1e-9;  // [s], [m], [s], [m]
constexpr double strongest = 1e9, widest = 10.0;  // [N], [m]; as loading.force and loading.displacement

std::string length_text(double x) { return rounded_text(x, Dimension::length); }
std::string time_text(double x) { return rounded_text(x, Dimension::time); }

constexpr std::size_t most_of_rows = 100;  // defects; more are of the same kinds

struct Rows {
  const Preset& preset;
  std::string key;
  std::vector<Issue> issues = {};
  void say(std::size_t row, std::string text) {
    issues.push_back(issue_at_row(preset, key, row, std::move(text)));
    if (issues.size() == most_of_rows)
      issues.push_back(issue_at_row(preset, key, row, "and so on: the rows from here on were not looked at"));
  }
  bool is_full() const { return issues.size() > most_of_rows; }
};

void check_time(Rows& r, std::size_t k, const history::HistoryPoint& before,
                const history::HistoryPoint& row) {
  if (row.time > before.time && row.time - before.time < shortest)
    r.say(k, fmt::format("time {} follows within {}", time_text(row.time), time_text(shortest)));
  if (row.time == before.time) r.say(k, fmt::format("time {} is there twice", time_text(row.time)));
  if (row.time < before.time)
    r.say(k, fmt::format("time falls from {} to {}", time_text(before.time), time_text(row.time)));
}

void check_position(Rows& r, std::size_t k, const history::HistoryPoint& before,
                    const history::HistoryPoint& row) {
  if (row.position >= before.position) return;
  const double noise = forgiven * std::hypot(before.uncertainty, row.uncertainty);
  const bool smoothed = r.preset.scene.crack.smoothing == history::Smoothing::monotone;
  if (smoothed && before.position - row.position <= noise) return;
  std::string text =
      fmt::format("position falls from {} to {}", length_text(before.position), length_text(row.position));
  if (noise > 0.0 && smoothed)
    text +=
        fmt::format(", more than {:g} standard uncertainties of the step, {}", forgiven, length_text(noise));
  if (noise > 0.0 && !smoothed) text += ": noise asks for crack.smoothing = \"monotone\"";
  if (noise == 0.0 && smoothed) text += ": for noise give a column uncertainty";
  r.say(k, std::move(text));
}

void check_uncertainty(Rows& r, std::size_t k, const history::HistoryPoint& row) {
  const bool known = r.preset.scene.crack.history.front().uncertainty != 0.0;
  if (row.uncertainty < 0.0 || (known && row.uncertainty == 0.0))
    r.say(k, fmt::format("uncertainty {} must lie above 0", length_text(row.uncertainty)));
  else if (known && (row.uncertainty < finest || row.uncertainty > farthest))
    r.say(k, fmt::format("uncertainty {} must lie in [{}, {}]", length_text(row.uncertainty),
                         length_text(finest), length_text(farthest)));
  else if (!known && row.uncertainty != 0.0)
    r.say(k, "has an uncertainty, and the first row has none: give it for all rows or for none");
}

void check_gaps(Rows& r, const std::vector<history::HistoryPoint>& rows) {
  const double usual = median_interval(rows), most = r.preset.scene.crack.history_gap;
  for (std::size_t k = 1; k < rows.size() && !r.is_full(); ++k) {
    const double gap = rows[k].time - rows[k - 1].time;
    if (gap > most * usual)
      r.say(k, fmt::format("no row for {} after {}, {:.3g} times the usual {}: rows are missing, or raise "
                           "crack.history_gap ({:g})",
                           time_text(gap), time_text(rows[k - 1].time), gap / usual, time_text(usual), most));
  }
}

/// The first row says where the notch ends; crack.start may say it better, within the noise.
void check_start(Rows& r, const history::HistoryPoint& first) {
  const double start = r.preset.scene.crack.start;
  const double slack = std::max(forgiven * first.uncertainty, 1e-9);
  if (std::abs(first.position - start) > slack)
    r.issues.push_back(issue_at(r.preset, "crack.start",
                                fmt::format("the history begins at {}: leave crack.start out, or cut the "
                                            "history there",
                                            length_text(first.position))));
}

}  // namespace

std::string clock_trouble(double first_time) {
  constexpr double three_years = 1e8;
  if (std::abs(first_time) <= latest) return {};
  return fmt::format(
      "time {:.0f} s{}: subtract the first row's time from all, in the program that recorded them, before "
      "their last digits are lost: times must lie within {}",
      first_time, first_time > three_years ? " counts from a clock's epoch" : "", time_text(latest));
}

double median_interval(const std::vector<history::HistoryPoint>& rows) {
  std::vector<double> intervals;
  for (std::size_t k = 1; k < rows.size(); ++k) intervals.push_back(rows[k].time - rows[k - 1].time);
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::nth_element(intervals.begin(), middle, intervals.end());
  return *middle;
}

std::vector<Issue> history_issues(const Preset& preset) {
  const std::vector<history::HistoryPoint>& rows = preset.scene.crack.history;
  if (rows.empty()) return {};
  Rows r{preset, "crack.history"};
  if (rows.size() < 2) {
    r.say(0, "is the only row: a history needs two");
    return std::move(r.issues);
  }
  if (std::string trouble = clock_trouble(rows.front().time); !trouble.empty()) {
    r.say(0, std::move(trouble));
    return std::move(r.issues);
  }
  for (std::size_t k = 0; k < rows.size() && !r.is_full(); ++k) {
    if (rows[k].position < 0.0)
      r.say(k, fmt::format("position {} must not lie below 0", length_text(rows[k].position)));
    if (rows[k].position > farthest)
      r.say(k, fmt::format("position {} must not lie beyond {}", length_text(rows[k].position),
                           length_text(farthest)));
    if (std::abs(rows[k].time) > latest)
      r.say(k, fmt::format("time {} must lie within {}", time_text(rows[k].time), time_text(latest)));
    check_uncertainty(r, k, rows[k]);
    if (k > 0) check_time(r, k, rows[k - 1], rows[k]);
    if (k > 0) check_position(r, k, rows[k - 1], rows[k]);
  }
  if (r.issues.empty() && !(rows.back().position > rows.front().position))
    r.say(rows.size() - 1, "the crack does not advance: the last position must lie beyond the first");
  if (r.issues.empty()) check_gaps(r, rows);
  if (r.issues.empty()) check_start(r, rows.front());
  return std::move(r.issues);
}

std::vector<Issue> toughness_issues(const Preset& preset) {
  const fracture::CriticalRate& rate = preset.scene.crack.toughness;
  const bool by_position = rate.against == fracture::CriticalRate::Against::position;
  const char* name = by_position ? "position" : "velocity";
  Rows r{preset, "crack.toughness"};
  for (std::size_t k = 0; k < rate.row.size() && !r.is_full(); ++k) {
    const auto& [at, critical] = rate.row[k];
    if (at < 0.0) r.say(k, fmt::format("{} {:g} must not lie below 0", name, at));
    if (!(critical > 0.0)) r.say(k, fmt::format("release rate {:g} J/m2 must lie above 0", critical));
    if (k > 0 && at <= rate.row[k - 1][0])
      r.say(k, fmt::format("{} {:g} does not lie above the {:g} of the row before", name, at,
                           rate.row[k - 1][0]));
  }
  return std::move(r.issues);
}

std::vector<Issue> load_issues(const Preset& preset) {
  const LoadCurve& curve = preset.scene.loading.curve;
  if (curve.row.empty()) return {};
  const Dimension load = curve.of == LoadCurve::Of::force ? Dimension::force : Dimension::length;
  const double largest = curve.of == LoadCurve::Of::force ? strongest : widest;
  Rows r{preset, "loading.curve"};
  if (curve.row.size() < 2) r.say(0, "is the only row: a curve needs two");
  if (std::string trouble = clock_trouble(curve.row.front()[0]); !trouble.empty()) {
    r.say(0, std::move(trouble));
    return std::move(r.issues);
  }
  for (std::size_t k = 0; k < curve.row.size() && !r.is_full(); ++k) {
    const auto& [time, value] = curve.row[k];
    if (std::abs(time) > latest)
      r.say(k, fmt::format("time {} must lie within {}", time_text(time), time_text(latest)));
    if (std::abs(value) > largest)
      r.say(k, fmt::format("{} must lie within {}", rounded_text(value, load), rounded_text(largest, load)));
    if (k > 0) check_time(r, k, {curve.row[k - 1][0]}, {time});
  }
  if (!r.issues.empty()) return std::move(r.issues);
  const auto& rows = preset.scene.crack.history;
  const double start = load_time(preset.scene), end = rows.empty() ? start : rows.back().time;
  if (start < curve.row.front()[0])
    r.say(0, fmt::format("the curve begins at {}, after the crack, which starts at {}",
                         time_text(curve.row.front()[0]), time_text(start)));
  const double needed = grip_moves(preset.scene) ? end : start;
  if (needed > curve.row.back()[0])
    r.say(curve.row.size() - 1,
          fmt::format("the curve ends at {}, before {}, {}", time_text(curve.row.back()[0]),
                      needed > start ? "the history does" : "the crack starts", time_text(needed)));
  for (std::size_t k = 0; k < curve.row.size() && grip_moves(preset.scene) && !r.is_full(); ++k)
    if (curve.row[k][0] > start && curve.row[k][1] < 0.0 && !preset.scene.crack.friction)
      r.say(k, fmt::format(
                   "{} presses the plate while the crack runs, which needs crack.friction: its faces would "
                   "pass through each other",
                   length_text(curve.row[k][1])));
  if (r.issues.empty() && load_at(curve, start) == 0.0)
    r.issues.push_back(issue_at(preset, "loading.curve", "0 as the crack starts strains nothing"));
  return std::move(r.issues);
}

std::vector<Issue> path_issues(const Preset& preset) {
  const std::vector<std::array<double, 2>>& point = preset.scene.crack.path.point;
  const Scene::Specimen& plate = preset.scene.specimen;
  if (point.empty()) return {};
  Rows r{preset, "crack.path"};
  if (point.size() < 2) r.say(0, "is the only point: a path needs two");
  for (std::size_t k = 0; k < point.size() && !r.is_full(); ++k) {
    const auto& [x, y] = point[k];
    if (!(x >= 0.0 && x <= plate.length && y >= 0.0 && y <= plate.height))
      r.say(k, fmt::format("({}, {}) lies outside the plate, {} x {}", length_text(x), length_text(y),
                           length_text(plate.length), length_text(plate.height)));
    if (k > 0 && point[k] == point[k - 1]) r.say(k, "is the same point as the row before");
  }
  return std::move(r.issues);
}

}  // namespace rift::scene
