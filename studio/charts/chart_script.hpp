#pragma once

#include "studio/charts/chart.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rift::studio {

// What all charts have in common: size, fonts, grid, colours.

constexpr int chart_width = 860, chart_height = 520;  // [px]; a long key makes a chart higher

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

/// "set xrange [0:*]", or nothing where both ends follow the data.
std::string range_line(char axis, const AxisRange& range);

/// The opening of a script: what it is, where it reads and writes, terminal, frame, grid.
std::string script_head(const std::string& title, const std::string& name, int height);

/// Its end: the plot, and the same as a png of twice the resolution.
std::string script_end(const std::string& plot, int height);

// Text in charts. Titles, axes and legends are gnuplot's enhanced text: "G_{ID} / G_{I0}", "10^{-3}", "α,
// c_r".

/// Text that comes from data, as a label that shows it letter by letter: "run_01" -> "run\_01".
std::string escape_label(std::string_view text);

/// What a label reads like without its markup: "G_{ID} / c_r" -> "G_ID / c_r", "run\_01" -> "run_01".
std::string plain_text(std::string_view label);

/// The label as a string of a gnuplot script, in single quotes; line breaks become spaces.
std::string script_string(std::string_view label);

/// Letters a label shows, for an estimate of its width: markup and bytes within a letter not counted.
std::size_t letters(std::string_view label);

/// The text as a field of a csv that gnuplot reads, which base::csv_field() is not: gnuplot does not know
/// commas, doubled quotes or line breaks within a field, which become ';', "'" and spaces.
std::string gnuplot_field(std::string text);

/// Indices of the points which a chart shows: x and y finite.
std::vector<std::size_t> drawable_points(const ChartSeries& series);

/// What the rows of each series are called in the csv: its label without markup, made unique, never empty.
std::vector<std::string> series_names(const Chart& chart);

/// The tidy csv: series,x,y,error, a row per drawable point, numbers that read back as they were.
std::string chart_data(const Chart& chart);

/// The gnuplot script which draws NAME.csv.
std::string chart_script(const Chart& chart, const std::string& name);

/// column,row,x,y,value,text: a row per cell whose value is finite; column and row count from 0.
std::string chart_data(const HeatMap& map);

/// The gnuplot script which draws NAME.csv.
std::string chart_script(const HeatMap& map, const std::string& name);

}  // namespace rift::studio
