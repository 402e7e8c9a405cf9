#include "engine/scene/rows_file.hpp"

#include "engine/scene/csv_table.hpp"
#include "engine/scene/preset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <utility>

namespace rift::scene {
namespace {

// The rows stand in the effective preset, which a run keeps and reads again.
constexpr std::size_t most_preset_rows = 100000, most_path_points = 10000;

constexpr CsvColumn time_column{"time", Dimension::time, CsvNeed::needed, "t"};
constexpr std::array history_columns{time_column,
                                     CsvColumn{"position", Dimension::length, CsvNeed::needed, "a"},
                                     CsvColumn{"uncertainty", Dimension::length, CsvNeed::optional}};
constexpr std::array path_columns{CsvColumn{"x", Dimension::length}, CsvColumn{"y", Dimension::length}};
constexpr std::array toughness_columns{CsvColumn{"position", Dimension::length, CsvNeed::one_of},
                                       CsvColumn{"velocity", Dimension::speed, CsvNeed::one_of, {}, "c_r"},
                                       CsvColumn{"release_rate", Dimension::release_rate}};
constexpr std::array load_columns{time_column, CsvColumn{"displacement", Dimension::length, CsvNeed::one_of},
                                  CsvColumn{"force", Dimension::force, CsvNeed::one_of},
                                  CsvColumn{"grip_force", Dimension::force, CsvNeed::one_of}};

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

/// Rows of two columns; the text of the one that says with its unit what the rows are.
Value rows_with_units(const CsvTable& table, std::size_t first, std::size_t second, std::size_t said,
                      const char* form) {
  std::vector<Value> rows;
  for (std::size_t r = 0; r < table.line.size(); ++r) {
    const double one = table.column[first][r], other = table.column[second][r];
    std::vector<Value> row{number(one), number(other)};
    const bool is_first = said == first;
    row[is_first ? 0 : 1] = Value{fmt::format(fmt::runtime(form), is_first ? one : other)};
    rows.push_back(list(std::move(row)));
  }
  return list(std::move(rows));
}

/// What a critical rate is against tells the column that is there.
Value toughness_rows(const CsvTable& table) {
  if (!table.column[0].empty()) return rows_with_units(table, 0, 2, 0, "{} m");
  return rows_with_units(table, 1, 2, 1, table.unit[1] == "c_r" ? "{} c_r" : "{} m/s");
}

Value load_rows(const CsvTable& table) {
  for (const std::size_t force : {2, 3})
    if (!table.column[force].empty()) return rows_with_units(table, 0, force, force, "{} N");
  return rows_with_units(table, 0, 1, 1, "{} m");
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
  const PresetFile file = read_preset_file(path, largest_csv);
  if (!file.problem.empty()) return say(0, file.problem), read;
  if (file.text.size() > largest_csv) return say(0, "larger than 64 MiB: thin its rows out"), read;

  const auto table_of = [&](std::span<const CsvColumn> columns, std::size_t most_rows) {
    return read_csv(file.text, columns, most_rows);
  };
  const bool toughness = row.key == "crack.toughness", load = row.key == "loading.curve",
             points = row.key == "crack.path";
  CsvTable table = toughness ? table_of(toughness_columns, most_preset_rows)
                   : load    ? table_of(load_columns, most_preset_rows)
                   : points  ? table_of(path_columns, most_path_points)
                             : table_of(history_columns, most_preset_rows);
  for (CsvProblem& problem : table.problems) say(problem.line, std::move(problem.text));
  if (!read.issues.empty()) return read;
  if (table.line.empty()) return say(0, "holds a header and no rows"), read;
  read.rows = toughness ? toughness_rows(table) : load ? load_rows(table) : plain_rows(table);
  read.origin.line = std::move(table.line);
  return read;
}

}  // namespace rift::scene
