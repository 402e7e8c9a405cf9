#pragma once

#include "studio/graphics/protocol.hpp"
#include "studio/graphics/symbol_cells.hpp"
#include "studio/screen/screen_picture.hpp"

#include <string>
#include <vector>

namespace rift::studio {

/// A picture as the bytes that show it on a terminal, and those that take it away.
class PictureEncoder {
 public:
  /// @param cell_width, cell_height  in pixels
  PictureEncoder(Graphics graphics, const TerminalKind& kind, int cell_width, int cell_height);

  /// Whether this build can show pictures at all.
  [[nodiscard]] static bool there();

  /// The picture in its rectangle; cursor and colours are as before. Symbols: only cells that differ from what
  /// the last picture showed there, of one that moves in coarser colours.
  [[nodiscard]] std::string show(const ScreenPicture& picture);
  /// Blanks its rectangle.
  [[nodiscard]] std::string clear(const Area& area);
  /// What takes pictures away whatever was being written: part of what restores the terminal.
  [[nodiscard]] std::string restore() const;

 private:
  [[nodiscard]] std::string show_pixels(const ScreenPicture& picture);
  [[nodiscard]] std::string show_symbols(const ScreenPicture& picture);

  Graphics graphics_;
  TerminalKind kind_;
  int cell_width_, cell_height_;
  int image_ = 1;  // kitty's number of the image; the next has the other of two
  Area shown_;
  std::vector<std::vector<SymbolCell>> rows_;  // of symbols that are shown
};

/// Puts the cursor into a cell.
[[nodiscard]] std::string at_cell(int x, int y);

}  // namespace rift::studio
