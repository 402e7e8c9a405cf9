#include "studio/screen/keymap.hpp"

#include "studio/screen/canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace rift::studio {
namespace {

using enum Action;
using W = Where;

constexpr std::array table{
    Binding{W::home, open, key_enter, key_right, "enter", "open",
            "Open the preset as a form, the run or the study"},
    Binding{W::home, run, 'r', key_none, "r", "run", "Run the preset as it is"},
    Binding{W::home, next, key_tab, key_none, "tab", "group", "The next group"},
    Binding{W::home, search, '/', key_none, "/", "search", "Show only entries that contain these letters"},
    Binding{W::home, picture, 'p', key_none, "p", "plate",
            "The plate: a preset's specimen, loaded, or a run's last moment"},
    Binding{W::home, mark, ' ', key_none, "space", "mark", "Mark a run for the comparison"},
    Binding{W::home, compare, 'c', key_none, "c", "compare", "Compare the marked runs"},
    Binding{W::home, resume, 'u', key_none, "u", "resume",
            "Resume a run or study that was stopped or killed"},
    Binding{W::home, film, 'm', key_none, "m", "film", "Make a film of the run"},
    Binding{W::home, remove, 'd', key_delete, "d", "delete", "Delete the run, after a question"},
    Binding{W::form, open, key_enter, key_right, "enter", "edit",
            "Change the value; a digit begins a new one"},
    Binding{W::form, run, 'r', key_none, "r", "run", "Run it"},
    Binding{W::form, save, 's', key_none, "s", "save", "Save as a preset of your own"},
    Binding{W::form, reset, 'd', key_delete, "d", "undo", "Undo the change of this value"},
    Binding{W::form, add, 'a', key_none, "a", "axis", "Add an axis: the study varies one parameter more"},
    Binding{W::form, remove, 'x', key_none, "x", "", "Remove the chosen axis of the study"},
    Binding{W::form, search, '/', key_none, "/", "search", "Show only entries that contain these letters"},
    Binding{W::form, details, 'i', key_none, "i", "",
            "All that follows from the values: step, cost, what is left out"},
    Binding{W::live, pause, ' ', key_none, "space", "pause", "Pause or continue"},
    Binding{W::live, step, '.', key_none, ".", "step", "A single step"},
    Binding{W::live, slower, '<', key_left, "<", "slower", "Slow motion"},
    Binding{W::live, faster, '>', key_right, ">", "faster", "Faster, up to full speed"},
    Binding{W::live, change, 'x', key_none, "x", "change",
            "Change technique, relaxation, r_l, alpha or velocity from now on"},
    Binding{W::live, lane, key_tab, key_none, "tab", "lane", "The next lane; 1 to 8 choose one"},
    Binding{W::live, beside, 'v', key_none, "v", "beside", "Show a second lane's plate beside the first"},
    Binding{W::live, velocity, 'w', key_none, "w", "velocity",
            "Switch between colours of velocity and of displacement"},
    Binding{W::live, picture, 'p', key_none, "p", "pixels", "Switch the plate between cells and picture"},
    Binding{W::live, frame, 'f', key_none, "f", "frame", "A picture of this moment"},
    Binding{W::live, film, 'm', key_none, "m", "film", "Begin a film at this moment; press again to end it"},
    Binding{W::live, export_tables, 'e', key_none, "e", "export", "Write the tables as CSV"},
    Binding{W::live, stop, 's', key_none, "s", "stop", "Stop the run here; its results so far are kept"},
    Binding{W::watch, lane, key_tab, key_none, "tab", "lane", "The next lane; 1 to 8 choose one"},
    Binding{W::watch, beside, 'v', key_none, "v", "beside", "Show a second lane's plate beside the first"},
    Binding{W::watch, velocity, 'w', key_none, "w", "velocity",
            "Switch between colours of velocity and of displacement"},
    Binding{W::watch, picture, 'p', key_none, "p", "pixels", "Switch the plate between cells and picture"},
    Binding{W::watch, frame, 'f', key_none, "f", "frame", "A picture of the last stored moment"},
    Binding{W::watch, film, 'm', key_none, "m", "film", "A film of the run"},
    Binding{W::watch, export_tables, 'e', key_none, "e", "export", "Write the tables as CSV"},
    Binding{W::study, resume, 'u', key_none, "u", "resume", "Resume a study that was stopped"},
    Binding{W::study, stop, 's', key_none, "s", "stop", "Stop the study; it can be continued"},
    Binding{W::compare, picture, 'p', key_none, "p", "plates", "Show the plates at one moment"},
    Binding{W::compare, step, '.', key_right, ".", "later", "The plates a fortieth of the run later"},
    Binding{W::compare, previous, ',', key_left, ",", "earlier", "The plates a fortieth of the run earlier"},
    Binding{W::compare, velocity, 'w', key_none, "w", "velocity",
            "Switch between colours of velocity and of displacement"},
    Binding{W::lesson, next, key_enter, key_right, "enter", "next page", "Continue; the run continues too"},
    Binding{W::lesson, previous, key_backspace, key_left, "backspace", "page before", "The page before"},
    Binding{W::lesson, handout, 'h', key_none, "h", "handout",
            "Write the lesson as a page of HTML, when the run has finished"},
    Binding{W::lesson_run, next, key_enter, key_none, "enter", "next page",
            "Continue; the run continues too"},
    Binding{W::lesson_run, previous, key_backspace, key_none, "backspace", "page before", "The page before"},
    Binding{W::lesson_run, pause, ' ', key_none, "space", "pause", "Pause or continue"},
    Binding{W::lesson_run, picture, 'p', key_none, "p", "pixels",
            "Switch the plates between cells and picture"},
    Binding{W::lesson_run, slower, '<', key_left, "<", "slower", "Slow motion"},
    Binding{W::lesson_run, faster, '>', key_right, ">", "faster", "Faster"},
    Binding{W::lesson_run, lane, key_tab, key_none, "tab", "lane", "The next lane; 1 to 8 choose one"},
    Binding{W::lesson_run, velocity, 'w', key_none, "w", "velocity",
            "Switch between colours of velocity and of displacement"},
    Binding{W::lesson_run, handout, 'h', key_none, "h", "handout",
            "Write the lesson as a page of HTML, when the run has finished"},
    Binding{W::view, pause, ' ', key_none, "space", "play", "Play or pause"},
    Binding{W::view, step, '.', key_right, ".", "next", "The next stored moment"},
    Binding{W::view, previous, ',', key_left, ",", "", "The moment before"},
    Binding{W::view, next_field, 'f', key_none, "f", "field", "The next field"},
    Binding{W::view, next_camera, 'v', key_none, "v", "camera",
            "The next camera: whole plate, tip, side, free"},
    Binding{W::view, ask, 'i', key_none, "i", "ask",
            "Crosshair: arrows move it, enter asks, twice measures; or click"},
    Binding{W::view, next_range, 'r', key_none, "r", "range",
            "Range of the colours: of all moments, of each moment, typed"},
    Binding{W::view, next_beams, 'b', key_none, "b", "beams", "Beams: none, on the crack's path, all"},
    Binding{W::view, show_budget, 'e', key_none, "e", "energies", "Show or hide the energy budget"},
    Binding{W::view, frame, 'p', key_none, "p", "picture", "Save this picture as PNG"},
    Binding{W::view, film, 'm', key_none, "m", "film", "A film of this view"},
    Binding{W::view, show_command, 'c', key_none, "c", "command",
            "The rift render command of this picture; printed on leaving too"},
    Binding{W::view, jump, 't', key_none, "t", "jump", "Jump to a typed time (12 us) or tip (30 mm)"},
    Binding{W::view, slower, '<', key_none, "<", "", "Play slower"},
    Binding{W::view, faster, '>', key_none, ">", "", "Play faster"},
    Binding{W::view, next_colours, 'o', key_none, "o", "", "The next colour map"},
    Binding{W::view, magnify, 'x', key_none, "x", "", "Magnification of the displacements, typed"},
    Binding{W::view, zoom_in, '+', '=', "+", "", "Nearer; the wheel zooms to the pointer"},
    Binding{W::view, zoom_out, '-', key_none, "-", "", "Farther"},
    Binding{W::view, pan_left, 'a', key_none, "a", "", "To the left; dragging moves the plate, too"},
    Binding{W::view, pan_right, 'd', key_none, "d", "", "To the right"},
    Binding{W::view, pan_up, 'w', key_none, "w", "", "Up"},
    Binding{W::view, pan_down, 's', key_none, "s", "", "Down"},
    Binding{W::view, turn_left, 'A', key_none, "A, D", "", "Turn about the vertical axis"},
    Binding{W::view, turn_right, 'D', key_none, "D", "", "Turn back"},
    Binding{W::view, tilt_up, 'W', key_none, "W, S", "", "Tilt about the horizontal axis"},
    Binding{W::view, tilt_down, 'S', key_none, "S", "", "Tilt back"},
    Binding{W::view, reset, '0', key_none, "0", "", "The whole plate again"},
    Binding{W::anywhere, up, key_up, 'k', "up, k", "", "Up"},
    Binding{W::anywhere, down, key_down, 'j', "down, j", "", "Down"},
    Binding{W::anywhere, page_up, key_page_up, key_none, "page up", "", "A page up"},
    Binding{W::anywhere, page_down, key_page_down, key_none, "page down", "", "A page down"},
    Binding{W::anywhere, first, key_home, 'g', "home, g", "", "To the top"},
    Binding{W::anywhere, last, key_end, 'G', "end, G", "", "To the end"},
    Binding{W::anywhere, help, '?', key_none, "?", "keys", "These keys"},
    Binding{W::anywhere, back, 'q', key_escape, "q", "leave",
            "Leave this screen; a run is stopped, changes are asked for first"},
};

bool is_of(const Binding& binding, Where where) {
  return binding.where == where || binding.where == Where::anywhere;
}

}  // namespace

