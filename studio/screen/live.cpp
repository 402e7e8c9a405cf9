#include "studio/screen/live.hpp"

#include "studio/screen/canvas.hpp"
#include "studio/screen/live_parts.hpp"
#include "studio/screen/plate.hpp"
#include "studio/text/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rift::studio {
namespace {

/// The largest balance error of all lanes, where it is beyond its limit; else 0.
double error_beyond_limit(const Live& live) {
  double largest = 0;
  for (const LiveLane& lane : live.lanes)
    if (!lane.samples.empty()) largest = std::max(largest, std::abs(lane.samples.back().residual));
  return largest > live.ledger_limit ? largest : 0;
}

void draw_head(Canvas& canvas, const Area& area, const Live& live, Glyphs glyphs) {
  const bool bad = live.state == "diverged" || live.state == "failed" || live.state.starts_with("damaged");
  const bool held = live.state == "paused" || live.state == "stopped";
  const Ink state = bad ? Ink::bad : held ? Ink::reference : Ink::good;
  int x = canvas.text(area.x, area.y, live.name, {Ink::title, true}, area.width) + 2;
  x += canvas.text(x, area.y, live.state, {state, true}) + 2;
  std::string text = fmt::format("step {} of {}", live.step, live.steps);
  if (const double error = error_beyond_limit(live); error > 0)
    x +=
        canvas.text(x, area.y, fmt::format("balance error {:.0e}", error), {Ink::bad, true}, area.width - x) +
        2;
  if (live.steps_per_s > 0) text += fmt::format("   {} steps/s", magnitude_text(live.steps_per_s));
  if (live.seconds_left >= 0) text += "   " + duration_text(live.seconds_left) + " left";
  canvas.text(x, area.y, text, {Ink::dim}, area.width - x);
  if (area.height < 2) return;
  canvas.text(area.x, area.y + 1, fmt::format("{:3.0f} %", 100 * live.done), {}, area.width);
  draw_bar(canvas, area.x + 6, area.y + 1, area.width - 6, live.done, {Ink::good}, glyphs);
}

bool shows_velocity(const Live& live, const LiveLook& look) {
  return look.velocity && live.lanes[look.shown].velocity.size() == live.geometry->position.size();
}

/// Of several lanes the first line of a plate's place is its title.
Area below_title(Area area, std::size_t lanes) {
  if (lanes > 1) ++area.y, --area.height;
  return area;
}

void draw_plate_of(Canvas& canvas, const Area& area, const Live& live, int k, const LiveLook& look, Ink title,
                   Glyphs glyphs) {
  if (area.empty() || live.geometry == nullptr) return;
  const LiveLane& lane = live.lanes[k];
  if (live.lanes.size() > 1)
    canvas.text(area.x, area.y, fmt::format("{} {}", k + 1, lane.title), {title, true}, area.width);
  if (look.picture) return;
  PlateLook plate{live.length, live.height, live.pulled, lane.tips};
  if (look.velocity) plate.velocity = lane.velocity, plate.fastest = live.fastest;
  draw_plate(canvas, below_title(area, live.lanes.size()), *live.geometry, lane.displacement, plate, glyphs);
}

/// What the colours of the plates mean.
void draw_colours(Canvas& canvas, const Area& area, const Live& live, const LiveLook& look, Glyphs glyphs) {
  if (area.empty() || live.geometry == nullptr) return;
  const bool velocity = shows_velocity(live, look);
  const double most = velocity ? live.fastest : 1e3 * live.pulled;
  int x = area.x;
  const auto say = [&](const std::string& text) {
    x += canvas.text(x, area.y, text, {Ink::dim}, area.x + area.width - x);
  };
  say(velocity ? "vertical velocity [m/s]  " : "vertical displacement [mm]  ");
  say(fmt::format("{:.3g} ", velocity ? -most : 0.0));
  draw_scale(canvas, x, area.y, glyphs);
  x += shade_steps;
  say(fmt::format(" {:.3g}   ", most));
  say(glyphs == Glyphs::unicode ? "shape ×1, ● tip" : "shape x1, @ tip");
}

}  // namespace

