#pragma once

#include "studio/charts/chart.hpp"
#include "studio/charts/chart_layout.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rift::studio {

// What all charts have in common: size, fonts, grid, colours.

/// How a series is drawn: colour "#0072b2", gnuplot's dash type and point type, line width.
struct SeriesLook {
  std::string colour;
  int dash = 1, shape = 7;
  double width = 2;
};

/// The look of a colour index: Okabe and Ito's palette, safe for the colour-blind, without its yellow, which
/// white swallows. A negative one is a reference, whose dash and grey follow its number among the references.
/// No two of the first thirty indices look alike.
SeriesLook series_look(int colour, int reference);

/// The same of a series, which may have a sequential colour: from dark blue to light green (viridis without
/// its yellow), then with a solid line.
SeriesLook look_of(const ChartSeries& series, int reference);

/// The script's lines for an axis: label, range, ticks.
std::string axis_lines(char which, const std::string& label, const AxisRange& range, bool log,
                       const Span& span);

/// What `plot` draws, part by part: bands behind all else, error bars behind the points of their series.
/// Texts beside points are point_texts.hpp's.
std::vector<std::string> plot_parts(const std::vector<ChartSeries>& series);

/// "plot part, part, ..."
std::string plot_line(const std::vector<std::string>& parts);

/// The script's lines that draw a sample of a key: a line between two places, a symbol between them, or a
/// band from corner to corner. Places are gnuplot's: "screen 0.1, screen 0.2".
std::string key_sample(const KeyEntry& entry, const std::string& from, const std::string& to,
                       const std::string& middle, const std::string& low, const std::string& high);

/// The opening of a script: what it is, where it reads and writes, terminal, frame, grid.
std::string script_head(const std::string& title, const std::string& name, int height);

/// The line that turns to a png of twice the resolution.
std::string png_terminal(int height);

/// The end of a script: the plot, and the same as a png.
std::string script_end(const std::string& plot, int height);

/// Indices of the points which a chart shows: x and y finite.
std::vector<std::size_t> drawable_points(const ChartSeries& series);

/// What the rows of each series are called in the csv: its name or label without markup, made unique, never
/// empty.
std::vector<std::string> series_names(const std::vector<ChartSeries>& series);

/// The tidy csv: series,x,y,error, a row per drawable point, numbers that read back as they were; a column
/// text where points have one.
std::string chart_data(const Chart& chart);

/// The gnuplot script which draws NAME.csv.
std::string chart_script(const Chart& chart, const std::string& name);

/// The same with a column panel, which counts from 1.
std::string chart_data(const ChartGrid& grid);
std::string chart_script(const ChartGrid& grid, const std::string& name);

/// column,row,x,y,value,text: a row per cell whose value is finite; column and row count from 0.
std::string chart_data(const HeatMap& map);

/// The gnuplot script which draws NAME.csv.
std::string chart_script(const HeatMap& map, const std::string& name);

}  // namespace rift::studio
