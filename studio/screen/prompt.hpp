#pragma once

#include "studio/screen/canvas.hpp"
#include "studio/screen/keymap.hpp"

#include <cstdint>
#include <string>

namespace rift::studio {

/// A line that is being typed.
class Prompt {
 public:
  enum class State : std::uint8_t { idle, typing, entered, cancelled };

  Prompt() = default;
  Prompt(std::string label, std::string text)
      : label_(std::move(label)), text_(std::move(text)), state_(State::typing) {}

  [[nodiscard]] bool typing() const { return state_ == State::typing; }
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] const std::string& label() const { return label_; }
  /// @return whether it was entered or given up by this key
  State press(const KeyEvent& event);
  /// "label: text_" in one line of the area, the end of the text always to be seen.
  void draw(Canvas& canvas, const Area& area, const Style& style = {}) const;

 private:
  std::string label_, text_;
  State state_ = State::idle;
};

/// What stands in place of a search after it: that the list is not whole.
std::string only_entries_with(const std::string& wanted);

/// Which row of a list is chosen, and which one is the first on the screen.
struct ListView {
  int chosen = 0, top = 0;

  /// Moves as an action says. @return whether it is one of a list
  bool move(Action action, int count, int rows);
  /// Keeps the chosen one on the screen.
  void keep(int count, int rows);
};

}  // namespace rift::studio
