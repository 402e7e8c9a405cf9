#include "viz/layout.hpp"

#include <algorithm>
#include <cmath>

namespace rift::viz {
namespace {

/// How much more than the plate's length and height is shown, so that its edges are seen and what is drawn
/// around it has room.
double beside(const Look& look) { return look.boundaries ? 1.2 : 1.08; }
double above(const Look& look) { return look.boundaries ? 1.9 : 1.12; }

bool on_one_line(double cell_width, double text) { return cell_width > 46 * text; }

double caption_height(double cell_width, double text) {
  return (on_one_line(cell_width, text) ? 1.7 : 3.15) * text;
}

/// Above a picture: its title on the left and the moment on the right, or one above the other.
PaneLayout pane_layout(const Box& cell, double text) {
  const bool one_line = on_one_line(cell.width(), text);
  const double line = 1.45 * text, middle = 0.5 * (cell.x0 + cell.x1);
  const double below = one_line ? cell.y1 - line : cell.y1 - 2 * line;
  return {.title = {cell.x0, cell.y1 - line, one_line ? middle : cell.x1, cell.y1},
          .moment = {one_line ? middle : cell.x0, below, cell.x1, below + line},
          .picture = {cell.x0, cell.y0, cell.x1, below - 0.25 * text}};
}

/// Foreshortened by the side camera, with room for what stands out of the plane.
double seen_height(const Look& look, const Extent& plate) {
  return look.camera == Camera::side ? 1.5 * plate.height * std::cos(side_tilt) : plate.height;
}

/// One column or two, for which the plates are larger.
int columns_for(int panes, double width, double height, double text, double aspect) {
  int best = 1;
  double largest = 0;
  for (int columns = 1; columns <= std::min(panes, 2); ++columns) {
    const int rows = (panes + columns - 1) / columns;
    const double shown =
        std::min(width / columns, (height / rows - caption_height(width / columns, text)) * aspect);
    if (shown > 1.01 * largest) {
      largest = shown;
      best = columns;
    }
  }
  return best;
}

}  // namespace

bool holds(const Box& box, const std::array<double, 2>& p) {
  return p[0] >= box.x0 && p[0] <= box.x1 && p[1] >= box.y0 && p[1] <= box.y1;
}

Layout layout_of(const Job& job, const Extent& plate) {
  const double w = job.width, h = job.height;
  const int panes = static_cast<int>(job.panes.size());
  Layout layout;
  layout.text_px = static_cast<int>(std::lround(std::min(h / 42, w / 60) * (!job.look.large_text ? 1.0
                                                                            : panes > 2          ? 1.25
                                                                                                 : 1.5)));
  const double margin = layout.text_px, chart_text = layout.text_px;
  // Without texts nothing is left for them.
  const double text = job.look.texts ? layout.text_px : 0, bar = 3.9 * text;
  layout.title = {margin, h - 2.6 * text, w - margin, h - 0.5 * text};

  const bool whole = job.look.camera != Camera::tip;
  const double aspect =
      whole ? beside(job.look) * plate.length / (above(job.look) * seen_height(job.look, plate)) : 1.6;
  const bool charts = job.look.chart != Chart::none;
  double chart = charts ? std::max(0.24 * h, 8.5 * chart_text) : 0;
  const double top = layout.title.y0 - 0.3 * text;
  const double inner = w - 2 * margin;
  const int columns = columns_for(panes, inner, top - bar - chart, text, aspect);
  const int rows = (panes + columns - 1) / columns;
  const double cell_width = (inner - (columns - 1) * margin) / columns;
  double cell_height = (top - bar - chart) / rows;
  if (whole) {  // what a wide plate leaves free goes to the chart, and then around the plate
    const double needed = caption_height(cell_width, text) + cell_width / aspect;
    const double spare = std::max(0.0, rows * (cell_height - needed));
    if (charts) chart = std::min(chart + spare, std::max(chart, 0.42 * h));
    cell_height = (top - bar - chart) / rows;
  }
  for (int k = 0; k < panes; ++k) {
    const double x0 = margin + (k % columns) * (cell_width + margin);
    const double y1 = top - (k / columns) * cell_height;
    layout.panes.push_back(pane_layout({x0, y1 - cell_height, x0 + cell_width, y1}, text));
  }
  layout.colour_bar = {0.24 * w, chart + 0.3 * text, 0.76 * w, chart + bar - 0.2 * text};
  layout.scale_bar = {margin, layout.colour_bar.y0, 0.2 * w, layout.colour_bar.y1};
  layout.beam_bar = {0.82 * w, layout.colour_bar.y0, w - 2 * margin, layout.colour_bar.y1};
  layout.key = {margin, chart - 1.5 * chart_text, w - margin, chart};
  const bool whole_charts = job.look.chart == Chart::whole;
  const int places = charts ? panes + (whole_charts ? 1 : 0) : 0;
  for (int k = 0; k < places; ++k) {
    const double width = (inner - (places - 1) * margin) / places, x0 = margin + k * (width + margin);
    layout.chart.push_back({x0, 0.3 * chart_text, x0 + width, layout.key.y0});
  }
  if (whole_charts) {
    layout.ratio = layout.chart.back();
    layout.chart.pop_back();
  }
  return layout;
}

Window window_of(const Look& look, const Box& picture, const Extent& plate,
                 const std::array<double, 2>& tip) {
  const double aspect = picture.width() / picture.height();
  if (look.camera == Camera::free)
    return {look.view.x, look.view.y, look.view.height * aspect, look.view.height};
  if (look.camera == Camera::tip) return {tip[0], tip[1], look.close_up_m * aspect, look.close_up_m};
  const double height =
      std::max(above(look) * seen_height(look, plate), beside(look) * plate.length / aspect);
  return {0.5 * plate.length, plate.middle, height * aspect, height};
}

namespace {

/// The angles of a camera [rad].
std::array<double, 2> turn_and_tilt(const Look& look) {
  if (look.camera == Camera::side) return {0, side_tilt};
  if (look.camera == Camera::free) return {look.view.turn, look.view.tilt};
  return {0, 0};
}

double product(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace

Axes axes_of(const Look& look) {
  const auto [turn, tilt] = turn_and_tilt(look);
  const double ct = std::cos(turn), st = std::sin(turn), ci = std::cos(tilt), si = std::sin(tilt);
  return {{ct, 0, -st}, {si * st, ci, si * ct}, {ci * st, -si, ci * ct}};
}

bool seen_from_front(const Look& look) { return turn_and_tilt(look) == std::array<double, 2>{0, 0}; }

std::array<double, 2> to_pixels(const Axes& axes, const Window& shown, const Box& picture,
                                const std::array<double, 3>& point) {
  const std::array<double, 3> from_middle{point[0] - shown.x, point[1] - shown.y, point[2]};
  return {picture.x0 + picture.width() * (0.5 + product(from_middle, axes.right) / shown.width),
          picture.y0 + picture.height() * (0.5 + product(from_middle, axes.up) / shown.height)};
}

}  // namespace rift::viz
