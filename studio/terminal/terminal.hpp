#pragma once

#include "studio/screen/canvas.hpp"
#include "studio/screen/press.hpp"

#include <map>
#include <string>
#include <utility>

namespace rift::studio {

/// The user's terminal, taken over for the life of the object by ncurses and given back as it was: also on
/// Ctrl-Z, and when the program crashes.
class Terminal {
 public:
  /// Whether both ends are a terminal that can be drawn on.
  [[nodiscard]] static bool there();

  /// @param color  false shows everything in one colour
  explicit Terminal(bool color);
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  [[nodiscard]] int width() const;
  [[nodiscard]] int height() const;
  [[nodiscard]] Glyphs glyphs() const { return glyphs_; }
  void show(const Canvas& canvas);
  /// What is pressed within so many milliseconds; a change of size is nothing.
  [[nodiscard]] Press press(int milliseconds);

  /// What to say should the program crash, such as where the run is; at most 400 bytes are kept.
  static void say_in_a_crash(const std::string& text);

 private:
  [[nodiscard]] int pair_of(int foreground, int background);
  void set_style(const Style& style);

  bool color_;
  Glyphs glyphs_;
  Canvas shown_{0, 0};
  std::map<std::pair<int, int>, int> pairs_;  // of foreground and background
};

}  // namespace rift::studio
