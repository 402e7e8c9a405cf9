#pragma once

#include "engine/scene/units.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

struct TomlTable {
  std::string name;
  int line = 0;
};

/// One `name = value` of a preset; `table` is empty at the top level. Deeper tables are values of kind "a
/// table".
struct TomlEntry {
  std::string table, name;
  Value value;
  int line = 0, column = 0;  // of the value; they give the order in the file
};

/// One table of a list of tables, such as one [[lanes]] or one [[study.rows]]. The list is an entry as well.
struct TomlRow {
  std::string list;  // "lanes", "study.rows"
  std::vector<TomlEntry> entries;
  int line = 0;
};

struct TomlError {
  int line = 0, column = 0;
  std::string text;
};

/// A TOML text laid flat, in the order of its lines; where it does not parse, only the error.
struct TomlDocument {
  std::vector<TomlTable> tables;
  std::vector<TomlEntry> entries;
  std::vector<TomlRow> rows;
  std::optional<TomlError> error;
};

/// No preset may hold more bytes: what a run keeps of one with a long measured history among them.
inline constexpr std::size_t largest_preset = std::size_t{8} << 20;

/// Never throws on bad text, however hostile: texts above 8 MiB, of another encoding and keys of absurd depth
/// are refused.
TomlDocument read_toml(std::string_view text);

/// One value as it stands after the '=' of --set: a TOML value where it parses, else the bare text.
Value value_from_text(std::string_view text);

}  // namespace rift::scene
