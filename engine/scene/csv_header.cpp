#include "engine/scene/csv_table.hpp"
#include "engine/scene/issue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace rift::scene {
namespace {

constexpr int most_lines_before_header = 100;
constexpr std::size_t longest_header = std::size_t{1} << 16;  // bytes
constexpr std::string_view csv_separators = ";\t,|";          // in the order in which they are tried

/// Small letters, of ASCII alone, and _ for blanks within.
std::string plain_name(std::string_view written) {
  std::string name(trimmed(written));
  for (char& c : name) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t') c = '_';
  }
  return name;
}

bool is_unit(std::string_view unit, const CsvColumn& column) {
  if (!column.plain_unit.empty() && unit == column.plain_unit) return true;
  return column.dimension != Dimension::none &&
         read_quantity("1 " + std::string(unit), column.dimension).value.has_value();
}

/// "time [us]" and "time (us)", "t / us".
std::pair<std::string_view, std::string_view> name_and_unit(std::string_view cell) {
  const auto open = cell.find_first_of("[(");
  if (open != std::string_view::npos && open > 0) {
    const auto close = cell.find_first_of("])", open);
    std::string_view name = trimmed(cell.substr(0, open));
    if (name.ends_with('/')) name.remove_suffix(1);  // "t / (us)"
    if (close == std::string_view::npos) return {name, {}};
    return {name, trimmed(cell.substr(open + 1, close - open - 1))};
  }
  const auto slash = cell.find('/');
  if (slash == std::string_view::npos || slash == 0) return {cell, {}};
  return {cell.substr(0, slash), trimmed(cell.substr(slash + 1))};
}

CsvTitle title_of(std::string_view cell, std::span<const CsvColumn> columns) {
  const auto [name, unit] = name_and_unit(cell);
  CsvTitle title{plain_name(name), std::string(unit), {}};
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (columns[k].name == title.name) title.wanted = k;
  if (title.wanted || !title.unit.empty()) return title;
  for (std::size_t k = 0; k < columns.size(); ++k) {  // "time_us"
    const std::string_view whole = trimmed(cell);
    const std::size_t length = columns[k].name.size();
    if (!title.name.starts_with(columns[k].name) || whole.size() < length + 2 || whole[length] != '_' ||
        !is_unit(whole.substr(length + 1), columns[k]))
      continue;
    return {std::string(columns[k].name), std::string(whole.substr(length + 1)), k};
  }
  return title;
}

std::vector<CsvTitle> titles_of(const CsvRow& row, std::span<const CsvColumn> columns) {
  std::vector<CsvTitle> titles;
  for (const std::string& cell : row.cell) titles.push_back(title_of(cell, columns));
  while (!titles.empty() && titles.back().name.empty()) titles.pop_back();
  const auto is_there = [&](std::size_t k) {
    return std::any_of(titles.begin(), titles.end(), [&](const CsvTitle& t) { return t.wanted == k; });
  };
  for (CsvTitle& title : titles)
    for (std::size_t k = 0; k < columns.size(); ++k)
      if (!title.wanted && !columns[k].symbol.empty() && title.name == columns[k].symbol && !is_there(k))
        title.wanted = k;
  return titles;
}

struct Names {
  int found = 0;
  bool is_complete = false;
};

Names names_in_header(const CsvHeader& header, std::span<const CsvColumn> columns) {
  bool complete = true, asks_for_one = false, has_one = false;
  Names names;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const bool there = header.column_of(k).has_value();
    names.found += there ? 1 : 0;
    if (columns[k].need == CsvNeed::needed) complete = complete && there;
    if (columns[k].need == CsvNeed::one_of) asks_for_one = true, has_one = has_one || there;
  }
  names.is_complete = complete && (!asks_for_one || has_one);
  return names;
}

/// The separator of a first line "sep=;", which is taken off.
std::optional<char> take_separator_line(std::string_view& text) {
  const auto end = std::min(text.size(), text.find('\n'));
  std::string line(text.substr(0, end));
  std::erase_if(line, [](char c) { return c == '"' || c == '\r' || c == ' '; });
  if (line.size() < 5 || plain_name(line.substr(0, 4)) != "sep=") return std::nullopt;
  text.remove_prefix(std::min(text.size(), end + 1));
  return line[4];
}

/// The row at the text's begin, read as a header with one separator.
CsvHeader header_at(std::string_view text, int line, char separator, std::span<const CsvColumn> columns,
                    bool& is_comment) {
  CsvRows rows(text.substr(0, longest_header), line, separator);
  CsvRow row;
  rows.next(row);
  const std::size_t taken = std::min(text.size(), longest_header) - rows.left().size();
  is_comment = row.is_comment;
  if (is_comment) row.cell.front().erase(0, row.cell.front().find_first_not_of("# \t\""));
  CsvHeader header{titles_of(row, columns), line, separator, text.substr(taken), rows.line(), false};
  header.is_found = !header.title.empty();
  return header;
}

