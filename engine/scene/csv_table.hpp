#pragma once

#include "engine/scene/units.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Tables of measured numbers, as spreadsheets and cameras write them.
namespace rift {

/// A column that a table may hold.
struct CsvColumn {
  std::string_view name;  // as in its header, "time [us]"
  Dimension dimension;
  bool needed = true;
};

struct CsvProblem {
  int line = 0;  // from 1
  std::string text;
};

struct CsvTable {
  std::vector<std::vector<double>> column;  // in SI, in the order asked for; empty where it is not there
  std::vector<int> line;                    // of each row
  std::vector<CsvProblem> problems;         // in the order of the lines; the columns count only without any
};

/// No table may hold more rows: a preset holds them all.
inline constexpr std::size_t most_csv_rows = 10000;

/// Reads a header "time [us];position [mm]" and rows of as many numbers. Lines that begin with # and empty
/// ones are left out; columns are parted by semicolons, tabs or commas, whichever the header has, in this
/// order. Every defect is a problem of its line: nothing is sorted, filled in or dropped.
CsvTable read_csv(std::string_view text, std::span<const CsvColumn> columns);

}  // namespace rift
