#include "engine/scene/notes_on_rows.hpp"

#include "engine/scene/contradictions_rows.hpp"
#include "engine/scene/derived.hpp"
#include "engine/scene/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace rift::scene {
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
  return fmt::format("{}: {} of every {} {} to be missing: {}; the course is drawn through their neighbours",
                     from == preset.rows.end() ? "crack.history" : from->second.file,
                     missing == 1 ? "1 row" : fmt::format("{} rows", missing),
                     rounded_text(usual, Dimension::time), missing == 1 ? "seems" : "seem", where);
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

/// A tip cannot run through faces that it has parted: what it meets a second time is gone already.
std::string note_on_path(const Scene& scene) {
  if (scene.crack.path.point.empty()) return {};
  const auto length = [](double x) { return rounded_text(x, Dimension::length); };
  const auto crossing = self_crossing(path_points_m(scene));
  if (!crossing) return {};
  return fmt::format(
      "crack.path crosses itself at ({}, {}), {} and again {} along it: each beam is released at the first "
      "crossing, and what the loop encloses comes loose",
      length(crossing->at[0]), length(crossing->at[1]), length(crossing->first), length(crossing->second));
}

}  // namespace

std::vector<std::string> notes_on_rows(const Preset& preset) {
  std::vector<std::string> notes;
  const auto take = [&](std::string note) {
    if (!note.empty() && std::find(notes.begin(), notes.end(), note) == notes.end())
      notes.push_back(std::move(note));
  };
  take(note_on_missing_rows(preset));
  take(note_on_path(preset.scene));
  for (const Scene& lane : preset.lanes) take(note_on_path(lane));
  return notes;
}

}  // namespace rift::scene
