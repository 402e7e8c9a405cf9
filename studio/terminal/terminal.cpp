#include "studio/terminal/terminal.hpp"

#define NCURSES_WIDECHAR 1
#include <langinfo.h>
#include <locale.h>
#include <ncurses.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>

namespace rift::studio {
namespace {

constexpr int own = -1;  // the terminal's own colour

/// Colours of the inks by their order, on terminals of 256 and of 8 colours; after Okabe and Ito (2008) where
/// there are 256.
constexpr std::array<int, 10> inks_256{own, 245, own, 35, 160, 32, 214, 166, 36, 250};
constexpr std::array<int, 10> inks_8{own,        own,          own,       COLOR_GREEN, COLOR_RED,
                                     COLOR_BLUE, COLOR_YELLOW, COLOR_RED, COLOR_CYAN,  COLOR_WHITE};

/// From blue over grey to red.
constexpr std::array<int, shade_steps> shades_256{19,  26,  32,  68,  74,  110, 152, 252,
                                                  224, 217, 210, 203, 167, 160, 124};

int shade_colour(int step) {
  if (step == no_shade) return own;
  if (COLORS >= 256) return shades_256[static_cast<std::size_t>(step)];
  constexpr std::array<int, 3> three{COLOR_BLUE, COLOR_WHITE, COLOR_RED};
  return three[static_cast<std::size_t>(step * 3 / shade_steps)];
}

bool is_utf8() { return std::strcmp(nl_langinfo(CODESET), "UTF-8") == 0; }

}  // namespace

bool Terminal::there() {
  const char* kind = std::getenv("TERM");
  return isatty(STDIN_FILENO) == 1 && isatty(STDOUT_FILENO) == 1 && kind != nullptr &&
         std::strcmp(kind, "dumb") != 0;
}

Terminal::Terminal(bool color) {
  setlocale(LC_CTYPE, "");
  glyphs_ = is_utf8() ? Glyphs::unicode : Glyphs::ascii;
  initscr();
  cbreak();
  noecho();
  keypad(stdscr, TRUE);
  set_escdelay(25);
  curs_set(0);
  color_ = color && has_colors();
  if (!color_) return;
  start_color();
  use_default_colors();
}

Terminal::~Terminal() { endwin(); }

int Terminal::width() const { return getmaxx(stdscr); }
int Terminal::height() const { return getmaxy(stdscr); }

int Terminal::pair_of(int foreground, int background) {
  if (foreground == own && background == own) return 0;
  const auto [it, is_new] = pairs_.try_emplace({foreground, background}, static_cast<int>(pairs_.size()) + 1);
  if (is_new && it->second < COLOR_PAIRS) init_extended_pair(it->second, foreground, background);
  return it->second < COLOR_PAIRS ? it->second : 0;
}

void Terminal::set_style(const Style& style) {
  attr_t attributes = A_NORMAL;
  if (style.bold) attributes |= A_BOLD;
  if (style.reverse) attributes |= A_REVERSE;
  if (style.ink == Ink::dim && (!color_ || COLORS < 256)) attributes |= A_DIM;
  int pair = 0;
  if (color_ && style.ink == Ink::shades) {
    const bool one_half = style.upper == no_shade;
    pair = pair_of(shade_colour(one_half ? style.lower : style.upper),
                   one_half ? own : shade_colour(style.lower));
  } else if (color_) {
    const auto ink = static_cast<std::size_t>(style.ink);
    pair = pair_of(COLORS >= 256 ? inks_256[ink] : inks_8[ink], own);
  }
  attr_set(attributes, 0, &pair);
}

void Terminal::show(const Canvas& canvas) {
  erase();
  for (int y = 0; y < std::min(canvas.height(), height()); ++y)
    for (int x = 0; x < std::min(canvas.width(), width()); ++x) {
      const Cell& cell = canvas.at(x, y);
      if (cell == Cell{}) continue;
      set_style(cell.style);
      const wchar_t glyph[2] = {static_cast<wchar_t>(cell.glyph), L'\0'};
      mvaddnwstr(y, x, glyph, 1);
    }
  refresh();
}

int Terminal::key(int milliseconds) {
  timeout(milliseconds);
  const int pressed = getch();
  return pressed == ERR || pressed == KEY_RESIZE ? -1 : pressed;
}

}  // namespace rift::studio
