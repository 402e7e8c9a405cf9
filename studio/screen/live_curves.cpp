#include "studio/screen/curves.hpp"
#include "studio/screen/live_parts.hpp"

#include <algorithm>

namespace rift::studio {
namespace {

constexpr double us = 1e-6, mm = 1e-3;

/// A line across the chart at the value of a theory.
Curve level(double value, double until, Ink ink, const char* name, char32_t mark) {
  return {{{0, value}, {until, value}}, {ink}, name, mark, Marks::last};
}

}  // namespace

void draw_energies(Canvas& canvas, const Area& area, const LiveLane& lane, Glyphs glyphs) {
  if (area.empty() || lane.samples.size() < 2) return;
  const double start = lane.samples.front().time_s, end = lane.samples.back().time_s;
  std::vector<Curve> curves;
  for (const EnergyEntry& entry : energy_entries()) {
    Curve curve{{}, {entry.ink}, entry.name, static_cast<char32_t>(entry.name[0]), Marks::last};
    for (const results::Sample& s : lane.samples)
      curve.points.push_back({(s.time_s - start) / us, entry.value(s)});
    const bool any =
        std::any_of(curve.points.begin(), curve.points.end(), [](const auto& p) { return p[1] != 0; });
    if (any) curves.push_back(std::move(curve));
  }
  draw_curves(canvas, area,
              {{0, (end - start) / us},
               {0, largest_energy(lane)},
               glyphs == Glyphs::unicode ? "time [µs]" : "time [us]",
               "energy [J]"},
              curves, glyphs);
}

void draw_rates(Canvas& canvas, const Area& area, const Live& live, const LiveLook& look, Glyphs glyphs) {
  if (area.empty()) return;
  const double length = live.length / mm;
  std::vector<Curve> curves;
  const LiveLane& lane = live.lanes[look.shown];
  if (lane.broberg) curves.push_back(level(*lane.broberg, length, Ink::reference, "Broberg", U'B'));
  if (lane.freund) curves.push_back(level(*lane.freund, length, Ink::damping, "Freund", U'F'));
  if (lane.strip) curves.push_back(level(*lane.strip, length, Ink::dim, "strip", U's'));
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
    if (live.lanes.size() > 1) curve.mark = static_cast<char32_t>(U'1' + k), curve.marks = Marks::last;
    for (const results::RatePoint& p : live.lanes[k].rates) {
      curve.points.push_back({p.tip_m / mm, p.ratio});
      if (k == look.shown || k == look.beside) most = std::max(most, std::min(p.ratio, 3.0));
    }
  }
  draw_curves(canvas, area, {{0, length}, {0, most}, "tip [mm]", "G_ID/G_I0"}, curves, glyphs);
}

}  // namespace rift::studio
