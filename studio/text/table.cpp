#include "studio/text/table.hpp"

#include "engine/base/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rift::studio {
namespace {

/// A column is set to the right if all its cells are numbers.
bool is_numeric_column(const Table& table, std::size_t column) {
  return std::all_of(table.rows.begin(), table.rows.end(),
                     [&](const auto& row) { return is_numeric(row[column]); });
}

Table escaped_cells(Table table) {
  for (std::string& cell : table.head) cell = base::escaped(cell);
  for (auto& row : table.rows)
    for (std::string& cell : row) cell = base::escaped(cell);
  return table;
}

std::string line_of(const std::vector<std::string>& cells, const std::vector<std::size_t>& width,
                    const std::vector<char>& to_the_right) {
  std::string line;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const std::string space(width[k] - width_of(cells[k]), ' ');
    line += (k > 0 ? "  " : "") + (to_the_right[k] ? space + cells[k] : cells[k] + space);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

}  // namespace

std::string heading(std::string_view text, bool color) {
  const std::string harmless = base::escaped(text);
  return color ? fmt::format("\033[1m{}\033[0m", harmless) : harmless;
}

std::string number_cell(double value, std::string_view format) {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "-";
}

std::string scatter_cell(double value, double scatter, int digits) {
  if (!std::isfinite(value)) return "-";
  return std::isfinite(scatter) ? fmt::format("{0:.{2}f} ± {1:.{2}f}", value, scatter, digits)
                                : fmt::format("{:.{}f}", value, digits);
}

std::string label_line(std::string_view label, std::string_view content, int width) {
  const bool fits = static_cast<int>(base::count_letters(label)) < width;
  return fmt::format("  {:<{}}{}{}\n", label, width, fits ? "" : "  ", content);
}

std::size_t width_of(const std::string& text) { return base::count_letters(text); }

bool is_numeric(const std::string& cell) {
  constexpr std::string_view of_numbers = "0123456789.+-e \xC2\xB1";
  return cell.find_first_not_of(of_numbers) == std::string::npos;
}

std::string plain_table(const Table& raw, bool color) {
  const Table table = escaped_cells(raw);
  std::vector<std::size_t> width;
  std::vector<char> to_the_right;
  for (std::size_t k = 0; k < table.head.size(); ++k) {
    width.push_back(width_of(table.head[k]));
    for (const auto& row : table.rows) width[k] = std::max(width[k], width_of(row[k]));
    to_the_right.push_back(is_numeric_column(table, k));
  }
  std::string out = heading(line_of(table.head, width, to_the_right), color) + "\n";
  for (const auto& row : table.rows) out += line_of(row, width, to_the_right) + "\n";
  return out;
}

namespace {

/// Letters of the columns before the last and of what parts them from it.
std::size_t width_before_last(const Table& table) {
  std::size_t sum = 0;
  for (std::size_t k = 0; k + 1 < table.head.size(); ++k) {
    std::size_t widest = width_of(table.head[k]);
    for (const auto& row : table.rows) widest = std::max(widest, width_of(row[k]));
    sum += widest + 2;
  }
  return sum;
}

}  // namespace

std::string plain_table(const Table& raw, bool color, std::size_t width) {
  constexpr std::size_t narrowest = 20;
  if (width == 0) return plain_table(raw, color);
  const Table table = escaped_cells(raw);
  const std::size_t before = width_before_last(table);
  const std::size_t last = width > before + narrowest ? width - before : narrowest;
  Table in_lines{table.head, {}};
  for (const auto& row : table.rows) {
    std::vector<std::string> lines = wrapped(row.back(), last);
    if (lines.empty()) lines.emplace_back();
    for (std::size_t k = 0; k < lines.size(); ++k) {
      std::vector<std::string>& cells = in_lines.rows.emplace_back(row.size());
      if (k == 0) cells = row;
      cells.back() = lines[k];
    }
  }
  return plain_table(in_lines, color);
}

std::vector<std::string> wrapped(std::string_view text, std::size_t width) {
  std::vector<std::string> lines;
  while (true) {
    const std::size_t begin = text.find_first_not_of(' ');
    if (begin == std::string_view::npos) return lines;
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word(text.substr(begin, end - begin));
    if (!lines.empty() && width_of(lines.back()) + 1 + width_of(word) <= width)
      lines.back() += " " + word;
    else
      lines.push_back(word);
    text.remove_prefix(end);
  }
}

}  // namespace rift::studio
