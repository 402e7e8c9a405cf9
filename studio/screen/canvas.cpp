#include "studio/screen/canvas.hpp"

#include "engine/base/text.hpp"

namespace rift::studio {
namespace {

/// The bytes of the letter that begins here, and what its first byte holds of it; 0 bytes where none begins.
int bytes_of_letter(unsigned char first) {
  return first < 0x80              ? 1
         : (first & 0xE0U) == 0xC0 ? 2
         : (first & 0xF0U) == 0xE0 ? 3
         : (first & 0xF8U) == 0xF0 ? 4
                                   : 0;
}

void append_utf8(std::string& out, char32_t c) {
  if (c < 0x80) {
    out += static_cast<char>(c);
  } else if (c < 0x800) {
    out += static_cast<char>(0xC0U | c >> 6U);
    out += static_cast<char>(0x80U | (c & 0x3FU));
  } else {
    out += static_cast<char>(0xE0U | c >> 12U);
    out += static_cast<char>(0x80U | (c >> 6U & 0x3FU));
    out += static_cast<char>(0x80U | (c & 0x3FU));
  }
}

}  // namespace

std::u32string letters_of(std::string_view text) {
  std::u32string letters;
  for (std::size_t at = 0; at < text.size();) {
    const int count = bytes_of_letter(static_cast<unsigned char>(text[at]));
    if (count == 0 || at + count > text.size()) {
      letters += U'?';
      ++at;
      continue;
    }
    char32_t letter = static_cast<unsigned char>(text[at]) & (count == 1 ? 0x7FU : 0xFFU >> (count + 1));
    for (int k = 1; k < count; ++k)
      letter = letter << 6U | (static_cast<unsigned char>(text[at + k]) & 0x3FU);
    letters += letter;
    at += count;
  }
  return letters;
}

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
  for (int x = 0; x < width_; ++x) append_utf8(out, at(x, y).glyph);
  out.erase(out.find_last_not_of(' ') + 1);
  return out;
}

}  // namespace rift::studio
