#include "studio/charts/chart_layout.hpp"

#include "studio/charts/chart_script.hpp"
#include "studio/charts/label.hpp"
#include "studio/charts/text_width.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift::studio {
namespace {

// [px] at a font of 14.
constexpr double font_px = 14, mark_font_px = 12, row_px = 22, sample_px = 36, gap_px = 8, pad_px = 18;
constexpr double left_px = 84, right_px = 26, title_px = 46, mark_row_px = 18, x_axis_px = 82;
constexpr int most_beside = 20;  // rows of a key to the right

/// The data's extent with the given ends in place of the data's.
template <class AnyChart>
Span span(const std::vector<const ChartSeries*>& series, bool along_x, const AnyChart& chart) {
  const AxisRange& range = along_x ? chart.x_range : chart.y_range;
  const bool log = along_x ? chart.log_x : chart.log_y;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const ChartSeries* s : series)
    for (const std::size_t k : drawable_points(*s)) {
      const double v = along_x ? s->x[k] : s->y[k];
      const double e = along_x || s->error.empty() || !std::isfinite(s->error[k]) ? 0.0 : s->error[k];
      if (log && v <= 0.0) continue;
      low = std::min(low, log && v - e <= 0.0 ? v : v - e), high = std::max(high, v + e);
    }
  Span out{range.min.value_or(low), range.max.value_or(high)};
  if (!(out.min <= out.max)) out = log ? Span{1.0, 10.0} : Span{0.0, 1.0};
  return out;
}

std::vector<const ChartSeries*> series_in(const Chart& chart) {
  std::vector<const ChartSeries*> all;
  for (const ChartSeries& s : chart.series) all.push_back(&s);
  return all;
}

std::vector<const ChartSeries*> series_in(const ChartGrid& grid) {
  std::vector<const ChartSeries*> all;
  for (const ChartPanel& panel : grid.panels)
    for (const ChartSeries& s : panel.series) all.push_back(&s);
  return all;
}

/// Where `v` lies between the ends, 0 to 1.
double fraction(double v, const Span& s, bool log) {
  if (log) return fraction(std::log(std::max(v, s.min)), {std::log(s.min), std::log(s.max)}, false);
  return s.max > s.min ? (v - s.min) / (s.max - s.min) : 0.5;
}

double widest_entry(const std::vector<KeyEntry>& entries) {
  double widest = 0.0;
  for (const KeyEntry& e : entries) widest = std::max(widest, text_px(e.series.label, font_px));
  return sample_px + gap_px + widest + pad_px;
}

/// As many columns as fit under a picture.
KeyLayout key_below(const std::vector<KeyEntry>& entries) {
  if (entries.empty()) return {};
  const double column = widest_entry(entries);
  const int count = static_cast<int>(entries.size());
  const int columns = std::clamp(static_cast<int>((chart_width - left_px) / column), 1, count);
  return {KeyPlace::below, columns, (count + columns - 1) / columns, column};
}

void add_entries(std::vector<KeyEntry>& entries, const std::vector<ChartSeries>& series) {
  int references = 0;
  for (const ChartSeries& s : series) {
    const int reference = s.colour < 0 ? references++ : 0;
    if (s.label.empty() || drawable_points(s).empty()) continue;
    const auto same = std::find_if(entries.begin(), entries.end(),
                                   [&](const KeyEntry& e) { return e.series.label == s.label; });
    if (same != entries.end()) {
      if (look_of(same->series, same->reference).colour != look_of(s, reference).colour)
        same->series.colour = -1, same->series.shade = std::numeric_limits<double>::quiet_NaN();
      continue;
    }
    KeyEntry& entry = entries.emplace_back(KeyEntry{s, reference});
    entry.series.x = entry.series.y = entry.series.error = {};
    entry.series.text = {};
  }
}

int rows_of_marks(const Chart& chart) {
  int rows = 0;
  for (const MarkLabel& label : mark_labels(chart, x_span(chart))) rows = std::max(rows, label.row + 1);
  return rows;
}

double above_plot(const Chart& chart) { return title_px + mark_row_px * rows_of_marks(chart); }

/// The picture's width without a key to the right.
double right_end(const Chart& chart) {
  const KeyLayout key = key_layout(chart);
  return chart_width - (key.place == KeyPlace::right ? key.width_px() + gap_px : right_px);
}

double below_plot(const Chart& chart) {
  const KeyLayout key = key_layout(chart);
  return x_axis_px + (key.place == KeyPlace::below ? key.height_px() : 0.0);
}

}  // namespace

bool has_error(const ChartSeries& series) {
  return std::any_of(series.error.begin(), series.error.end(), [](double e) { return std::isfinite(e); });
}

bool has_text(const ChartSeries& series) { return !series.text.empty(); }

Span x_span(const Chart& chart) { return span(series_in(chart), true, chart); }
Span y_span(const Chart& chart) { return span(series_in(chart), false, chart); }
Span x_span(const ChartGrid& grid) { return span(series_in(grid), true, grid); }
Span y_span(const ChartGrid& grid) { return span(series_in(grid), false, grid); }

