#include "studio/screen/prompt.hpp"

#include "engine/base/text.hpp"
#include "studio/screen/canvas.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rift::studio {
namespace {

void drop_last_letter(std::string& text) {
  while (!text.empty() && base::continues_letter(text.back())) text.pop_back();
  if (!text.empty()) text.pop_back();
}

constexpr int control_u = 21;  // as in a shell: all away

}  // namespace

Prompt::State Prompt::press(const KeyEvent& event) {
  constexpr std::size_t longest = 400;
  if (event.key == key_enter) return state_ = State::entered;
  if (event.key == key_escape) return state_ = State::cancelled;
  if (event.key == key_backspace) drop_last_letter(text_);
  if (event.key == control_u) text_.clear();
  if (event.key >= 32 && event.key < key_up && text_.size() < longest)
    base::append_letter(text_, static_cast<char32_t>(event.key));
  return state_;
}

void Prompt::draw(Canvas& canvas, const Area& area, const Style& style) const {
  if (area.empty()) return;
  clear(canvas, {area.x, area.y, area.width, 1}, style);
  const int label =
      label_.empty() ? 0 : canvas.text(area.x, area.y, label_ + ": ", {Ink::title, true}, area.width);
  const std::u32string letters = letters_of(text_);
  const int room = std::max(1, area.width - label - 1);
  const std::size_t from = letters.size() > static_cast<std::size_t>(room) ? letters.size() - room : 0;
  int x = area.x + label;
  for (std::size_t k = from; k < letters.size(); ++k) canvas.put(x++, area.y, letters[k], style);
  canvas.put(x, area.y, U' ', {style.ink, style.bold, !style.reverse});
}

std::string only_entries_with(const std::string& wanted) {
  return fmt::format("only entries with \"{}\"; press / and enter to show all", wanted);
}

bool ListView::move(Action action, int count, int rows) {
  const int page = std::max(1, rows - 1);
  switch (action) {
    case Action::up:
      --chosen;
      break;
    case Action::down:
      ++chosen;
      break;
    case Action::page_up:
      chosen -= page;
      break;
    case Action::page_down:
      chosen += page;
      break;
    case Action::first:
      chosen = 0;
      break;
    case Action::last:
      chosen = count - 1;
      break;
    default:
      return false;
  }
  keep(count, rows);
  return true;
}

void ListView::keep(int count, int rows) {
  chosen = std::clamp(chosen, 0, std::max(0, count - 1));
  top = std::clamp(top, chosen - std::max(1, rows) + 1, chosen);
  top = std::clamp(top, 0, std::max(0, count - 1));
}

}  // namespace rift::studio
