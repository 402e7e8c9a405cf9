#pragma once

#include "studio/screen/canvas.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

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
  key_drag,     // the first button is down, and the mouse is at x, y now
  key_release,  // of the first button
};

/// What the user did: a key, or the mouse at a cell.
struct KeyEvent {
  int key = key_none;
  int x = 0, y = 0;
};

// THE table of the keys: it gives what a key does, the line at the foot and the help.

/// Which screen a binding is of.
enum class Where : std::uint8_t {
  anywhere,
  home,
  form,
  live,
  watch,
  study,
  compare,
  lesson,
  lesson_run,
  view
};

enum class Action : std::uint8_t {
  none,
  up,
  down,
  page_up,
  page_down,
  first,
  last,
  open,
  search,
  mark,
  compare,
  remove,
  resume,
  render,
  run,
  reset,
  add,
  details,
  save,
  lane,
  beside,
  velocity,
  pause,
  step,
  slower,
  faster,
  change,
  frame,
  film,
  export_tables,
  stop,
  next,
  previous,
  handout,
  jump,
  next_field,
  next_colours,
  next_range,
  magnify,
  next_beams,
  show_budget,
  next_camera,
  zoom_in,
  zoom_out,
  pan_left,
  pan_right,
  pan_up,
  pan_down,
  turn_left,
  turn_right,
  tilt_up,
  tilt_down,
  ask,
  show_command,
  picture,
  help,
  back,
};

struct Binding {
  Where where;
  Action action;
  int key, other;          // other: a second key that does the same, or key_none
  std::string_view label;  // as shown: "space", "enter"
  std::string_view name;   // in the foot: "pause"; empty: in the help only
  std::string_view help;   // one line
};

[[nodiscard]] std::span<const Binding> bindings();

/// What a key does on a screen.
[[nodiscard]] Action action_of(Where where, int key);

/// "enter open  / search ...": as many as fit into `width` cells, the help key always among them.
/// @param without  what cannot be done now
[[nodiscard]] std::string foot_of(Where where, int width, Action without = Action::none);

/// A box over the screen with its keys from a row on, as many as have room.
/// @return the row to go on from, 0 after the last one
int draw_help(Canvas& canvas, Where where, int from, Glyphs glyphs);

}  // namespace rift::studio