std::string name_in_quotes(const CsvTitle& title) { return fmt::format("'{}'", printable(title.name, 30)); }

/// "'frame', 'grey_value' and 3 more".
std::string names_found(const CsvHeader& header) {
  std::vector<std::string> names;
  for (const CsvTitle& title : header.title)
    if (!title.name.empty()) names.push_back(name_in_quotes(title));
  constexpr std::size_t most = 8;
  if (names.size() > most) {
    const std::size_t more = names.size() - most;
    names.resize(most);
    names.push_back(fmt::format("{} more", more));
  }
  return listed(names, "and");
}

bool is_number(std::string_view text) {
  double ignored = 0.0;
  return std::from_chars(text.data(), text.data() + text.size(), ignored).ec == std::errc{};
}

}  // namespace

std::optional<std::size_t> CsvHeader::column_of(std::size_t wanted) const {
  for (std::size_t k = 0; k < title.size(); ++k)
    if (title[k].wanted == wanted) return k;
  return std::nullopt;
}

CsvHeader find_csv_header(std::string_view text, std::span<const CsvColumn> columns) {
  int line = 1;
  const std::optional<char> given = take_separator_line(text);
  if (given) ++line;
  const std::string separators = given ? std::string(1, *given) : std::string(csv_separators);
  CsvHeader best, commented;
  int most = -1;
  for (int looked_at = 0; !text.empty() && looked_at < most_lines_before_header; ++looked_at, ++line) {
    const int before = most;
    for (const char separator : separators) {
      bool is_comment = false;
      CsvHeader header = header_at(text, line, separator, columns, is_comment);
      const Names names = names_in_header(header, columns);
      if (!header.is_found) continue;
      if (is_comment) {
        if (names.is_complete && !commented.is_found) commented = std::move(header);
        continue;
      }
      if (names.is_complete) return header;
      const bool parts_more = most > before && names.found == most && header.title.size() > best.title.size();
      if (names.found > most || parts_more) most = names.found, best = std::move(header);
    }
    text.remove_prefix(std::min(text.size(), std::min(text.size(), text.find('\n')) + 1));
  }
  return commented.is_found ? commented : best;
}

std::vector<std::string> header_problems(const CsvHeader& header, std::span<const CsvColumn> columns) {
  std::vector<std::string> problems, missing, one_of, several, names;
  for (const CsvColumn& column : columns) names.emplace_back(column.name);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const auto count = std::count_if(header.title.begin(), header.title.end(),
                                     [&](const CsvTitle& title) { return title.wanted == k; });
    if (count > 1) problems.push_back(fmt::format("the header has two columns '{}'", columns[k].name));
    if (count == 0 && columns[k].need == CsvNeed::needed) missing.push_back(example_of(columns[k]));
    if (columns[k].need != CsvNeed::one_of) continue;
    one_of.push_back(example_of(columns[k]));
    if (count > 0) several.emplace_back(columns[k].name);
  }
  bool misspelt = false;
  for (const CsvTitle& title : header.title) {
    if (title.wanted || title.name.size() < 3) continue;
    const std::string near = nearest_name(title.name, names);
    const auto at = std::find(names.begin(), names.end(), near) - names.begin();
    if (near.empty() || header.column_of(static_cast<std::size_t>(at))) continue;
    problems.push_back(fmt::format("unknown column {}, did you mean '{}'?", name_in_quotes(title), near));
    misspelt = true;
  }
  if (several.size() > 1)
    problems.push_back(
        fmt::format("the header has {}: only one of them can be read", listed(several, "and")));
  if (several.empty() && !one_of.empty()) missing.push_back(listed(one_of));
  if (missing.empty() || misspelt) return problems;
  const bool numbers = !header.title.empty() && is_number(header.title.front().name);
  problems.push_back(numbers ? fmt::format("holds no header, such as \"{}\"", examples_of(columns))
                             : fmt::format("the header has no column {}: it has {}", listed(missing, "and"),
                                           names_found(header)));
  return problems;
}

std::string example_of(const CsvColumn& column) {
  const std::string_view quantity = example_quantity(column.dimension);
  return fmt::format("{} [{}]", column.name, quantity.substr(quantity.find(' ') + 1));
}

std::string examples_of(std::span<const CsvColumn> columns) {
  std::string out;
  bool one_of = false;
  for (const CsvColumn& column : columns) {
    if (column.need == CsvNeed::optional || (column.need == CsvNeed::one_of && one_of)) continue;
    one_of = one_of || column.need == CsvNeed::one_of;
    out += (out.empty() ? "" : ";") + example_of(column);
  }
  return out;
}

}  // namespace rift::scene
