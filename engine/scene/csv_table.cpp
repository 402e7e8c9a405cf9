#include "engine/scene/csv_table.hpp"

#include "engine/scene/issue.hpp"
#include "engine/scene/toml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace rift::scene {

void CsvRows::skip_blanks() {
  while (!left_.empty() && (left_.front() == ' ' || (left_.front() == '\t' && separator_ != '\t')))
    left_.remove_prefix(1);
}

void CsvRows::take_quoted(std::string& cell, bool& is_unclosed) {
  left_.remove_prefix(1);
  for (;;) {
    const auto quote = left_.find('"');
    const std::string_view text = left_.substr(0, quote);
    line_ += static_cast<int>(std::count(text.begin(), text.end(), '\n'));
    cell += text;
    left_.remove_prefix(std::min(left_.size(), text.size() + 1));
    is_unclosed = quote == std::string_view::npos;
    if (is_unclosed || !left_.starts_with('"')) return;
    cell += '"';  // two of them stand for one
    left_.remove_prefix(1);
  }
}

bool CsvRows::next(CsvRow& row) {
  if (left_.empty()) return false;
  row.line = line_, row.is_unclosed = false;
  row.cell.clear();
  const auto first = left_.find_first_not_of(" \t\"");
  row.is_comment = first != std::string_view::npos && left_[first] == '#';
  for (;;) {
    std::string& cell = row.cell.emplace_back();
    skip_blanks();
    if (left_.starts_with('"') && !row.is_comment) take_quoted(cell, row.is_unclosed);
    const auto end = std::min(left_.size(), left_.find_first_of(std::string{separator_, '\n'}));
    cell += left_.substr(0, end);
    cell = trimmed(cell);
    const bool more = end < left_.size() && left_[end] == separator_;
    left_.remove_prefix(std::min(left_.size(), end + 1));
    if (more) continue;
    ++line_;
    return true;
  }
}

bool is_blank(const CsvRow& row) {
  return std::all_of(row.cell.begin(), row.cell.end(), [](const std::string& c) { return c.empty(); });
}

namespace {

constexpr std::size_t most_csv_problems = 100;  // of one file; more are of the same kinds

/// The number that a whole cell is, infinities and NaN too; nothing where it is none.
std::optional<double> number_of_cell(std::string_view cell) {
  if (cell.starts_with('+')) cell.remove_prefix(1);
  double number = 0.0;
  const char* end = cell.data() + cell.size();
  const auto [last, error] = std::from_chars(cell.data(), end, number);
  if (cell.empty() || error != std::errc{} || last != end) return std::nullopt;
  return number;
}

class TableReader {
 public:
  TableReader(std::span<const CsvColumn> columns, std::size_t most_rows)
      : columns_(columns), most_rows_(most_rows) {
    table_.column.resize(columns.size());
    table_.unit.resize(columns.size());
  }

  CsvTable read(std::string_view text) {
    text = without_byte_order_mark(text);
    if (const auto trouble = trouble_with_text(text)) {
      say(trouble->line, trouble->text);
      return std::move(table_);
    }
    header_ = find_csv_header(text, columns_);
    if (!header_.is_found) {
      const auto lines = std::count(text.begin(), text.end(), '\n');
      say(std::max(1, static_cast<int>(lines)),
          fmt::format("holds no header, such as \"{}\"", examples_of(columns_)));
      return std::move(table_);
    }
    for (std::string& problem : header_problems(header_, columns_)) say(header_.line, std::move(problem));
    if (table_.problems.empty()) take_rows();
    return std::move(table_);
  }

 private:
  void say(int line, std::string text) {
    if (table_.problems.size() < most_csv_problems) return table_.problems.push_back({line, std::move(text)});
    if (!is_done_) table_.problems.push_back({line, "and so on: the following rows were not read"});
    is_done_ = true;
  }
  /// A defect that the other rows are likely to share: it is named once.
  void say_of_all(int line, std::string text) {
    say(line, std::move(text));
    is_done_ = true;
  }

  void take_rows() {
    for (const CsvTitle& title : header_.title)
      if (!title.wanted && !title.name.empty()) table_.beside.push_back(title.name);
    CsvRows rows(header_.below, header_.below_line, header_.separator);
    CsvRow row;
    bool is_first = true;
    while (!is_done_ && rows.next(row)) {
      if (row.is_comment || is_blank(row)) continue;
      if (row.is_unclosed) {
        say_of_all(row.line, "a quote opens here and never closes");
        return;
      }
      const bool is_units = is_first && holds_units(row);
      if (is_first && !take_units(is_units ? &row : nullptr)) return;
      if (!is_units) take_row(row);
      is_first = false;
    }
    if (is_first) take_units(nullptr);
  }

