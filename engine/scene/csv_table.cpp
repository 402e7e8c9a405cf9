#include "engine/scene/csv_table.hpp"

#include "engine/scene/wording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace rift {
namespace {

/// What a column of the file is: which of those asked for, and the unit its numbers are in.
struct Head {
  std::size_t wanted = 0;
  std::string unit;
};

std::vector<std::string_view> cells_of(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  for (;;) {
    const auto at = line.find(separator);
    cells.push_back(trimmed(line.substr(0, at)));
    if (at == std::string_view::npos) return cells;
    line.remove_prefix(at + 1);
  }
}

char separator_of(std::string_view header) {
  for (const char separator : {';', '\t', ','})
    if (header.find(separator) != std::string_view::npos) return separator;
  return ';';
}

std::string example_of(const CsvColumn& column) {
  const std::string_view quantity = example_quantity(column.dimension);
  return fmt::format("{} [{}]", column.name, quantity.substr(quantity.find(' ') + 1));
}

std::string examples_of(std::span<const CsvColumn> columns) {
  std::string out;
  for (const CsvColumn& column : columns)
    if (column.needed) out += (out.empty() ? "" : ";") + example_of(column);
  return out;
}

class Reader {
 public:
  explicit Reader(std::span<const CsvColumn> columns) : columns_(columns) {
    table_.column.resize(columns.size());
  }

  CsvTable read(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // the mark that spreadsheets put first
    while (!text.empty()) {
      const auto end = text.find('\n');
      take_line(text.substr(0, end));
      if (end == std::string_view::npos) break;
      text.remove_prefix(end + 1);
    }
    if (head_.empty() && table_.problems.empty())
      say(fmt::format("holds no header, such as \"{}\"", examples_of(columns_)));
    return std::move(table_);
  }

 private:
  void say(std::string text) { table_.problems.push_back({std::max(1, line_), std::move(text)}); }

  void take_line(std::string_view line) {
    ++line_;
    line = trimmed(line);
    if (line.empty() || line.starts_with('#') || unreadable_) return;
    if (head_.empty())
      take_header(line);
    else
      take_row(line);
  }

  void take_header(std::string_view line) {
    separator_ = separator_of(line);
    for (const std::string_view cell : cells_of(line, separator_)) take_head(cell);
    for (std::size_t k = 0; k < columns_.size(); ++k)
      if (columns_[k].needed && !is_there(k))
        say(fmt::format("the header has no column {}", example_of(columns_[k])));
    unreadable_ = !table_.problems.empty();  // what the rows would mean is not known
  }

  bool is_there(std::size_t wanted) const {
    return std::any_of(head_.begin(), head_.end(), [&](const Head& h) { return h.wanted == wanted; });
  }

  void take_head(std::string_view cell) {
    const auto bracket = cell.find_first_of("[(");
    const std::string_view name = trimmed(cell.substr(0, bracket));
    const auto found =
        std::find_if(columns_.begin(), columns_.end(), [&](const CsvColumn& c) { return c.name == name; });
    if (found == columns_.end()) return say(unknown(name));
    const auto wanted = static_cast<std::size_t>(found - columns_.begin());
    if (is_there(wanted)) return say(fmt::format("the header has two columns '{}'", name));
    head_.push_back({wanted, ""});
    if (found->dimension == Dimension::none) return;
    const auto close = cell.find_first_of("])");
    if (found->dimension == Dimension::strain && bracket == std::string_view::npos)
      return void(head_.back().unit = si_unit(Dimension::strain));
    if (bracket == std::string_view::npos || close == std::string_view::npos || close < bracket)
      return say(fmt::format("column '{}' has no unit: write \"{}\"", name, example_of(*found)));
    head_.back().unit = trimmed(cell.substr(bracket + 1, close - bracket - 1));
    if (const Parsed<double> one = read_quantity("1 " + head_.back().unit, found->dimension); !one.value)
      say(fmt::format("column '{}': {}", name, one.problem));
  }

  std::string unknown(std::string_view name) const {
    std::vector<std::string> names;
    for (const CsvColumn& column : columns_) names.emplace_back(column.name);
    const std::string near = nearest_name(name, names);
    if (!near.empty())
      return fmt::format("unknown column '{}', did you mean '{}'?", printable(name, 30), near);
    std::string others;  // of many the first say what they are like
    for (std::size_t k = 0, listed = 0; k < columns_.size() && listed < 4; ++k)
      if (!columns_[k].needed) others += (++listed == 1 ? ", and any of " : ", ") + example_of(columns_[k]);
    return fmt::format("unknown column '{}': expected a header such as \"{}\"{}", printable(name, 30),
                       examples_of(columns_), others);
  }

  void take_row(std::string_view line) {
    const std::vector<std::string_view> cells = cells_of(line, separator_);
    if (cells.size() != head_.size())
      return say(fmt::format("{} {}, where the header has {}", cells.size(),
                             cells.size() == 1 ? "column" : "columns", head_.size()));
    if (table_.line.size() == most_csv_rows) {
      unreadable_ = true;
      return say(fmt::format("more than {} rows: thin them out", most_csv_rows));
    }
    table_.line.push_back(line_);
    for (std::size_t k = 0; k < cells.size(); ++k) take_cell(cells[k], head_[k]);
  }

  void take_cell(std::string_view cell, const Head& head) {
    const CsvColumn& column = columns_[head.wanted];
    double number = 0.0;
    const std::string_view digits = cell.starts_with('+') ? cell.substr(1) : cell;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (cell.empty()) return say(fmt::format("{} is empty", column.name));
    if (error != std::errc{} || end != digits.data() + digits.size()) {
      const bool comma = cell.find(',') != std::string_view::npos;
      return say(fmt::format("{} '{}' is no number{}", column.name, printable(cell, 30),
                             comma ? ": decimals have a point" : ""));
    }
    if (!std::isfinite(number))
      return say(fmt::format("{} '{}' is not finite", column.name, printable(cell, 30)));
    if (column.dimension != Dimension::none) {
      const auto in_si = read_quantity(fmt::format("{} {}", digits, head.unit), column.dimension);
      if (!in_si.value)
        return say(fmt::format("{} '{}': {}", column.name, printable(cell, 30), in_si.problem));
      number = *in_si.value;
    }
    table_.column[head.wanted].push_back(number);
  }

  std::span<const CsvColumn> columns_;
  CsvTable table_;
  std::vector<Head> head_;
  char separator_ = ';';
  int line_ = 0;
  bool unreadable_ = false;
};

}  // namespace

CsvTable read_csv(std::string_view text, std::span<const CsvColumn> columns) {
  return Reader(columns).read(text);
}

}  // namespace rift
