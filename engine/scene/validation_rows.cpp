#include "engine/scene/derived.hpp"
#include "engine/scene/units.hpp"
#include "engine/scene/validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

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
  std::string scatter_text = {};  // behind what is first said of noisy rows
  void say(std::size_t row, std::string text) {
    issues.push_back(issue_at_row(preset, key, row, std::move(text)));
    if (issues.size() == most_of_rows)
      issues.push_back(issue_at_row(preset, key, row, "and so on: the following rows were not checked"));
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
  if (noise > 0.0 && !smoothed) text += ": noisy rows need crack.smoothing = \"monotone\"";
  if (noise == 0.0 && smoothed)
    text += ": noisy rows need a column uncertainty" + std::exchange(r.scatter_text, {});
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

/// Standard deviation of independent noise on the rows [m], from how far each lies from the straight line
/// through its neighbours (Gasser, Sroka and Jennen-Steinmetz 1986).
double scatter_of(const std::vector<history::HistoryPoint>& rows) {
  double squares = 0.0;
  for (std::size_t i = 1; i + 1 < rows.size(); ++i) {
    const history::HistoryPoint &before = rows[i - 1], &row = rows[i], &after = rows[i + 1];
    const double w = (row.time - before.time) / (after.time - before.time);
    const double off = row.position - std::lerp(before.position, after.position, w);
    squares += off * off / (1.0 + w * w + (1.0 - w) * (1.0 - w));
  }
  return std::sqrt(squares / static_cast<double>(rows.size() - 2));
}

/// An estimate of the uncertainty that the rows lack; of a few rows, or of rows out of time, there is none.
std::string scatter_text(const std::vector<history::HistoryPoint>& rows) {
  constexpr std::size_t fewest = 10;
  const auto out_of_time = [](const history::HistoryPoint& before, const history::HistoryPoint& after) {
    return after.time <= before.time;
  };
  if (rows.size() < fewest || std::adjacent_find(rows.begin(), rows.end(), out_of_time) != rows.end())
    return {};
  return fmt::format(" (the rows scatter by about {:.2g} mm, one standard deviation)",
                     1e3 * scatter_of(rows));
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
  r.scatter_text = scatter_text(rows);
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
      r.say(k, fmt::format("{} compresses the plate while the crack runs, which needs crack.friction: the "
                           "faces would pass through each other",
                           length_text(curve.row[k][1])));
  if (r.issues.empty() && load_at(curve, start) == 0.0)
    r.issues.push_back(
        issue_at(preset, "loading.curve", "is 0 when the crack starts: the plate would not be strained"));
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

namespace {

constexpr int most_places = 5;  // that a note names

/// Frames that are missing in a history of evenly spaced ones; one of uneven times misses nothing.
std::string note_on_missing_rows(const Preset& preset) {
  const std::vector<history::HistoryPoint>& rows = preset.scene.crack.history;
  if (rows.size() < 4) return {};
  constexpr double jitter = 0.1, evenly = 0.75;  // of the usual interval; of all intervals
  const double usual = median_interval(rows);
  std::size_t even = 0;
  long missing = 0;
  int places = 0;
  std::string where;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const double intervals = (rows[k].time - rows[k - 1].time) / usual;
    if (std::abs(intervals - 1.0) <= jitter) ++even;
    const long here = std::lround(intervals) - 1;
    if (here <= 0) continue;
    missing += here;
    if (++places <= most_places)
      where += fmt::format("{}{} after {}", places == 1 ? "" : ", ", here,
                           rounded_text(rows[k - 1].time, Dimension::time));
  }
  if (missing == 0 || static_cast<double>(even) < evenly * static_cast<double>(rows.size() - 1)) return {};
  if (places > most_places) where += fmt::format(" and at {} more places", places - most_places);
  const auto from = preset.rows.find("crack.history");
  return fmt::format(
      "{}: {} of every {} {} to be missing: {}; the smoothed history is interpolated between their "
      "neighbours",
      from == preset.rows.end() ? "crack.history" : from->second.file,
      missing == 1 ? "1 row" : fmt::format("{} rows", missing), rounded_text(usual, Dimension::time),
      missing == 1 ? "seems" : "seem", where);
}

using Point = std::array<double, 2>;

struct SelfCrossing {
  Point at{};
  double first = 0, second = 0;  // arc lengths [m]
};

/// Where two pieces of a path meet, as fractions of each; nothing where they do not, or lie on one line.
std::optional<std::pair<double, double>> meeting(const Point& a, const Point& b, const Point& c,
                                                 const Point& d) {
  const double ux = b[0] - a[0], uy = b[1] - a[1], vx = d[0] - c[0], vy = d[1] - c[1];
  const double cross = ux * vy - uy * vx;
  if (cross == 0.0) return std::nullopt;
  const double s = ((c[0] - a[0]) * vy - (c[1] - a[1]) * vx) / cross;
  const double t = ((c[0] - a[0]) * uy - (c[1] - a[1]) * ux) / cross;
  if (!(s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0)) return std::nullopt;
  return std::pair{s, t};
}

/// The first along the path; pieces are compared only where they overlap along x.
std::optional<SelfCrossing> self_crossing(const std::vector<Point>& point) {
  if (point.size() < 4) return std::nullopt;
  std::vector<double> arc(point.size(), 0.0);
  for (std::size_t k = 1; k < point.size(); ++k)
    arc[k] = arc[k - 1] + std::hypot(point[k][0] - point[k - 1][0], point[k][1] - point[k - 1][1]);
  const auto left = [&](std::size_t k) { return std::min(point[k][0], point[k + 1][0]); };
  const auto right = [&](std::size_t k) { return std::max(point[k][0], point[k + 1][0]); };
  std::vector<std::size_t> piece(point.size() - 1);
  std::iota(piece.begin(), piece.end(), std::size_t{0});
  std::sort(piece.begin(), piece.end(), [&](std::size_t a, std::size_t b) { return left(a) < left(b); });
  std::optional<SelfCrossing> found;
  for (std::size_t i = 0; i < piece.size(); ++i)
    for (std::size_t j = i + 1; j < piece.size() && left(piece[j]) <= right(piece[i]); ++j) {
      const auto [one, other] = std::minmax(piece[i], piece[j]);
      if (other == one + 1) continue;  // neighbours share a point
      const auto met = meeting(point[one], point[one + 1], point[other], point[other + 1]);
      if (!met) continue;
      const double first = arc[one] + met->first * (arc[one + 1] - arc[one]);
      if (found && found->second <= arc[other]) continue;
      found = {{point[one][0] + met->first * (point[one + 1][0] - point[one][0]),
                point[one][1] + met->first * (point[one + 1][1] - point[one][1])},
               first,
               arc[other] + met->second * (arc[other + 1] - arc[other])};
    }
  return found;
}

/// Noise that cross-validation does not find is taken for velocity.
std::string note_on_noise(const Scene& scene) {
  if (scene.crack.history.empty()) return {};
  const history::SmoothedHistory course = smoothed_history(scene);
  if (!follows_every_row(scene, course)) return {};
  return fmt::format(
      "crack.history: the smoothed history goes through nearly every one of the {} rows ({:.0f} degrees of "
      "freedom), as they have no uncertainty: if they scatter, a column 'uncertainty' says by how much",
      scene.crack.history.size(), course.degrees_of_freedom);
}

/// A tip cannot run through faces that it has parted: what it meets a second time is gone already.
std::string note_on_path(const Scene& scene) {
  if (scene.crack.path.point.empty()) return {};
  const auto length = [](double x) { return rounded_text(x, Dimension::length); };
  const auto crossing = self_crossing(path_points_m(scene));
  if (!crossing) return {};
  return fmt::format(
      "crack.path crosses itself at ({}, {}), {} and again {} along it: each beam is released at the first "
      "crossing, and the part inside the loop comes loose",
      length(crossing->at[0]), length(crossing->at[1]), length(crossing->first), length(crossing->second));
}

}  // namespace

bool follows_every_row(const Scene& scene, const history::SmoothedHistory& course) {
  constexpr double nearly = 0.8;  // of the rows
  const std::vector<history::HistoryPoint>& rows = scene.crack.history;
  const bool smoothed = scene.crack.smoothing != history::Smoothing::none && rows.size() > 3;
  return smoothed && course.degrees_of_freedom > nearly * static_cast<double>(rows.size()) &&
         std::none_of(rows.begin(), rows.end(),
                      [](const history::HistoryPoint& row) { return row.uncertainty > 0.0; });
}

std::vector<std::string> notes_on_rows(const Preset& preset) {
  std::vector<std::string> notes;
  const auto take = [&](std::string note) {
    if (!note.empty() && std::find(notes.begin(), notes.end(), note) == notes.end())
      notes.push_back(std::move(note));
  };
  take(note_on_missing_rows(preset));
  take(note_on_noise(preset.scene));
  take(note_on_path(preset.scene));
  for (const Scene& lane : preset.lanes) take(note_on_path(lane));
  return notes;
}

}  // namespace rift::scene
