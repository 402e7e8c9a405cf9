#include "studio/screen/live.hpp"

#include "studio/report/progress.hpp"
#include "studio/screen/curves.hpp"
#include "studio/screen/plate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rift::studio {
namespace {

constexpr double microsecond = 1e-6, millimetre = 1e-3;

double kinetic_of(const results::Sample& s) { return s.kinetic_translation_j + s.kinetic_rotation_j; }

/// An entry of the budget: its name, colour and value.
struct Entry {
  const char* name;
  Ink ink;
  double (*value)(const results::Sample&);
};
constexpr Entry entries[] = {
    {"elastic", Ink::elastic, [](const results::Sample& s) { return s.elastic_j; }},
    {"kinetic", Ink::kinetic, kinetic_of},
    {"fracture", Ink::fracture, [](const results::Sample& s) { return s.fracture_j; }},
    {"damping", Ink::damping, [](const results::Sample& s) { return s.damping_j + s.numerical_damping_j; }},
    {"external", Ink::reference, [](const results::Sample& s) { return s.work_external_j; }},
};

double most_energy(const LiveLane& lane) {
  double most = 0;
  for (const Entry& entry : entries)
    for (const results::Sample& s : lane.books) most = std::max(most, std::abs(entry.value(s)));
  return most > 0 ? most : 1;
}

/// A bar of full blocks and one of eighths   [Unicode 15, block elements].
void draw_bar(Canvas& canvas, int x, int y, int width, double part, const Style& style, Glyphs glyphs) {
  const int eighths = static_cast<int>(std::lround(std::clamp(part, 0.0, 1.0) * width * 8));
  for (int k = 0; k < eighths / 8; ++k) canvas.put(x + k, y, glyphs == Glyphs::unicode ? U'█' : U'#', style);
  if (eighths % 8 > 0 && glyphs == Glyphs::unicode)
    canvas.put(x + eighths / 8, y, static_cast<char32_t>(U'█' + (8 - eighths % 8)), style);
}

void draw_head(Canvas& canvas, const Area& area, const Live& live, Glyphs glyphs) {
  const Ink state = live.state == "running" || live.state == "finished" ? Ink::good : Ink::bad;
  int x = canvas.text(area.x, area.y, live.name, {Ink::title, true}, area.width) + 2;
  x += canvas.text(x, area.y, live.state, {state, true}) + 2;
  std::string text = fmt::format("step {} of {}", live.step, live.steps);
  if (live.steps_per_s > 0) text += fmt::format("   {} steps/s", magnitude_text(live.steps_per_s));
  if (live.seconds_left >= 0) text += "   " + duration_text(live.seconds_left) + " left";
  canvas.text(x, area.y, text, {Ink::dim}, area.width - x);
  if (area.height < 2) return;
  canvas.text(area.x, area.y + 1, fmt::format("{:3.0f} %", 100 * live.done), {}, area.width);
  draw_bar(canvas, area.x + 6, area.y + 1, area.width - 6, live.done, {Ink::good}, glyphs);
}

void draw_budget(Canvas& canvas, const Area& area, const LiveLane& lane, double limit, Glyphs glyphs) {
  if (area.empty() || lane.books.empty()) return;
  const results::Sample& last = lane.books.back();
  const double most = most_energy(lane);
  constexpr int names = 9, numbers = 11;
  int y = area.y;
  for (const Entry& entry : entries) {
    if (y >= area.y + area.height) return;
    const double value = entry.value(last);
    canvas.text(area.x, y, entry.name, {entry.ink, true}, area.width);
    canvas.text(area.x + names, y, fmt::format("{:>9.4g} J", value), {}, area.width - names);
    draw_bar(canvas, area.x + names + numbers + 1, y, area.width - names - numbers - 1,
             std::abs(value) / most, {entry.ink}, glyphs);
    ++y;
  }
  if (y >= area.y + area.height) return;
  const bool closes = std::abs(last.residual) <= limit;
  const std::string text = fmt::format("{:.1e} of the energy, {} {:.0e}", std::abs(last.residual),
                                       closes ? "within" : "BEYOND", limit);
  canvas.text(area.x, y, "residual", {closes ? Ink::good : Ink::bad, true}, area.width);
  canvas.text(area.x + names, y, text, {closes ? Ink::plain : Ink::bad, !closes}, area.width - names);
}

void draw_table(Canvas& canvas, const Area& area, const Live& live, int shown) {
  if (area.empty()) return;
  canvas.text(area.x, area.y, fmt::format("{:<32}{:>8}{:>8}", "lane", "tip mm", "G/G0"), {Ink::dim},
              area.width);
  for (int k = 0; k < static_cast<int>(live.lanes.size()) && k + 1 < area.height; ++k) {
    const LiveLane& lane = live.lanes[k];
    const std::string tip =
        lane.books.empty() ? "" : fmt::format("{:.1f}", lane.books.back().tip_m / millimetre);
    const std::string rate = lane.rates.empty() ? "" : fmt::format("{:.3f}", lane.rates.back().ratio);
    Style style{Ink::plain};
    style.reverse = k == shown;
    const int title = std::max(8, std::min(30, area.width - 18));
    std::u32string name = letters_of(fmt::format("{} {}", k + 1, lane.title)).substr(0, title);
    name.resize(title, U' ');
    for (int x = 0; x < title; ++x) canvas.put(area.x + x, area.y + 1 + k, name[x], style);
    canvas.text(area.x + title, area.y + 1 + k, fmt::format("{:>9}{:>8}", tip, rate), style,
                area.width - title);
  }
}

void draw_energies(Canvas& canvas, const Area& area, const LiveLane& lane, Glyphs glyphs) {
  if (area.empty() || lane.books.size() < 2) return;
  const double start = lane.books.front().time_s, end = lane.books.back().time_s;
  std::vector<Curve> curves;
  for (const Entry& entry : entries) {
    Curve& curve = curves.emplace_back();
    curve.style.ink = entry.ink;
    for (const results::Sample& s : lane.books)
      curve.points.push_back({(s.time_s - start) / microsecond, entry.value(s)});
    if (std::all_of(curve.points.begin(), curve.points.end(), [](const auto& p) { return p[1] == 0; }))
      curves.pop_back();
  }
  draw_curves(canvas, area,
              {{0, (end - start) / microsecond}, {0, most_energy(lane)}, "time [us]", "energy [J]"}, curves,
              glyphs);
}

Curve level(double value, double until) { return {{{0, value}, {until, value}}, {Ink::reference}}; }

void draw_rates(Canvas& canvas, const Area& area, const Live& live, int shown, Glyphs glyphs) {
  if (area.empty()) return;
  const double length = live.length / millimetre;
  std::vector<Curve> curves;
  const LiveLane& lane = live.lanes[shown];
  if (lane.broberg) curves.push_back(level(*lane.broberg, length));
  if (lane.strip) curves.push_back(level(*lane.strip, length));
  double most = 1.2;
  for (int pass = 0; pass < 2; ++pass)  // the lane that is shown lies over the others
    for (int k = 0; k < static_cast<int>(live.lanes.size()); ++k) {
      if ((k == shown) != (pass == 1)) continue;
      Curve& curve = curves.emplace_back();
      curve.style = k == shown ? Style{Ink::fracture, true} : Style{Ink::dim};
      for (const results::RatePoint& p : live.lanes[k].rates) {
        curve.points.push_back({p.tip_m / millimetre, p.ratio});
        if (k == shown) most = std::max(most, std::min(p.ratio, 3.0));
      }
    }
  draw_curves(canvas, area, {{0, length}, {0, most}, "tip [mm]", "G_ID/G_I0; lines: Broberg, strip"}, curves,
              glyphs);
}

void draw_too_small(Canvas& canvas) {
  canvas.text(0, std::max(0, canvas.height() / 2),
              fmt::format("{}x{} is too small: {}x{} needed", canvas.width(), canvas.height(), least_width,
                          least_height),
              {Ink::bad, true});
}

}  // namespace

void draw_live(Canvas& canvas, const Live& live, int shown, std::string_view keys, Glyphs glyphs) {
  if (canvas.width() < least_width || canvas.height() < least_height) return draw_too_small(canvas);
  const LiveLayout layout = live_layout(canvas.width(), canvas.height(), static_cast<int>(live.lanes.size()));
  draw_head(canvas, layout.head, live, glyphs);
  canvas.text(layout.foot.x, layout.foot.y, keys, {Ink::dim}, layout.foot.width);
  if (live.lanes.empty()) return;
  const LiveLane& lane = live.lanes[shown];
  if (live.geometry != nullptr)
    draw_plate(canvas, layout.plate, *live.geometry, lane.displacement,
               {live.length, live.height, live.pulled, lane.tips}, glyphs);
  draw_budget(canvas, layout.budget, lane, live.ledger_limit, glyphs);
  draw_table(canvas, layout.table, live, shown);
  draw_energies(canvas, layout.energies, lane, glyphs);
  draw_rates(canvas, layout.rates, live, shown, glyphs);
}

}  // namespace rift::studio
