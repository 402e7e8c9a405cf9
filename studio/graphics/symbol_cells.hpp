#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rift::studio {

/// A cell of a picture in letters, with its colours as parameters of SGR ("38;2;200;10;0"), empty for the
/// terminal's own.
struct SymbolCell {
  std::string letter = " ", foreground, background;
  bool reverse = false;
  bool operator==(const SymbolCell&) const = default;
};

/// The cells of a row of letters and SGR sequences. What is not seen is left out: the foreground of a blank;
/// a full block is a blank of its colour.
[[nodiscard]] std::vector<SymbolCell> cells_of(std::string_view row);

/// Colours of 24 bits in steps of 16: neighbours and the next picture often have the same ones then.
void make_coarse(SymbolCell& cell);

/// Codes that turn rows of cells into others, in as few bytes as may be: cells that stay are passed over,
/// colours are said where they change, and a half block may be the other half in exchanged colours.
class SymbolChanges {
 public:
  /// @param x, y  of the row's first cell on the screen;  @param before  what is there; none where nothing is
  /// known
  void add(int x, int y, const std::vector<SymbolCell>& before, const std::vector<SymbolCell>& after);
  /// All of them, with the terminal's own colours at the end; empty where nothing changes.
  [[nodiscard]] std::string codes() const;

 private:
  void set_colours(const SymbolCell& cell, bool first);
  [[nodiscard]] SymbolCell as_cheap(const SymbolCell& cell) const;

  std::string codes_;
  SymbolCell now_;  // the colours that are set
};

}  // namespace rift::studio
