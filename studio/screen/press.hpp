#pragma once

namespace rift::studio {

/// Keys that are no letters; a letter is its own code point.
enum Key : int {
  key_none = -1,
  key_tab = 9,
  key_enter = 10,
  key_escape = 27,
  key_up = 0x110000,  // past the last letter of Unicode
  key_down,
  key_left,
  key_right,
  key_page_up,
  key_page_down,
  key_home,
  key_end,
  key_backspace,
  key_delete,
  key_click,  // of the first button, at x, y
  key_wheel_up,
  key_wheel_down,
};

/// What the user did: a key, or the mouse at a cell.
struct Press {
  int key = key_none;
  int x = 0, y = 0;
};

}  // namespace rift::studio
