#include "studio/charts/chart_layout.hpp"

#include "studio/charts/chart_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift::studio {
namespace {

// Estimates for a font of 14 px; the frame is what titles and ticks leave of the picture.
constexpr double letter_px = 8.0, mark_letter_px = 7.0, row_px = 26.0, sample_px = 78.0;
constexpr double left_px = 80.0, right_px = 30.0;
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

KeyPlace key_place(const Chart& chart) {
  const KeySize size = key_size(chart);
  if (size.rows == 0) return KeyPlace::none;
  return size.longest > longest_beside ? KeyPlace::below : KeyPlace::right;
}

int picture_height(const Chart& chart) {
  const double all = row_px * static_cast<double>(key_size(chart).rows);
  const KeyPlace place = key_place(chart);
  if (place == KeyPlace::right) return std::max(chart_height, static_cast<int>(170.0 + all));
  if (place == KeyPlace::below) return std::max(chart_height, static_cast<int>(400.0 + 0.5 * all));
  return chart_height;
}

std::string key_lines(const Chart& chart) {
  const std::string look = " Left reverse samplen 4 spacing 1.2 tc rgb '#222222'\n";
  const KeyPlace place = key_place(chart);
  if (place == KeyPlace::none) return "set key off\n";
  if (place == KeyPlace::below) return "set key outside below center maxcols 2" + look;
  // By hand: gnuplot would rather make two columns and no plot.
  const double margin = 1.0 - (key_size(chart).width_px() + 10.0) / chart_width;
  return fmt::format(
      "set rmargin at screen {:.3f}\nset key at screen {:.3f}, graph 1 left top vertical maxcols 1{}", margin,
      margin + 0.015, look);
}

std::vector<MarkLabel> mark_labels(const Chart& chart, const Span& x) {
  struct Placed {
    double left, right;
    int row;
  };
  const double key = key_place(chart) == KeyPlace::right ? key_size(chart).width_px() + 10.0 : right_px;
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
