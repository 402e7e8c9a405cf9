#include "studio/screen/live.hpp"

#include "studio/screen/canvas.hpp"
#include "studio/screen/curves.hpp"
#include "studio/screen/plate.hpp"
#include "studio/text/progress.hpp"

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
  bool always = true;  // else only where there is any
};
constexpr Entry entries[] = {
    {"elastic", Ink::elastic, [](const results::Sample& s) { return s.elastic_j; }},
    {"kinetic", Ink::kinetic, kinetic_of},
    {"fracture", Ink::fracture, [](const results::Sample& s) { return s.fracture_j; }},
    {"damping", Ink::damping, [](const results::Sample& s) { return s.damping_j + s.numerical_damping_j; }},
    {"contact", Ink::damping, [](const results::Sample& s) { return s.contact_j; }, false},
    {"external", Ink::reference, [](const results::Sample& s) { return s.work_external_j; }},
};

double most_energy(const LiveLane& lane) {
  double most = 0;
  for (const Entry& entry : entries)
    for (const results::Sample& s : lane.samples) most = std::max(most, std::abs(entry.value(s)));
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
  const bool bad = live.state == "diverged" || live.state == "failed" || live.state.starts_with("damaged");
  const bool held = live.state == "paused" || live.state == "stopped";
  const Ink state = bad ? Ink::bad : held ? Ink::reference : Ink::good;
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
  if (area.empty() || lane.samples.empty()) return;
  const results::Sample& last = lane.samples.back();
  const double most = most_energy(lane);
  constexpr int names = 9, numbers = 11;
  int y = area.y;
  for (const Entry& entry : entries) {
    if (y >= area.y + area.height) return;
    const double value = entry.value(last);
    if (!entry.always && value == 0.0) continue;
    canvas.text(area.x, y, entry.name, {entry.ink, true}, area.width);
    canvas.text(area.x + names, y, fmt::format("{:>9.4g} J", value), {}, area.width - names);
    draw_bar(canvas, area.x + names + numbers + 1, y, area.width - names - numbers - 1,
             std::abs(value) / most, {entry.ink}, glyphs);
    ++y;
  }
  if (y >= area.y + area.height) return;
  const bool closes = std::abs(last.residual) <= limit;
  const std::string text =
      fmt::format("error {:.1e}{} {:.0e}", std::abs(last.residual), closes ? ", limit" : " ABOVE", limit);
  canvas.text(area.x, y, "balance", {closes ? Ink::good : Ink::bad, true}, area.width);
  canvas.text(area.x + names, y, text, {closes ? Ink::plain : Ink::bad, !closes}, area.width - names);
}

/// A column of the table of lanes: what it says of one.
struct Column {
  const char* name;
  int width;
  std::string (*text)(const LiveLane& lane);
};
const Column columns[] = {
    {"tip mm", 8,
     [](const LiveLane& lane) {
       return lane.samples.empty() ? "" : fmt::format("{:.1f}", lane.samples.back().tip_m / millimetre);
     }},
    {"G/G0", 7,
     [](const LiveLane& lane) {
       return lane.rates.empty() ? "" : fmt::format("{:.3f}", lane.rates.back().ratio);
     }},
    {"kinetic J", 11,
     [](const LiveLane& lane) {
       return lane.samples.empty() ? "" : fmt::format("{:.3g}", kinetic_of(lane.samples.back()));
     }},
    {"bal. error", 11,
     [](const LiveLane& lane) {
       return lane.samples.empty() ? "" : fmt::format("{:.0e}", std::abs(lane.samples.back().residual));
     }},
};

/// How many letters of the titles it takes to tell them apart.
int letters_that_tell_apart(const std::vector<LiveLane>& lanes) {
  std::vector<std::u32string> titles;
  for (const LiveLane& lane : lanes) titles.push_back(letters_of(lane.title));
  std::ranges::sort(titles);
  std::ptrdiff_t needed = 0;
  for (std::size_t k = 1; k < titles.size(); ++k) {
    const auto common = std::ranges::mismatch(titles[k - 1], titles[k]).in2 - titles[k].begin();
    needed = std::max(needed, common + 1);
  }
  return static_cast<int>(needed);
}