  /// A row below the header that has no number in any column which is asked for, and in none a sentence.
  bool holds_units(const CsvRow& row) const {
    bool any = false;
    for (std::size_t k = 0; k < header_.title.size(); ++k) {
      if (!header_.title[k].wanted) continue;
      const std::string_view cell = k < row.cell.size() ? std::string_view(row.cell[k]) : std::string_view{};
      if (number_of_cell(cell) || cell.find_first_of("0123456789") == 0) return false;
      if (!header_.title[k].unit.empty() && !cell.empty() && bare_unit(cell) != header_.title[k].unit)
        return false;
      any = any || !cell.empty();
    }
    return any;
  }

  static std::string bare_unit(std::string_view cell) {
    if (cell.size() > 2 && (cell.front() == '[' || cell.front() == '('))
      cell = cell.substr(1, cell.size() - 2);
    return std::string(trimmed(cell));
  }

  bool take_units(const CsvRow* below) {
    const std::size_t before = table_.problems.size();
    for (std::size_t k = 0; k < header_.title.size(); ++k) {
      CsvTitle& title = header_.title[k];
      if (!title.wanted) continue;
      const CsvColumn& column = columns_[*title.wanted];
      const int line = title.unit.empty() && below ? below->line : header_.line;
      if (title.unit.empty() && below && k < below->cell.size()) title.unit = bare_unit(below->cell[k]);
      check_unit(column, title.unit, line);
      table_.unit[*title.wanted] = title.unit;
    }
    return table_.problems.size() == before;
  }

  void check_unit(const CsvColumn& column, std::string& unit, int line) {
    if (column.dimension == Dimension::none || (!unit.empty() && unit == column.plain_unit)) return;
    if (unit.empty() && column.dimension == Dimension::strain) unit = si_unit(Dimension::strain);
    if (unit.empty())
      return say(line, fmt::format("column '{}' has no unit: write \"{}\"", column.name, example_of(column)));
    if (const Parsed<double> one = read_quantity("1 " + unit, column.dimension); !one.value)
      say(line, fmt::format("column '{}': {}", column.name, one.problem));
  }

  void take_row(const CsvRow& row) {
    std::size_t cells = row.cell.size(), needed = 0;
    while (cells > header_.title.size() && row.cell[cells - 1].empty()) --cells;
    for (std::size_t k = 0; k < header_.title.size(); ++k)
      if (header_.title[k].wanted) needed = k + 1;
    if (cells > header_.title.size() || cells < needed)
      return say(row.line,
                 fmt::format("{} {}, where the header has {}{}", cells, cells == 1 ? "column" : "columns",
                             header_.title.size(),
                             header_.separator == ',' && cells > header_.title.size()
                                 ? ": use a decimal point, or put a cell that holds a comma in quotes"
                                 : ""));
    if (table_.line.size() == most_rows_)
      return say_of_all(row.line, fmt::format("more than {} rows: thin them out", most_rows_));
    table_.line.push_back(row.line);
    for (std::size_t k = 0; k < header_.title.size() && !is_done_; ++k)
      if (header_.title[k].wanted) take_cell(row.line, row.cell[k], header_.title[k]);
  }

  void take_cell(int line, std::string_view cell, const CsvTitle& title) {
    const CsvColumn& column = columns_[*title.wanted];
    const auto shown_cell = [&] { return fmt::format("{} '{}'", column.name, printable(cell, 30)); };
    if (cell.empty()) return say(line, fmt::format("{} is empty", column.name));
    std::optional<double> number = number_of_cell(cell);
    if (!number && cell.find(',') != std::string_view::npos)
      return say_of_all(line, shown_cell() + " is not a number: use a decimal point");
    if (!number && column.dimension == Dimension::time && cell.find(':') != std::string_view::npos)
      return say_of_all(line,
                        shown_cell() + " is a time of day: write the time since the first row, such as 0.25");
    if (!number) return say(line, shown_cell() + " is not a number");
    if (!std::isfinite(*number)) return say(line, shown_cell() + " is not finite");
    if (column.dimension != Dimension::none && title.unit != column.plain_unit) {
      const auto in_si = read_quantity(fmt::format("{} {}", cell, title.unit), column.dimension);
      if (!in_si.value) return say(line, fmt::format("{}: {}", shown_cell(), in_si.problem));
      number = in_si.value;
    }
    table_.column[*title.wanted].push_back(*number);
  }

  std::span<const CsvColumn> columns_;
  std::size_t most_rows_;
  CsvTable table_;
  CsvHeader header_;
  bool is_done_ = false;
};

}  // namespace

CsvTable read_csv(std::string_view text, std::span<const CsvColumn> columns, std::size_t most_rows) {
  return TableReader(columns, most_rows).read(text);
}

}  // namespace rift::scene
