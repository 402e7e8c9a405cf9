#include "studio/charts/key_place.hpp"

#include "studio/charts/chart_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift::studio {
namespace {

// Estimates for a font of 14 px; the frame is what titles and ticks leave of the picture.
constexpr double letter_px = 8.0, mark_letter_px = 7.0, row_px = 26.0, sample_px = 70.0;
constexpr double left_px = 80.0, right_px = 30.0, frame_height_px = chart_height - 120.0;
constexpr std::size_t longest_beside = 30;  // letters of a label that still leave the plot its width

/// The data's extent with the given ends in place of the data's.
Span span(const Chart& chart, bool along_x, const AxisRange& range, bool log) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const ChartSeries& s : chart.series)
    for (const std::size_t k : drawable_points(s)) {
      const double v = along_x ? s.x[k] : s.y[k];
      const double e = along_x || s.error.empty() || !std::isfinite(s.error[k]) ? 0.0 : s.error[k];
      if (log && v <= 0.0) continue;
      low = std::min(low, log && v - e <= 0.0 ? v : v - e), high = std::max(high, v + e);
    }
  Span out{range.min.value_or(low), range.max.value_or(high)};
  if (!(out.min <= out.max)) out = log ? Span{1.0, 10.0} : Span{0.0, 1.0};
  return out;
}

/// Where `v` lies between the ends, 0 to 1.
double fraction(double v, const Span& s, bool log) {
  if (log) return fraction(std::log(std::max(v, s.min)), {std::log(s.min), std::log(s.max)}, false);
  return s.max > s.min ? (v - s.min) / (s.max - s.min) : 0.5;
}

struct Box {
  double left, right, bottom, top;  // in parts of the frame
};

/// Whether the segment from a to b comes into the box.
bool crosses(const Box& box, double ax, double ay, double bx, double by) {
  constexpr int parts = 24;
  for (int k = 0; k <= parts; ++k) {
    const double t = static_cast<double>(k) / parts, x = ax + t * (bx - ax), y = ay + t * (by - ay);
    if (x >= box.left && x <= box.right && y >= box.bottom && y <= box.top) return true;
  }
  return false;
}

bool enters(const ChartSeries& s, const Box& box, const Chart& chart, const Span& x, const Span& y) {
  const bool joined = s.style != ChartSeries::Style::points;
  double last_x = 0, last_y = 0;
  bool first = true;
  for (const std::size_t k : drawable_points(s)) {
    const double e = s.error.empty() || !std::isfinite(s.error[k]) ? 0.0 : s.error[k];
    const double px = fraction(s.x[k], x, chart.log_x), py = fraction(s.y[k], y, chart.log_y);
    if (crosses(box, px, fraction(s.y[k] - e, y, chart.log_y), px, fraction(s.y[k] + e, y, chart.log_y)))
      return true;
    if (joined && !first && crosses(box, last_x, last_y, px, py)) return true;
    last_x = px, last_y = py, first = false;
  }
  return false;
}

struct KeySize {
  std::size_t rows = 0, longest = 0;  // letters
  double width_px() const { return letter_px * static_cast<double>(longest) + sample_px; }
};

KeySize key_size(const Chart& chart) {
  KeySize size;
  for (const ChartSeries& s : chart.series)
    if (!s.label.empty()) ++size.rows, size.longest = std::max(size.longest, letters(s.label));
  return size;
}

}  // namespace

bool has_error(const ChartSeries& series) {
  return std::any_of(series.error.begin(), series.error.end(), [](double e) { return std::isfinite(e); });
}

Span x_span(const Chart& chart) { return span(chart, true, chart.x_range, chart.log_x); }
Span y_span(const Chart& chart) { return span(chart, false, chart.y_range, chart.log_y); }

