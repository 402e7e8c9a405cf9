#pragma once

#include "studio/charts/chart.hpp"

#include <string>
#include <vector>

namespace rift::studio {

// Where the texts of a chart find room: they never cover data.

/// What an axis will show; positive on a logarithmic one, where there is anything positive.
struct Span {
  double min = 0, max = 1;
};

bool has_error(const ChartSeries& series);
Span x_span(const Chart& chart);
Span y_span(const Chart& chart);

/// Outside the axes: to the right, or below where labels are so long that they would squeeze the plot.
enum class KeyPlace { none, right, below };
KeyPlace key_place(const Chart& chart);

/// The height [px] at which a key to the right is one column, and one below two: gnuplot would squeeze the
/// plot for more.
int picture_height(const Chart& chart);

/// The script's lines for the key and for the margin that it needs.
std::string key_lines(const Chart& chart);

/// Where a mark's label stands above the frame: in a row (0 is next to the frame) where it covers no other,
/// centred over its mark, or at an end of the frame where it would leave the picture.
struct MarkLabel {
  enum class Side { centre, left, right };
  int row = 0;
  Side side = Side::centre;
};
std::vector<MarkLabel> mark_labels(const Chart& chart, const Span& x);

}  // namespace rift::studio
