#pragma once

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rift::studio {

// Charts of reports: plain data, drawn by gnuplot as a child process. The data (csv) and the script (gp)
// stay beside the picture, so that a reader can restyle it.   [docs/adr/0004-charts-by-gnuplot.md]

/// One curve or cloud of points. Its label is enhanced text (chart_script.hpp) and empty to stay out of the
/// key; where series of several colours share a label, its sample is grey.
struct ChartSeries {
  enum class Style { line, points, line_points, dashed, band };
  std::string label = {};
  std::vector<double> x = {}, y = {};  // same length; a point with a NaN is left out
  /// Half a bar's length, or half a band's width; empty for none, NaN where there is none.
  std::vector<double> error = {};
  Style style = Style::line;
  /// Into the palette, which gives shape and dash too; -1: a reference, black or grey and dashed.
  int colour = 0;
  /// Place on the sequential colours, 0 to 1, in place of the palette's: for a series of an ordered axis.
  double shade = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::string> text = {};  // beside the points, as it is; empty, or as many as points
  /// What its rows are called in the csv, enhanced text; empty for its label.
  std::string name = {};

  void add(double at, double value, double half_bar = std::numeric_limits<double>::quiet_NaN()) {
    error.resize(x.size(), std::numeric_limits<double>::quiet_NaN());
    x.push_back(at), y.push_back(value), error.push_back(half_bar);
  }
};

/// A point of a series, with half its error bar where it has one.
struct ChartPoint {
  double x, y, error = std::numeric_limits<double>::quiet_NaN();
};

/// A series that has one point for each row. @param point  ChartPoint of a row
template <class Rows, class PointOf>
ChartSeries series_of(std::string label, ChartSeries::Style style, int colour, const Rows& rows,
                      const PointOf& point) {
  ChartSeries series{.label = std::move(label), .style = style, .colour = colour};
  for (const auto& row : rows) {
    const ChartPoint p = point(row);
    series.add(p.x, p.y, p.error);
  }
  return series;
}

/// Gives the series sequential colours in their order, as the values of an ordered axis want them.
void shade_in_order(std::vector<ChartSeries>& series);

/// A reference that does not depend on x, drawn between two ends.
inline ChartSeries level(std::string label, double y, double from, double to) {
  return {std::move(label), {from, to}, {y, y}, {}, ChartSeries::Style::dashed, -1};
}

/// An end that is not given follows the data.
struct AxisRange {
  std::optional<double> min = {}, max = {};
};

/// A moment or a stretch of the x axis, such as the echo of a boundary: a dotted line where the ends are
/// equal, else a shaded span. The label stands above the frame.
struct ChartMark {
  double from = 0, to = 0;
  std::string label;
};

/// All texts are enhanced text; axes carry their units: "tip position [mm]".
struct Chart {
  std::string title = {}, x_label = {}, y_label = {};
  AxisRange x_range = {}, y_range = {};
  bool log_x = false, log_y = false;
  std::vector<ChartSeries> series = {};
  std::vector<ChartMark> marks = {};
};

/// A panel of a grid; series of one label look alike in all panels.
struct ChartPanel {
  std::string title = {};
  std::vector<ChartSeries> series = {};
};

/// Small multiples: panels of equal axes, row by row, under one title and over one key.
struct ChartGrid {
  std::string title = {}, x_label = {}, y_label = {};
  AxisRange x_range = {}, y_range = {};
  bool log_x = false, log_y = false;
  std::vector<ChartPanel> panels = {};
};

/// Values on a grid of equal cells, whatever the distances of x and of y; cells of NaN stay white. Meant for
/// some thousand cells at most: each is a rectangle of the svg.
struct HeatMap {
  std::string title, x_label, y_label, value_label;
  std::vector<double> x, y;
  std::vector<double> value;      // y.size() × x.size(), row by row, the first row at the bottom
  std::vector<std::string> text;  // in the cells, as they are; empty, or as many as values
  AxisRange value_range;
};

/// The files of a chart, and its svg as it can stand within an HTML page.
struct DrawnChart {
  std::filesystem::path svg, png, data, script;
  std::string svg_text;  // no XML prolog; every id begins with the chart's name
};

/// Writes NAME.csv (series,x,y,error, and text where points have one), NAME.gp, NAME.svg and NAME.png into
/// `folder`, which is made if need be; former files of these names are replaced, each in one step. In that
/// folder `gnuplot NAME.gp` draws the pictures anew.
/// @param name  letters, digits, '_' and '-', the first a letter; within one HTML page no two charts of one
/// name Throws results::WorldError where the chart has no points, a file cannot be written, gnuplot is not
/// installed or refuses the script. Data and script then stay, pictures are whole or not there. Some 0.2 s,
/// most of it gnuplot's.
DrawnChart draw_chart(const Chart& chart, const std::filesystem::path& folder, const std::string& name);

/// The same of small multiples; the csv has a column `panel` more.
DrawnChart draw_chart(const ChartGrid& grid, const std::filesystem::path& folder, const std::string& name);

/// The same of a heat map; the csv is column,row,x,y,value,text.
DrawnChart draw_chart(const HeatMap& map, const std::filesystem::path& folder, const std::string& name);

/// What a report draws, before it is drawn.
struct NamedChart {
  std::string name, caption;
  std::variant<Chart, ChartGrid, HeatMap> chart;
};

/// Those in which there is something to be drawn: draw_chart() refuses the others.
std::vector<NamedChart> those_with_points(std::vector<NamedChart> charts);

DrawnChart draw_chart(const NamedChart& named, const std::filesystem::path& folder);

}  // namespace rift::studio
