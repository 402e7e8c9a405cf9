#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rift::scene {

/// What keeps a whole file from being read as text, found once and not in each of its lines.
struct TextTrouble {
  int line = 0;  // from 1
  std::string text;
};

/// Names UTF-16 and UTF-32 (with a byte order mark or without), zero bytes, bytes that are no UTF-8 with what
/// they are in Windows-1252 (0xB5 is a micro sign), and lines that end with a carriage return alone. Nothing
/// for UTF-8 with line feeds, with carriage returns before them or not. Cost O(|text|).
std::optional<TextTrouble> trouble_with_text(std::string_view text);

/// The text without the byte order mark of UTF-8, which spreadsheets put first.
std::string_view without_byte_order_mark(std::string_view text);

}  // namespace rift::scene
