#pragma once

#include "engine/base/text.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rift::studio {

// What a terminal shows, as plain cells: drawn without any terminal, and tested cell by cell.

/// What a colour means; a scheme of the terminal says which one it is.
enum class Ink : std::uint8_t {
  plain,
  dim,
  title,
  good,
  bad,
  elastic,
  kinetic,
  fracture,
  damping,
  reference,
  shades
};

/// Steps of a diverging scale of colours.
inline constexpr int shade_steps = 15;
inline constexpr std::int8_t no_shade = -1;

struct Style {
  Ink ink = Ink::plain;
  bool bold = false;
  bool reverse = false;
  std::int8_t upper = no_shade, lower = no_shade;  // of a half block, in steps; ink shades only
  bool operator==(const Style&) const = default;
};

struct Cell {
  char32_t glyph = U' ';
  Style style;
  bool operator==(const Cell&) const = default;
};

/// A box of cells; the upper left corner is (0, 0).
struct Area {
  int x = 0, y = 0, width = 0, height = 0;
  [[nodiscard]] bool empty() const { return width <= 0 || height <= 0; }
};

/// Whether a terminal can show more than ASCII.
enum class Glyphs : std::uint8_t { unicode, ascii };

/// A screen of cells. What would lie outside is not drawn.
class Canvas {
 public:
  Canvas(int width, int height)
      : width_(width), height_(height), cell_(static_cast<std::size_t>(width) * height) {}

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] const Cell& at(int x, int y) const { return cell_[static_cast<std::size_t>(y) * width_ + x]; }
  void put(int x, int y, char32_t glyph, const Style& style = {});
  /// One line from (x, y), cut at `width` cells. @param text  UTF-8, a cell a letter. @return the cells it
  /// took
  int text(int x, int y, std::string_view text, const Style& style = {}, int width = 1 << 20);
  /// A row as UTF-8, without the blanks at its end.
  [[nodiscard]] std::string row(int y) const;

 private:
  int width_, height_;
  std::vector<Cell> cell_;
};

using base::letters_of;

/// The least size on which the screens make sense.
inline constexpr int least_width = 60, least_height = 16;

/// Blanks all cells of an area.
void clear(Canvas& canvas, const Area& area, const Style& style = {});

/// A frame in the middle of the screen for so many cells inside, as far as there is room, with a title in its
/// upper edge. @return the inside
Area draw_box(Canvas& canvas, int width, int height, std::string_view title, Glyphs glyphs);

/// The text broken at blanks into lines of the area. @return the lines it took
int draw_paragraph(Canvas& canvas, const Area& area, std::string_view text, const Style& style = {});

/// The text with its Greek letters spelt out where the terminal has none: "damping alpha".
std::string letters_for(Glyphs glyphs, std::string_view text);

/// On a screen that is too small: says how large it should be. @return whether it is
bool draw_too_small(Canvas& canvas);

}  // namespace rift::studio