Span axis_ends(const AxisRange& range, const Span& span, bool log) {
  const double margin = 0.04 * (span.max > span.min ? span.max - span.min : 1.0);
  return {range.min.value_or(log ? span.min / 1.25 : span.min - margin),
          range.max.value_or(log ? span.max * 1.25 : span.max + margin)};
}

AxisRange range_below_levels(const Chart& chart) {
  const Span data = y_span(chart);
  AxisRange range = chart.y_range;
  for (const ChartSeries& s : chart.series) {
    const std::vector<std::size_t> points = drawable_points(s);
    if (points.size() < 2) continue;
    const double y = s.y[points.front()];
    const bool is_level =
        y != 0.0 && std::all_of(points.begin(), points.end(), [&](std::size_t k) { return s.y[k] == y; });
    if (is_level && y == data.min) range.min = axis_ends(chart.y_range, data, chart.log_y).min;
  }
  return range;
}

std::vector<KeyEntry> key_entries(const std::vector<ChartSeries>& series) {
  std::vector<KeyEntry> entries;
  add_entries(entries, series);
  return entries;
}

std::vector<KeyEntry> key_entries(const ChartGrid& grid) {
  std::vector<KeyEntry> entries;
  for (const ChartPanel& panel : grid.panels) add_entries(entries, panel.series);
  return entries;
}

double KeyLayout::height_px() const { return rows * row_px + gap_px; }

KeyLayout key_layout(const Chart& chart) {
  const std::vector<KeyEntry> entries = key_entries(chart.series);
  const KeyLayout below = key_below(entries);
  const int count = static_cast<int>(entries.size());
  const bool fits = left_px + least_plot_width + below.column_px + gap_px <= chart_width;
  if (count == 0 || !fits || count > most_beside) return below;
  return {KeyPlace::right, 1, count, below.column_px};
}

KeyLayout key_layout(const ChartGrid& grid) { return key_below(key_entries(grid)); }

int picture_height(const Chart& chart) {
  const KeyLayout key = key_layout(chart);
  const double beside = key.place == KeyPlace::right ? key.height_px() : 0.0;
  const double plot = std::max(least_plot_height, beside);
  return std::max(chart_height, static_cast<int>(std::ceil(above_plot(chart) + plot + below_plot(chart))));
}

PlotArea plot_area(const Chart& chart) {
  return {left_px, right_end(chart), below_plot(chart), picture_height(chart) - above_plot(chart)};
}

GridLayout grid_layout(const ChartGrid& grid) {
  constexpr double between_px = 18, line_px = 16, above_title_px = 12;
  const int count = static_cast<int>(grid.panels.size());
  GridLayout out;
  out.columns = count <= 1 ? 1 : count == 2 || count == 4 ? 2 : 3;
  const int rows = (count + out.columns - 1) / out.columns;
  const double width = (chart_width - left_px - right_px - between_px * (out.columns - 1)) / out.columns;
  const double height = out.columns == 3 ? 190.0 : 260.0;
  std::size_t lines = 1;
  for (const ChartPanel& panel : grid.panels) {
    out.titles.push_back(wrapped_label(panel.title, width, panel_title_px));
    lines = std::max(lines, out.titles.back().size());
  }
  const double pitch = height + above_title_px + line_px * static_cast<double>(lines);
  const double bottom = x_axis_px + key_layout(grid).height_px();
  out.height = static_cast<int>(std::ceil(bottom + rows * pitch + title_px));
  for (int k = 0; k < count; ++k) {
    const double left = left_px + (k % out.columns) * (width + between_px);
    const double low = bottom + (rows - 1 - k / out.columns) * pitch;
    out.panels.push_back({left, left + width, low, low + height});
  }
  return out;
}

std::string key_lines(const std::vector<KeyEntry>& entries, const KeyLayout& layout, double left, double top,
                      int height) {
  std::string out = "set key off\n";
  const auto at = [&](double x, double y) {
    return fmt::format("screen {:.4f}, screen {:.4f}", x / chart_width, y / height);
  };
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const int place = static_cast<int>(k);
    const double x = left + place / layout.rows * layout.column_px;
    const double y = top - (place % layout.rows + 0.5) * row_px;
    out += key_sample(entries[k], at(x, y), at(x + sample_px, y), at(x + 0.5 * sample_px, y),
                      at(x, y - 0.25 * row_px), at(x + sample_px, y + 0.25 * row_px));
    out += fmt::format("set label {} at {} left tc rgb '#222222'\n", label_string(entries[k].series.label),
                       at(x + sample_px + gap_px, y));
  }
  return out;
}

std::vector<MarkLabel> mark_labels(const Chart& chart, const Span& x) {
  struct Placed {
    double left, right;
    int row;
  };
  const double width = right_end(chart) - left_px;
  std::vector<Placed> placed;
  std::vector<MarkLabel> labels;
  for (const ChartMark& m : chart.marks) {
    const double middle = 0.5 * (fraction(m.from, x, chart.log_x) + fraction(m.to, x, chart.log_x)) * width;
    const double half = 0.5 * text_px(m.label, mark_font_px);
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
