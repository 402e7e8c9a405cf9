#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// How a terminal can be given pictures, and which way is chosen.
namespace rift::studio {

enum class Graphics : std::uint8_t {
  cells,    // no pictures: the plate in cells
  symbols,  // a letter of two colours for each cell
  sixel,
  kitty,
  iterm,
};

/// Of symbols.
enum class Colours : std::uint8_t { two, eight, sixteen, many, all };

/// What a terminal has answered, or what is known without asking.
struct Capabilities {
  bool answers = false;  // it has answered anything at all
  bool sixel = false, kitty = false, iterm = false;
  int cell_width = 0, cell_height = 0;  // in pixels; 0 where not known
  int most_width = 0, most_height = 0;  // of a picture; 0 where not limited
};

/// Whether a letter of a terminal can have this size. [px]
[[nodiscard]] constexpr bool is_cell(int width, int height) {
  return width > 0 && width <= 256 && height > 0 && height <= 256;
}

/// What the environment says.
struct TerminalKind {
  std::string term;          // $TERM
  bool multiplexer = false;  // tmux or screen
  bool iterm = false;        // by its own variables
  bool unicode = true;
  Colours colours = Colours::many;
};

/// @param variable  returns the value of a variable, empty where it is not set;  @param colours  of terminfo
[[nodiscard]] TerminalKind kind_of_terminal(std::string_view (*variable)(const char*), int colours,
                                            bool unicode, bool wants_color);

/// "kitty", "sixel", ... or nothing for another word. "auto" is no way of its own.
[[nodiscard]] std::optional<Graphics> graphics_named(std::string_view word);
[[nodiscard]] std::string_view name_of(Graphics graphics);

/// The way that is taken: the one asked for, or else the best that the terminal has answered for; symbols
/// where it has answered for none.
[[nodiscard]] Graphics chosen_graphics(std::optional<Graphics> asked, const Capabilities& capabilities);

/// The question to a terminal of this kind; its last part is one that every terminal knows, so that its
/// answer ends the waiting.
[[nodiscard]] std::string question_for(const TerminalKind& kind);

}  // namespace rift::studio
