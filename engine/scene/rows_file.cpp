#include "engine/scene/rows_file.hpp"

#include "engine/scene/csv_table.hpp"
#include "engine/scene/preset_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string_view>
#include <utility>

namespace rift {
namespace {

constexpr std::size_t most_told = 20;                       // defects of one file
constexpr std::size_t largest_file = std::size_t{1} << 20;  // as much as a preset may hold

using Columns = std::vector<CsvColumn>;

Value number(double x) { return {x}; }
Value list(std::vector<Value> items) { return {std::move(items)}; }

/// Rows of the columns that are there, as numbers.
Value plain_rows(const CsvTable& table) {
  std::vector<Value> rows;
  for (std::size_t r = 0; r < table.line.size(); ++r) {
    std::vector<Value> row;
    for (const std::vector<double>& column : table.column)
      if (!column.empty()) row.push_back(number(column[r]));
    rows.push_back(list(std::move(row)));
  }
  return list(std::move(rows));
}

/// The first line that is no comment and not empty.
std::string_view header_of(std::string_view text) {
  std::string_view header;
  while (!text.empty()) {
    const auto end = text.find('\n');
    header = text.substr(0, end);
    const auto first = header.find_first_not_of(" \t\r");
    if (first != std::string_view::npos && header[first] != '#') break;
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return header;
}

/// Which column the header names first tells what a critical rate is against.
std::pair<Columns, const char*> toughness_columns(std::string_view header) {
  const CsvColumn rate{"release_rate", Dimension::release_rate};
  if (header.find("position") != std::string_view::npos)
    return {{{"position", Dimension::length}, rate}, "{} m"};
  if (header.find("c_r") != std::string_view::npos) return {{{"velocity", Dimension::none}, rate}, "{} c_r"};
  return {{{"velocity", Dimension::speed}, rate}, "{} m/s"};
}

/// And of what a load curve is.
std::pair<Columns, const char*> curve_columns(std::string_view header) {
  const CsvColumn time{"time", Dimension::time};
  for (const char* force : {"grip_force", "force"})  // as `rift measure --against` has it, or shorter
    if (header.find(force) != std::string_view::npos) return {{time, {force, Dimension::force}}, "{} N"};
  return {{time, {"displacement", Dimension::length}}, "{} m"};
}

/// Rows of two, one of which says with its unit what it is.
Value rows_with_units(const CsvTable& table, std::size_t said, const char* form) {
  std::vector<Value> rows;
  for (std::size_t r = 0; r < table.line.size(); ++r) {
    std::vector<Value> row{number(table.column[0][r]), number(table.column[1][r])};
    row[said] = Value{fmt::format(fmt::runtime(form), table.column[said][r])};
    rows.push_back(list(std::move(row)));
  }
  return list(std::move(rows));
}

}  // namespace

bool names_rows_file(const Parameter& row, const Value& value) {
  const auto* name = std::get_if<std::string>(&value.held);
  if (!name) return false;
  return row.key == "crack.history" || row.key == "crack.toughness" || row.key == "loading.curve" ||
         (row.key == "crack.path" && name->ends_with(".csv"));
}

RowsFile read_rows_file(const Parameter& row, const std::string& name, const std::filesystem::path& folder) {
  RowsFile read;
  const std::filesystem::path path = folder / name;
  read.origin.file = path.string();
  const auto say = [&](int line, std::string text) {
    read.issues.push_back({path.string(), line, "", std::move(text)});
  };
  const PresetFile file = read_preset_file(path);
  if (!file.problem.empty()) return say(0, file.problem), read;
  if (file.text.size() > largest_file) return say(0, "larger than 1 MiB: thin its rows out"), read;

  CsvTable table;
  const std::string_view head = header_of(file.text);
  if (row.key == "loading.curve" && head.find("force") != head.npos && head.find("displacement") != head.npos)
    return say(0, "holds displacement and force: a load curve is of one of them"), read;
  if (row.key == "crack.toughness") {
    const auto [columns, first] = toughness_columns(head);
    table = read_csv(file.text, columns);
    if (table.problems.empty()) read.rows = rows_with_units(table, 0, first);
  } else if (row.key == "loading.curve") {
    const auto [columns, load] = curve_columns(head);
    table = read_csv(file.text, columns);
    if (table.problems.empty()) read.rows = rows_with_units(table, 1, load);
  } else {
    const Columns columns = row.key == "crack.path"
                                ? Columns{{"x", Dimension::length}, {"y", Dimension::length}}
                                : Columns{{"time", Dimension::time},
                                          {"position", Dimension::length},
                                          {"uncertainty", Dimension::length, false}};
    table = read_csv(file.text, columns);
    if (table.problems.empty()) read.rows = plain_rows(table);
  }
  for (std::size_t k = 0; k < table.problems.size() && k < most_told; ++k)
    say(table.problems[k].line, std::move(table.problems[k].text));
  if (table.problems.size() > most_told)
    say(0, fmt::format("and {} more lines like these", table.problems.size() - most_told));
  if (read.issues.empty() && table.line.empty()) say(0, "holds a header and no rows");
  read.origin.line = std::move(table.line);
  return read;
}

}  // namespace rift
