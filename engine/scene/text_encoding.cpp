#include "engine/scene/text_encoding.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rift::scene {
namespace {

constexpr const char* save_as_utf8 = "save it as UTF-8 (in Excel: \"CSV UTF-8\")";

int line_at(std::string_view text, std::size_t at) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

/// "UTF-16", "UTF-32" or nothing. Without a mark: every other byte of the first letters is zero.
std::string_view wide_encoding(std::string_view text) {
  using namespace std::string_view_literals;
  if (text.starts_with("\xFF\xFE\0\0"sv) || text.starts_with("\0\0\xFE\xFF"sv)) return "UTF-32";
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return "UTF-16";
  if (text.size() < 4) return {};
  const auto zero = [&](std::size_t k) { return text[k] == '\0'; };
  const bool one_way = !zero(0) && zero(1) && !zero(2) && zero(3);
  return one_way || (zero(0) && !zero(1) && zero(2) && !zero(3)) ? "UTF-16" : std::string_view{};
}

/// Bytes of the letter that begins at `at`; 0 where no letter of UTF-8 does   [RFC 3629].
std::size_t length_of_letter(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned char first = byte(at);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || at + length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byte(at + k) & 0xC0u) != 0x80u) return 0;
  const unsigned char second = byte(at + 1);
  const bool too_long = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool no_letter = (first == 0xED && second > 0x9F) || (first == 0xF4 && second > 0x8F);
  return too_long || no_letter ? 0 : length;
}

/// ", in Windows-1252 'µ'" of a byte that is a letter there; above 0xA0 its numbers are those of Unicode.
std::string in_windows_1252(unsigned char byte) {
  if (byte < 0xA1) return {};
  const char letter[] = {static_cast<char>(0xC0 | byte >> 6), static_cast<char>(0x80 | (byte & 0x3F)), '\0'};
  return fmt::format(", in Windows-1252 '{}'", letter);
}

}  // namespace

std::optional<TextTrouble> trouble_with_text(std::string_view text) {
  if (const std::string_view wide = wide_encoding(text); !wide.empty())
    return TextTrouble{1, fmt::format("the file is {}: {}", wide, save_as_utf8)};
  for (std::size_t k = 0; k < text.size();) {
    const auto byte = static_cast<unsigned char>(text[k]);
    if (byte == 0) return TextTrouble{line_at(text, k), "holds a zero byte: the file is no text"};
    const std::size_t length = length_of_letter(text, k);
    if (length == 0)
      return TextTrouble{line_at(text, k),
                         fmt::format("the byte 0x{:02X} is no UTF-8{}: the file is of another "
                                     "encoding, {}",
                                     byte, in_windows_1252(byte), save_as_utf8)};
    if (byte == '\r') {
      const std::size_t next = text.find_first_not_of('\r', k);
      if (next != std::string_view::npos && text[next] != '\n')
        return TextTrouble{line_at(text, k),
                           "ends with a carriage return alone, as no line feed follows: save the file with "
                           "line ends of Unix or Windows"};
    }
    k += length;
  }
  return std::nullopt;
}

std::string_view without_byte_order_mark(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text;
}

}  // namespace rift::scene