LiveLayout layout_of(const Live& live, const LiveLook& look, int width, int height) {
  const bool two = look.beside >= 0 && look.beside < static_cast<int>(live.lanes.size());
  const double aspect = live.height > 0 ? live.length / (live.height + live.pulled) : 1;
  return live_layout(width, height, static_cast<int>(live.lanes.size()), two, aspect);
}

Area place_of_plates(const Live& live, const LiveLook& look, int width, int height) {
  const LiveLayout layout = layout_of(live, look, width, height);
  Area place = layout.plate;
  if (!layout.plate_beside.empty()) place.width = layout.plate_beside.x + layout.plate_beside.width - place.x;
  return below_title(place, live.lanes.size());
}

void draw_live(Canvas& canvas, const Live& live, const LiveLook& look, Glyphs glyphs) {
  if (draw_too_small(canvas)) return;
  const LiveLayout layout = layout_of(live, look, canvas.width(), canvas.height());
  draw_head(canvas, layout.head, live, glyphs);
  canvas.text(layout.message.x, layout.message.y, live.message, {Ink::good}, layout.message.width);
  canvas.text(layout.foot.x, layout.foot.y, look.foot, {Ink::dim}, layout.foot.width);
  if (live.lanes.empty()) return;
  const LiveLane& lane = live.lanes[look.shown];
  draw_plate_of(canvas, layout.plate, live, look.shown, look, Ink::fracture, glyphs);
  if (!layout.plate_beside.empty())
    draw_plate_of(canvas, layout.plate_beside, live, look.beside, look, Ink::elastic, glyphs);
  draw_colours(canvas, layout.colours, live, look, glyphs);
  draw_balance(canvas, layout.balance, lane, live.ledger_limit, glyphs);
  draw_result(canvas, layout.result, lane, glyphs);
  draw_lanes(canvas, layout.table, live, look);
  draw_energies(canvas, layout.energies, lane, glyphs);
  draw_rates(canvas, layout.rates, live, look, glyphs);
}

// From above: two lines of head, the plate or two of them and what its colours mean, bars beside the result
// or the table, two plots side by side, a line of what happened, a line of keys. On a low screen the plate
// comes first: the table of lanes then takes the place of the bars, and the plots what is left.
LiveLayout live_layout(int width, int height, int lanes, bool two, double aspect) {
  LiveLayout layout;
  if (width <= 0 || height <= 0) return layout;
  layout.head = {0, 0, width, std::min(2, height)};
  layout.foot = {0, height - 1, width, height >= 3 ? 1 : 0};
  if (width < least_width || height < least_height) return layout;
  layout.message = {0, height - 2, width, 1};
  constexpr int bars = 6, few_bars = 3, plots = 6, least_plots = 4;
  const bool several = lanes > 1;
  const int title = several ? 1 : 0, least_plate = 4 + title;
  const double natural = (two ? width / 2 : width) / (2 * aspect);  // a cell is about twice as high as wide
  const int wanted = static_cast<int>(std::clamp(std::ceil(natural) + title, 1.0 * least_plate, 26.0));
  const int rows = several ? std::min(lanes + 1, 9) : bars;
  int left = height - layout.head.height - 2 - 1;  // the last one for the colours
  const bool low = left - std::max(bars, rows) - plots < least_plate;
  const int middle = !low ? std::max(bars, rows) : several ? std::min(rows, left - least_plate) : few_bars;
  left -= middle;
  const bool plotted = left - least_plate >= least_plots;
  const int plate = plotted ? std::clamp(left - plots, least_plate, wanted) : std::min(left, wanted);
  int top = layout.head.height;
  layout.plate = {0, top, two ? width / 2 - 1 : width, plate};
  if (two) layout.plate_beside = {width / 2 + 1, top, width - width / 2 - 1, plate};
  layout.colours = {0, top + plate, width, 1};
  top += plate + 1;
  const int half = width / 2;
  const bool wide_table = several && low;
  if (!wide_table) layout.balance = {0, top, half - 1, middle};
  (several ? layout.table : layout.result) =
      wide_table ? Area{0, top, width, middle} : Area{half, top, width - half, std::min(rows, middle)};
  top += middle;
  left -= plate;
  if (!plotted) return layout;
  layout.energies = {0, top, half - 1, left};
  layout.rates = {half, top, width - half, left};
  return layout;
}

}  // namespace rift::studio
