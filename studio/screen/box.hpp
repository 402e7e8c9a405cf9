#pragma once

#include "studio/screen/canvas.hpp"

#include <string_view>

namespace rift::studio {

/// The least size on which the screens make sense.
inline constexpr int least_width = 60, least_height = 16;

/// Blanks all cells of an area.
void clear(Canvas& canvas, const Area& area, const Style& style = {});

/// A frame in the middle of the screen for so many cells inside, as far as there is room, with a title in its
/// upper edge. @return the inside
Area draw_box(Canvas& canvas, int width, int height, std::string_view title, Glyphs glyphs);

/// The text broken at blanks into lines of the area. @return the lines it took
int draw_paragraph(Canvas& canvas, const Area& area, std::string_view text, const Style& style = {});

/// On a screen that is too small: says how large it should be. @return whether it is
bool draw_too_small(Canvas& canvas);

}  // namespace rift::studio
