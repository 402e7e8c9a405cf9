#pragma once

#include "studio/report/chart.hpp"

#include <string>

/// What all charts have in common: size, fonts, grid, colours.
namespace rift::studio {

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

}  // namespace rift::studio
