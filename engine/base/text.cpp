#include "engine/base/text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace rift::base {
namespace {

constexpr unsigned first_byte(std::string_view text) { return static_cast<unsigned char>(text.front()); }

bool is_control(std::string_view letter) {
  if (letter.size() == 1) return first_byte(letter) < 0x20 || first_byte(letter) == 0x7F;
  return letter.size() == 2 && first_byte(letter) == 0xC2 && static_cast<unsigned char>(letter[1]) < 0xA0;
}

}  // namespace

std::string counted(std::int64_t count, std::string_view noun, std::string_view plural) {
  if (count == 1) return fmt::format("1 {}", noun);
  return plural.empty() ? fmt::format("{} {}s", count, noun) : fmt::format("{} {}", count, plural);
}

std::size_t bytes_of_first_letter(std::string_view text) {
  const unsigned first = first_byte(text);
  if (first < 0x80) return 1;
  const std::size_t count = first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 0;
  if (count == 0 || text.size() < count) return 0;
  for (std::size_t k = 1; k < count; ++k)
    if ((static_cast<unsigned char>(text[k]) & 0xC0U) != 0x80U) return 0;
  const unsigned second = static_cast<unsigned char>(text[1]);
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool beyond = (first == 0xED && second >= 0xA0) || (first == 0xF4 && second >= 0x90);
  return overlong || beyond ? 0 : count;
}

std::u32string letters_of(std::string_view text) {
  std::u32string letters;
  while (!text.empty()) {
    const std::size_t count = bytes_of_first_letter(text);
    char32_t letter = count == 0   ? U'?'
                      : count == 1 ? first_byte(text)
                                   : first_byte(text) & (0xFFU >> (count + 1));
    for (std::size_t k = 1; k < count; ++k)
      letter = letter << 6U | (static_cast<unsigned char>(text[k]) & 0x3FU);
    letters += letter;
    text.remove_prefix(std::max<std::size_t>(1, count));
  }
  return letters;
}

std::size_t count_letters(std::string_view text) {
  return text.size() - static_cast<std::size_t>(std::ranges::count_if(text, continues_letter));
}

void append_letter(std::string& text, char32_t letter) {
  const int more = letter < 0x80 ? 0 : letter < 0x800 ? 1 : letter < 0x10000 ? 2 : 3;
  constexpr unsigned first[] = {0, 0xC0, 0xE0, 0xF0};
  text += static_cast<char>(first[more] | letter >> (6 * more));
  for (int k = more - 1; k >= 0; --k) text += static_cast<char>(0x80U | (letter >> (6 * k) & 0x3FU));
}

std::string without_quotes(std::string_view text) {
  const bool quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
  return std::string(quoted ? text.substr(1, text.size() - 2) : text);
}

std::string escaped(std::string_view text, std::string_view kept) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const std::size_t count = bytes_of_first_letter(text);
    const std::string_view letter = text.substr(0, count == 0 ? 1 : count);
    const bool stays = count == 1 && kept.find(letter) != std::string_view::npos;
    if (count != 0 && (stays || !is_control(letter)))
      out += letter;
    else
      for (const char byte : letter) out += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
    text.remove_prefix(letter.size());
  }
  return out;
}

namespace {

/// The library escapes C0 only. DEL and C1 stand within strings alone, where \u00NN means the same.
std::string without_c1(std::string text) {
  if (text.find_first_of("\x7f\xc2") == std::string::npos) return text;
  std::string out;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const auto byte = static_cast<unsigned char>(text[k]);
    const auto next = static_cast<unsigned char>(k + 1 < text.size() ? text[k + 1] : '\0');
    if (byte == 0x7F) {
      out += "\\u007f";
    } else if (byte == 0xC2 && next >= 0x80 && next < 0xA0) {
      out += fmt::format("\\u{:04x}", next);
      ++k;
    } else {
      out += text[k];
    }
  }
  return out;
}

template <typename Json>
std::string text_of_json(const Json& value, int indent) {
  return without_c1(value.dump(indent, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

std::string json_text(const nlohmann::ordered_json& value, int indent) { return text_of_json(value, indent); }
std::string json_text(const nlohmann::json& value, int indent) { return text_of_json(value, indent); }

}  // namespace rift::base
