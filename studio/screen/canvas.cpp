#include "studio/screen/canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace rift::studio {

void Canvas::put(int x, int y, char32_t glyph, const Style& style) {
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
  const bool control = glyph < 0x20 || (glyph >= 0x7F && glyph < 0xA0);
  cell_[static_cast<std::size_t>(y) * width_ + x] = {control ? U'?' : glyph, style};
}

int Canvas::text(int x, int y, std::string_view text, const Style& style, int width) {
  int taken = 0;
  for (const char32_t letter : letters_of(base::escaped(text))) {
    if (taken >= width) break;
    put(x + taken++, y, letter, style);
  }
  return taken;
}

std::string Canvas::row(int y) const {
  std::string out;
  for (int x = 0; x < width_; ++x) base::append_letter(out, at(x, y).glyph);
  out.erase(out.find_last_not_of(' ') + 1);
  return out;
}

std::string letters_for(Glyphs glyphs, std::string_view text) {
  std::string spelt(text);
  if (glyphs == Glyphs::unicode) return spelt;
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> words{
      {{"α", "alpha"}, {"β", "beta"}, {"η", "eta"}, {"µ", "u"}, {"ν", "nu"}}};
  for (const auto& [letter, word] : words)
    for (std::size_t at = 0; (at = spelt.find(letter, at)) != std::string::npos;)
      spelt.replace(at, letter.size(), word);
  return spelt;
}

void clear(Canvas& canvas, const Area& area, const Style& style) {
  for (int y = area.y; y < area.y + area.height; ++y)
    for (int x = area.x; x < area.x + area.width; ++x) canvas.put(x, y, U' ', style);
}

Area draw_box(Canvas& canvas, int width, int height, std::string_view title, Glyphs glyphs) {
  width = std::min(width, canvas.width() - 2), height = std::min(height, canvas.height() - 2);
  if (width < 1 || height < 1) return {};
  const Area box{(canvas.width() - width - 2) / 2, (canvas.height() - height - 2) / 2, width + 2, height + 2};
  clear(canvas, box);
  const bool fine = glyphs == Glyphs::unicode;
  const int right = box.x + box.width - 1, low = box.y + box.height - 1;
  for (int x = box.x + 1; x < right; ++x)
    for (const int y : {box.y, low}) canvas.put(x, y, fine ? U'─' : U'-', {Ink::dim});
  for (int y = box.y + 1; y < low; ++y)
    for (const int x : {box.x, right}) canvas.put(x, y, fine ? U'│' : U'|', {Ink::dim});
  canvas.put(box.x, box.y, fine ? U'╭' : U'+', {Ink::dim});
  canvas.put(right, box.y, fine ? U'╮' : U'+', {Ink::dim});
  canvas.put(box.x, low, fine ? U'╰' : U'+', {Ink::dim});
  canvas.put(right, low, fine ? U'╯' : U'+', {Ink::dim});
  canvas.text(box.x + 2, box.y, fmt::format(" {} ", title), {Ink::title, true}, box.width - 4);
  return {box.x + 1, box.y + 1, width, height};
}

int draw_paragraph(Canvas& canvas, const Area& area, std::string_view text, const Style& style) {
  const std::u32string letters = letters_of(text);
  int lines = 0;
  for (std::size_t at = 0; at < letters.size() && lines < area.height; ++lines) {
    std::size_t end = std::min(letters.size(), at + static_cast<std::size_t>(std::max(area.width, 1)));
    const std::size_t newline = letters.find(U'\n', at);
    if (newline != std::u32string::npos && newline <= end) {
      end = newline;
    } else if (end < letters.size()) {
      const std::size_t blank = letters.rfind(U' ', end);
      if (blank != std::u32string::npos && blank > at) end = blank;
    }
    for (std::size_t k = at; k < end; ++k)
      canvas.put(area.x + static_cast<int>(k - at), area.y + lines, letters[k], style);
    at = end < letters.size() && (letters[end] == U' ' || letters[end] == U'\n') ? end + 1 : end;
  }
  return lines;
}

bool draw_too_small(Canvas& canvas) {
  if (canvas.width() >= least_width && canvas.height() >= least_height) return false;
  const std::string text = fmt::format("{}x{} is too small: {}x{} needed", canvas.width(), canvas.height(),
                                       least_width, least_height);
  draw_paragraph(canvas, {0, std::max(0, canvas.height() / 2 - 1), canvas.width(), canvas.height()}, text,
                 {Ink::bad, true});
  return true;
}

}  // namespace rift::studio
