#include "engine/scene/toml_text.hpp"

#include "engine/base/text.hpp"
#include "engine/scene/issue.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <utility>

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

/// ", in Windows-1252 'µ'" of a byte that is a letter there; above 0xA0 its numbers are those of Unicode.
std::string in_windows_1252(unsigned char byte) {
  if (byte < 0xA1) return {};
  std::string letter;
  base::append_letter(letter, byte);
  return fmt::format(", in Windows-1252 '{}'", letter);
}

}  // namespace

std::optional<TextTrouble> trouble_with_text(std::string_view text) {
  if (const std::string_view wide = wide_encoding(text); !wide.empty())
    return TextTrouble{1, fmt::format("the file is {}: {}", wide, save_as_utf8)};
  for (std::size_t k = 0; k < text.size();) {
    const auto byte = static_cast<unsigned char>(text[k]);
    if (byte == 0) return TextTrouble{line_at(text, k), "holds a zero byte: the file is no text"};
    const std::size_t length = base::bytes_of_first_letter(text.substr(k));
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

namespace {

constexpr int most_dots_a_line = 128;

Value value_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::boolean:
      return {node.as_boolean()->get()};
    case toml::node_type::integer:
      return {node.as_integer()->get()};
    case toml::node_type::floating_point:
      return {node.as_floating_point()->get()};
    case toml::node_type::string:
      return {node.as_string()->get()};
    case toml::node_type::array: {
      std::vector<Value> list;
      for (const toml::node& item : *node.as_array()) list.push_back(value_of(item));
      return {std::move(list)};
    }
    case toml::node_type::table:
      return {Value::Other{"a table"}};
    case toml::node_type::time:
      return {Value::Other{"a time of day"}};
    default:
      return {Value::Other{"a date"}};
  }
}

int line_of(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

/// toml++ bounds the depth of lists but not of dotted keys, and frees nested tables by recursion: a key of a
/// hundred thousand parts would exhaust the stack. Such a line is refused before it is parsed. A row of dots
/// in a comment is no key: only dots that follow something else count.
std::optional<TomlError> too_deep(std::string_view text) {
  int line = 1, dots = 0;
  char before = '.';
  for (const char c : text) {
    if (c == '\n') {
      ++line;
      dots = 0;
    } else if (c == '.' && before != '.' && ++dots > most_dots_a_line) {
      return TomlError{line, 1, "the line has too many dots"};
    }
    before = c;
  }
  return {};
}

/// The line of a text, from 1.
std::string_view line_numbered(std::string_view text, int number) {
  for (; number > 1 && text.find('\n') != std::string_view::npos; --number)
    text.remove_prefix(text.find('\n') + 1);
  return text.substr(0, text.find('\n'));
}

/// "beta = 0,5".
bool gives_decimal_comma(std::string_view line) {
  const std::string_view value = trimmed(line.substr(std::min(line.size(), line.find('=') + 1)));
  return value.find_first_of("+-.0123456789") == 0 && has_decimal_comma(value);
}

bool earlier(const TomlEntry& a, const TomlEntry& b) {
  return std::pair{a.line, a.column} < std::pair{b.line, b.column};
}

TomlEntry entry_of(const std::string& table, const toml::key& key, const toml::node& node) {
  const toml::source_position at = node.source().begin;
  return {table, std::string(key.str()), value_of(node), static_cast<int>(at.line),
          static_cast<int>(at.column)};
}

/// The tables of a list of tables; a list of anything else has none.
void take_rows(TomlDocument& document, const std::string& list, const toml::node& node) {
  if (!node.is_array_of_tables()) return;
  for (const toml::node& item : *node.as_array()) {
    TomlRow row{list, {}, line_of(item)};
    for (const auto& [key, value] : *item.as_table()) row.entries.push_back(entry_of(list, key, value));
    std::stable_sort(row.entries.begin(), row.entries.end(), earlier);
    document.rows.push_back(std::move(row));
  }
}

TomlDocument flattened(const toml::table& root) {
  TomlDocument document;
  for (const auto& [key, node] : root) {
    const std::string name(key.str());
    const toml::table* table = node.as_table();
    if (!table) {
      document.entries.push_back(entry_of("", key, node));
      take_rows(document, name, node);
      continue;
    }
    document.tables.push_back({name, line_of(node)});
    for (const auto& [inner, value] : *table) {
      document.entries.push_back(entry_of(name, inner, value));
      take_rows(document, fmt::format("{}.{}", name, inner.str()), value);
    }
  }
  const auto by_line = [](const auto& a, const auto& b) { return a.line < b.line; };
  std::stable_sort(document.tables.begin(), document.tables.end(), by_line);
  std::stable_sort(document.entries.begin(), document.entries.end(), earlier);
  return document;
}

}  // namespace

TomlDocument read_toml(std::string_view text) {
  static_assert(largest_preset == std::size_t{8} << 20);  // as the message says
  if (text.size() > largest_preset) return {{}, {}, {}, TomlError{1, 1, "larger than 8 MiB: not a preset"}};
  if (const auto trouble = trouble_with_text(text))
    return {{}, {}, {}, TomlError{trouble->line, 1, trouble->text}};
  if (auto error = too_deep(text)) return {{}, {}, {}, std::move(error)};
  try {
    return flattened(toml::parse(text));
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    std::string cause = printable(error.description(), 200);
    if (gives_decimal_comma(line_numbered(text, static_cast<int>(at.line)))) cause += ": use a decimal point";
    return {{}, {}, {}, TomlError{static_cast<int>(at.line), static_cast<int>(at.column), std::move(cause)}};
  }
}

Value value_from_text(std::string_view text) {
  const TomlDocument document = read_toml(fmt::format("value = {}", text));
  const bool one_value = !document.error && document.tables.empty() && document.entries.size() == 1;
  if (one_value && text.find('\n') == std::string_view::npos) return document.entries.front().value;
  return {std::string(text)};
}

}  // namespace rift::scene