std::span<const Binding> bindings() { return table; }

Action action_of(Where where, int key) {
  if (key == key_none) return none;
  for (const Binding& b : table)
    if (is_of(b, where) && (key == b.key || key == b.other)) return b.action;
  return none;
}

std::string foot_of(Where where, int width, Action without) {
  std::string always, rest;
  for (const Binding& b : table)
    if (b.where == Where::anywhere && !b.name.empty()) always += fmt::format("  {} {}", b.label, b.name);
  for (const Binding& b : table) {
    if (b.where != where || b.name.empty() || b.action == without) continue;
    const std::string more = fmt::format("{}{} {}", rest.empty() ? "" : "  ", b.label, b.name);
    if (static_cast<int>(rest.size() + more.size() + always.size()) > width) break;
    rest += more;
  }
  const std::string foot = rest + always;
  return rest.empty() ? foot.substr(2) : foot;
}

int draw_help(Canvas& canvas, Where where, int from, Glyphs glyphs) {
  std::vector<const Binding*> rows;
  for (const Binding& b : table)
    if (is_of(b, where)) rows.push_back(&b);
  constexpr int keys = 12;
  int width = 0;
  for (const Binding* b : rows) width = std::max(width, keys + static_cast<int>(b->help.size()));
  const int count = static_cast<int>(rows.size());
  const bool has_curves = where == W::live || where == W::watch || where == W::lesson_run;
  const char* title = has_curves ? "keys; a curve ends in its first letter (e elastic) or its lane's digit"
                                 : "keys of this screen";
  const Area inside = draw_box(canvas, width + 2, count - from, title, glyphs);
  const bool all = count - from <= inside.height;
  const int shown = all ? count - from : std::max(1, inside.height - 1);
  for (int k = 0; k < shown; ++k) {
    const Binding& b = *rows[static_cast<std::size_t>(from + k)];
    canvas.text(inside.x + 1, inside.y + k, b.label, {Ink::title, true}, keys);
    canvas.text(inside.x + 1 + keys, inside.y + k, b.help, {}, inside.width - keys - 1);
  }
  if (all) return 0;
  canvas.text(inside.x + 1, inside.y + shown,
              fmt::format("{} more keys: space shows them, any other key closes", count - from - shown),
              {Ink::dim}, inside.width - 1);
  return from + shown;
}

}  // namespace rift::studio
