#pragma once

#include "studio/screen/canvas.hpp"

#include <string_view>

namespace rift::studio {

/// Blanks all cells of an area.
void clear(Canvas& canvas, const Area& area, const Style& style = {});

/// A frame in the middle of the screen for so many cells inside, as far as there is room, with a title in its
/// upper edge. @return the inside
Area draw_box(Canvas& canvas, int width, int height, std::string_view title, Glyphs glyphs);

/// The text broken at blanks into lines of the area. @return the lines it took
int draw_paragraph(Canvas& canvas, const Area& area, std::string_view text, const Style& style = {});

/// What is said in the middle of a screen that is too small.
void draw_too_small(Canvas& canvas, int width, int height);

}  // namespace rift::studio