void draw_table(Canvas& canvas, const Area& area, const Live& live, const LiveLook& look) {
  if (area.empty()) return;
  int title = area.width, shown = 0;  // as many columns as leave room for the title
  const int number = static_cast<int>(std::to_string(live.lanes.size()).size()) + 1;
  const int needed = std::max(20, number + letters_that_tell_apart(live.lanes) + 1);
  for (const Column& column : columns) {
    if (title - column.width < needed && shown > 0) break;
    title -= column.width, ++shown;
  }
  const auto line = [&](int y, const std::string& name, const Style& style, auto&& text_of) {
    std::u32string padded = letters_of(name).substr(0, title);
    padded.resize(title, U' ');
    for (int x = 0; x < title; ++x) canvas.put(area.x + x, y, padded[x], style);
    int x = area.x + title;
    for (int c = 0; c < shown; ++c) {
      canvas.text(x, y, fmt::format("{:>{}}", text_of(columns[c]), columns[c].width), style,
                  columns[c].width);
      x += columns[c].width;
    }
  };
  line(area.y, "lane", {Ink::dim}, [](const Column& column) { return std::string(column.name); });
  for (int k = 0; k < static_cast<int>(live.lanes.size()) && k + 1 < area.height; ++k) {
    Style style{k == look.beside ? Ink::elastic : Ink::plain};
    style.reverse = k == look.shown;
    line(area.y + 1 + k, fmt::format("{} {}", k + 1, live.lanes[k].title), style,
         [&](const Column& column) { return column.text(live.lanes[k]); });
  }
}

void draw_energies(Canvas& canvas, const Area& area, const LiveLane& lane, Glyphs glyphs) {
  if (area.empty() || lane.samples.size() < 2) return;
  const double start = lane.samples.front().time_s, end = lane.samples.back().time_s;
  std::vector<Curve> curves;
  for (const Entry& entry : entries) {
    Curve& curve = curves.emplace_back();
    curve.style.ink = entry.ink;
    for (const results::Sample& s : lane.samples)
      curve.points.push_back({(s.time_s - start) / microsecond, entry.value(s)});
    if (std::all_of(curve.points.begin(), curve.points.end(), [](const auto& p) { return p[1] == 0; }))
      curves.pop_back();
  }
  draw_curves(canvas, area,
              {{0, (end - start) / microsecond},
               {0, most_energy(lane)},
               glyphs == Glyphs::unicode ? "time [µs]" : "time [us]",
               "energy [J]"},
              curves, glyphs);
}

Curve level(double value, double until) { return {{{0, value}, {until, value}}, {Ink::reference}}; }

void draw_rates(Canvas& canvas, const Area& area, const Live& live, const LiveLook& look, Glyphs glyphs) {
  if (area.empty()) return;
  const double length = live.length / millimetre;
  std::vector<Curve> curves;
  const LiveLane& lane = live.lanes[look.shown];
  if (lane.broberg) curves.push_back(level(*lane.broberg, length));
  if (lane.strip) curves.push_back(level(*lane.strip, length));
  double most = 1.2;
  std::vector<int> order;  // the lane that is shown lies over the one beside it, that one over the others
  for (int k = 0; k < static_cast<int>(live.lanes.size()); ++k)
    if (k != look.shown && k != look.beside) order.push_back(k);
  if (look.beside >= 0 && look.beside != look.shown) order.push_back(look.beside);
  order.push_back(look.shown);
  for (const int k : order) {
    Curve& curve = curves.emplace_back();
    curve.style = k == look.shown    ? Style{Ink::fracture, true}
                  : k == look.beside ? Style{Ink::elastic}
                                     : Style{Ink::dim};
    for (const results::RatePoint& p : live.lanes[k].rates) {
      curve.points.push_back({p.tip_m / millimetre, p.ratio});
      if (k == look.shown || k == look.beside) most = std::max(most, std::min(p.ratio, 3.0));
    }
  }
  draw_curves(canvas, area, {{0, length}, {0, most}, "tip [mm]", "G_ID/G_I0; lines: Broberg, strip"}, curves,
              glyphs);
}

