#include "engine/scene/toml_text.hpp"

#include "engine/scene/text_encoding.hpp"
#include "engine/scene/wording.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <utility>

namespace rift::scene {

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
    if (gives_decimal_comma(line_numbered(text, static_cast<int>(at.line))))
      cause += ": decimals have a point";
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
