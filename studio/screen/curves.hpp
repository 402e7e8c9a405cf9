#pragma once

#include "studio/screen/canvas.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rift::studio {

/// Where a curve carries its mark, by which it is known without colours.
enum class Marks : std::uint8_t { none, last, each };

/// A curve of a plot; nothing is drawn where y is no number.
struct Curve {
  std::vector<std::array<double, 2>> points;  // x ascending
  Style style = {};
  std::string label = {};  // in the legend; empty: not there
  char32_t mark = U' ';
  Marks marks = Marks::none;
  bool line = true;  // else the marks alone
};

/// The ends of both axes, and their titles; logarithmic ones are given by powers of ten.
struct Axes {
  std::array<double, 2> x{0, 1}, y{0, 1};
  std::string x_title, y_title;
  bool logarithmic = false;  // points and ends are log10 of what the numbers at the axes say
};

/// Curves in braille dots, two by four a cell (stars in ASCII), with the ends of both axes as numbers and
/// behind the title the labels, as short as it takes. The curve that comes later gives a cell its colour.
void draw_curves(Canvas& canvas, const Area& area, const Axes& axes, std::span<const Curve> curves,
                 Glyphs glyphs);

}  // namespace rift::studio