KeyPlace key_place(const Chart& chart, const Span& x, const Span& y) {
  const KeySize size = key_size(chart);
  if (size.rows == 0) return KeyPlace::none;
  const KeyPlace outside = size.longest > longest_beside ? KeyPlace::below : KeyPlace::right;
  if (chart.key_outside) return outside;
  // A tenth more where gnuplot rounds the axes up to a tick, which moves the data a little.
  const double more_x = chart.x_range.min && chart.x_range.max ? 0.02 : 0.1;
  const double more_y = chart.y_range.min && chart.y_range.max ? 0.02 : 0.1;
  const double w = more_x + size.width_px() / (chart_width - left_px - right_px);
  const double h = more_y + row_px * static_cast<double>(size.rows) / frame_height_px;
  const std::pair<KeyPlace, Box> corners[] = {{KeyPlace::top_right, {1 - w, 1, 1 - h, 1}},
                                              {KeyPlace::top_left, {0, w, 1 - h, 1}},
                                              {KeyPlace::bottom_right, {1 - w, 1, 0, h}},
                                              {KeyPlace::bottom_left, {0, w, 0, h}}};
  for (const auto& [place, box] : corners)
    if (std::none_of(chart.series.begin(), chart.series.end(),
                     [&, &b = box](const ChartSeries& s) { return enters(s, b, chart, x, y); }))
      return place;
  return outside;
}

int picture_height(const Chart& chart, KeyPlace place) {
  const double all = row_px * static_cast<double>(key_size(chart).rows);
  if (place == KeyPlace::right) return std::max(chart_height, static_cast<int>(170.0 + all));
  if (place == KeyPlace::below) return std::max(chart_height, static_cast<int>(400.0 + 0.5 * all));
  return chart_height;
}

std::string key_lines(const Chart& chart, KeyPlace place) {
  const std::string look = " Left reverse samplen 4 spacing 1.2 tc rgb '#222222'\n";
  switch (place) {
    case KeyPlace::none:
      return "set key off\n";
    case KeyPlace::top_right:
      return "set key inside top right" + look;
    case KeyPlace::top_left:
      return "set key inside top left" + look;
    case KeyPlace::bottom_right:
      return "set key inside bottom right" + look;
    case KeyPlace::bottom_left:
      return "set key inside bottom left" + look;
    case KeyPlace::right: {  // by hand: gnuplot would rather make two columns and no plot
      const double margin = 1.0 - (key_size(chart).width_px() + 10.0) / chart_width;
      return fmt::format(
          "set rmargin at screen {:.3f}\nset key at screen {:.3f}, graph 1 left top vertical maxcols 1{}",
          margin, margin + 0.015, look);
    }
    case KeyPlace::below:
      return "set key outside below center maxcols 2" + look;
  }
  return {};
}

std::vector<MarkLabel> mark_labels(const Chart& chart, KeyPlace place, const Span& x) {
  struct Placed {
    double left, right;
    int row;
  };
  const double key = place == KeyPlace::right ? key_size(chart).width_px() + 10.0 : right_px;
  const double width = chart_width - left_px - key;
  std::vector<Placed> placed;
  std::vector<MarkLabel> labels;
  for (const ChartMark& m : chart.marks) {
    const double middle = 0.5 * (fraction(m.from, x, chart.log_x) + fraction(m.to, x, chart.log_x)) * width;
    const double half = 0.5 * mark_letter_px * static_cast<double>(letters(m.label));
    MarkLabel label;
    if (middle + half > width) label.side = MarkLabel::Side::right;
    if (middle - half < 0.0) label.side = MarkLabel::Side::left;
    const double shift = label.side == MarkLabel::Side::right  ? width - middle - half
                         : label.side == MarkLabel::Side::left ? half - middle
                                                               : 0.0;
    Placed now{middle + shift - half - 6.0, middle + shift + half + 6.0, 0};
    const auto taken = [&](const Placed& p) {
      return p.row == now.row && p.left < now.right && now.left < p.right;
    };
    while (std::any_of(placed.begin(), placed.end(), taken)) ++now.row;
    placed.push_back(now);
    label.row = now.row;
    labels.push_back(label);
  }
  return labels;
}

}  // namespace rift::studio
