#pragma once

#include "studio/screen/canvas.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace rift::studio {

/// A curve of a plot; nothing is drawn where y is no number.
struct Curve {
  std::vector<std::array<double, 2>> points;  // x ascending
  Style style;
};

struct Axes {
  std::array<double, 2> x{0, 1}, y{0, 1};
  std::string x_title, y_title;
};

/// Curves in braille dots, two by four a cell (stars in ASCII), with the ends of both axes as numbers. The
/// curve that comes later gives a cell its colour.
void draw_curves(Canvas& canvas, const Area& area, const Axes& axes, std::span<const Curve> curves,
                 Glyphs glyphs);

}  // namespace rift::studio
