#pragma once

#include "studio/charts/chart.hpp"

#include <string>
#include <vector>

namespace rift::studio {

// Where the texts of a chart find room: they never cover data, and the plot keeps its least width and height
// whatever the key holds.

constexpr int chart_width = 860, chart_height = 520;               // [px]; a long key makes a chart higher
constexpr double least_plot_width = 420, least_plot_height = 320;  // [px] of a chart that is no grid

/// What an axis will show; positive on a logarithmic one, where there is anything positive.
struct Span {
  double min = 0, max = 1;
};

bool has_error(const ChartSeries& series);
bool has_text(const ChartSeries& series);
Span x_span(const Chart& chart);
Span y_span(const Chart& chart);
Span x_span(const ChartGrid& grid);
Span y_span(const ChartGrid& grid);

/// Where an axis ends: a little beyond its data, unless an end is given.
Span axis_ends(const AxisRange& range, const Span& span, bool log);

/// The chart's range of y, with room below a level other than 0 that is the lowest of its data: gnuplot would
/// begin the axis on it and draw one upon the other.
AxisRange range_below_levels(const Chart& chart);

/// How a series looks [chart_script.hpp, look_of]; the n-th reference differs from the others.
struct KeyEntry {
  ChartSeries series;  // without its points
  int reference = 0;
};

/// The labels of a chart, each once, in the order of the series; those without a point are left out.
std::vector<KeyEntry> key_entries(const std::vector<ChartSeries>& series);
std::vector<KeyEntry> key_entries(const ChartGrid& grid);

/// Outside the axes: to the right, or below where labels are so long or so many that the plot would lose its
/// least size.
enum class KeyPlace { none, right, below };

/// Columns of equal width, filled from top to bottom.
struct KeyLayout {
  KeyPlace place = KeyPlace::none;
  int columns = 0, rows = 0;
  double column_px = 0;
  double width_px() const { return columns * column_px; }
  double height_px() const;
};
KeyLayout key_layout(const Chart& chart);
KeyLayout key_layout(const ChartGrid& grid);

/// A rectangle [px] from the picture's left and bottom.
struct PlotArea {
  double left = 0, right = 0, bottom = 0, top = 0;
  double width() const { return right - left; }
  double height() const { return top - bottom; }
};

/// Where the axes of a chart stand in a picture of this height; gnuplot moves the left end as its ticks want
/// it.
int picture_height(const Chart& chart);
PlotArea plot_area(const Chart& chart);

/// The panels of a grid, row by row, in a picture of this height, with room for their titles above them.
struct GridLayout {
  int columns = 1, height = chart_height;
  std::vector<PlotArea> panels;
  std::vector<std::vector<std::string>> titles;  // of each panel, in lines that fit it
};
GridLayout grid_layout(const ChartGrid& grid);

constexpr double panel_title_px = 12;  // font of the panels' titles

/// The script's lines that draw a key: samples and labels at fixed places, as gnuplot's own key measures
/// another font than the one that a viewer draws.
/// @param left, top  [px] of its first entry, from the picture's left and bottom
std::string key_lines(const std::vector<KeyEntry>& entries, const KeyLayout& layout, double left, double top,
                      int height);

/// Where a mark's label stands above the frame: in a row (0 is next to the frame) where it covers no other,
/// centred over its mark, or at an end of the frame where it would leave the picture.
struct MarkLabel {
  enum class Side { centre, left, right };
  int row = 0;
  Side side = Side::centre;
};
std::vector<MarkLabel> mark_labels(const Chart& chart, const Span& x);

}  // namespace rift::studio