void draw_plate_of(Canvas& canvas, const Area& area, const Live& live, int k, bool velocity, Ink title,
                   Glyphs glyphs) {
  if (area.empty() || live.geometry == nullptr) return;
  const LiveLane& lane = live.lanes[k];
  Area plate = area;
  if (live.lanes.size() > 1) {
    canvas.text(area.x, area.y, fmt::format("{} {}", k + 1, lane.title), {title, true}, area.width);
    ++plate.y, --plate.height;
  }
  PlateLook look{live.length, live.height, live.pulled, lane.tips};
  if (velocity) look.velocity = lane.velocity, look.fastest = live.fastest;
  draw_plate(canvas, plate, *live.geometry, lane.displacement, look, glyphs);
}

}  // namespace

void draw_live(Canvas& canvas, const Live& live, const LiveLook& look, Glyphs glyphs) {
  if (draw_too_small(canvas)) return;
  const bool two = look.beside >= 0 && look.beside < static_cast<int>(live.lanes.size());
  const LiveLayout layout =
      live_layout(canvas.width(), canvas.height(), static_cast<int>(live.lanes.size()), two);
  draw_head(canvas, layout.head, live, glyphs);
  canvas.text(layout.message.x, layout.message.y, live.message, {Ink::good}, layout.message.width);
  canvas.text(layout.foot.x, layout.foot.y, look.foot, {Ink::dim}, layout.foot.width);
  if (live.lanes.empty()) return;
  const LiveLane& lane = live.lanes[look.shown];
  draw_plate_of(canvas, layout.plate, live, look.shown, look.velocity, Ink::fracture, glyphs);
  if (two) draw_plate_of(canvas, layout.plate_beside, live, look.beside, look.velocity, Ink::elastic, glyphs);
  draw_budget(canvas, layout.budget, lane, live.ledger_limit, glyphs);
  draw_table(canvas, layout.table, live, look);
  draw_energies(canvas, layout.energies, lane, glyphs);
  draw_rates(canvas, layout.rates, live, look, glyphs);
}

// From above: two lines of head, the plate or two of them, bars beside the table, two plots side by side, a
// line of what happened, a line of keys. On a low screen the plate goes first.
LiveLayout live_layout(int width, int height, int lanes, bool two) {
  LiveLayout layout;
  if (width <= 0 || height <= 0) return layout;
  layout.head = {0, 0, width, std::min(2, height)};
  layout.foot = {0, height - 1, width, height >= 3 ? 1 : 0};
  if (width < least_width || height < least_height) return layout;
  layout.message = {0, height - 2, width, 1};
  int top = layout.head.height, left = height - layout.head.height - 2;
  constexpr int least_plots = 6;
  const int bars = 6, rows = lanes > 1 ? std::min(lanes + 1, 9) : 0, middle = std::max(bars, rows);
  const int plate = std::min({left - middle - least_plots - 1, (two ? width / 2 : width) / 8 + 1, 26});
  if (plate >= 3) {
    layout.plate = {0, top, two ? width / 2 - 1 : width, plate};
    if (two) layout.plate_beside = {width / 2 + 1, top, width - width / 2 - 1, plate};
    top += plate + 1;
    left -= plate + 1;
  }
  const int half = lanes > 1 ? width / 2 : width;
  layout.budget = {0, top, half - (lanes > 1 ? 1 : 0), std::min(bars, left)};
  if (lanes > 1) layout.table = {half, top, width - half, std::min(rows, left)};
  top += middle;
  left -= middle;
  if (left < 5) return layout;
  layout.energies = {0, top, width / 2 - 1, left};
  layout.rates = {width / 2, top, width - width / 2, left};
  return layout;
}

}  // namespace rift::studio
