#pragma once

#include "engine/scene/units.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rift::scene {

/// One row of a CSV text, taken apart.
struct CsvRow {
  int line = 0;                   // where it begins, from 1
  std::vector<std::string> cell;  // without blanks at their ends, quotes taken off
  bool is_comment = false;        // its first cell begins with #
  bool is_unclosed = false;       // a quote opens in it and never closes
};

/// Takes a CSV text apart, row by row   [RFC 4180]. A cell in quotes may hold separators, line ends and
/// doubled quotes; a quote within a cell that does not begin with one is a letter as any other.
class CsvRows {
 public:
  /// @param[in] line  the number of the text's first line
  CsvRows(std::string_view text, int line, char separator)
      : left_(text), line_(line), separator_(separator) {}

  /// The next row, an empty one too; false at the end of the text.
  bool next(CsvRow& row);

  [[nodiscard]] std::string_view left() const { return left_; }
  [[nodiscard]] int line() const { return line_; }  // of what is left

 private:
  void take_quoted(std::string& cell, bool& is_unclosed);
  void skip_blanks();

  std::string_view left_;
  int line_;
  char separator_;
};

/// Whether a row holds nothing but separators.
bool is_blank(const CsvRow& row);

// Tables of measured numbers, as spreadsheets, cameras and instruments write them.

/// Whether a column has to be there; of those that are `one_of`, exactly one has to.
enum class CsvNeed { needed, optional, one_of };

/// A column that a table may hold.
struct CsvColumn {
  std::string_view name;  // in small letters, as in its header "time [us]"
  Dimension dimension;
  CsvNeed need = CsvNeed::needed;
  std::string_view symbol = {};      // that may stand for the name, "t"
  std::string_view plain_unit = {};  // one more unit, whose numbers are left as they are: "c_r"
};

struct CsvProblem {
  int line = 0;  // from 1
  std::string text;
};

struct CsvTable {
  std::vector<std::vector<double>> column;  // in SI, in the order asked for; empty where it is not there
  std::vector<std::string> unit;            // that each was written in, in the order asked for
  std::vector<std::string> beside;          // names of columns that nobody asked for
  std::vector<int> line;                    // of each row
  std::vector<CsvProblem> problems;         // in the order of the lines; the columns count only without any
};

/// No table may hold more rows, and none of more than so many bytes is read.
inline constexpr std::size_t most_csv_rows = 1000000;
inline constexpr std::size_t largest_csv = std::size_t{64} << 20;

/// Reads a header and rows of numbers.
/// The header is the first row that names all columns which have to be there, in any order and in capitals or
/// small letters, each with its unit ("time [us]", "Time (us)", "t / us", "time_us") or with the units in the
/// row below; rows before it, at most 100, and columns beside are left out. Columns are parted by semicolons,
/// tabs, commas or bars, as "sep=;" in the first line or the header says. Lines that begin with # and rows
/// without anything in them are left out. Every other defect is a problem of its line, one that all rows
/// share (another encoding, decimal commas, times of day) is named once: nothing is sorted, filled in or
/// dropped.
/// @param[in] most_rows  more are a problem
CsvTable read_csv(std::string_view text, std::span<const CsvColumn> columns,
                  std::size_t most_rows = most_csv_rows);

// Which columns of a file are those that are asked for.

/// What a cell of a header says: "Time [us]" is time in us.
struct CsvTitle {
  std::string name;                   // in small letters, blanks within as _
  std::string unit;                   // empty where it has none
  std::optional<std::size_t> wanted;  // the column asked for that it is
};

struct CsvHeader {
  std::vector<CsvTitle> title;  // of each column of the file; without the empty ones at the end
  int line = 0;                 // from 1
  char separator = ';';
  std::string_view below;  // what follows the header
  int below_line = 0;      // the number of its first line
  bool is_found = false;   // false where the text holds no row at all

  /// The column of the file that holds what is asked for at `wanted`.
  [[nodiscard]] std::optional<std::size_t> column_of(std::size_t wanted) const;
};

/// The first row that names all columns which have to be there, or the row that names the most.
/// @param[in] text  without a byte order mark
CsvHeader find_csv_header(std::string_view text, std::span<const CsvColumn> columns);

/// What is wrong with the names of a header: columns that are missing, written twice or nearly right.
std::vector<std::string> header_problems(const CsvHeader& header, std::span<const CsvColumn> columns);

/// "time [ms]", a header that would be read.
std::string example_of(const CsvColumn& column);
std::string examples_of(std::span<const CsvColumn> columns);

}  // namespace rift::scene
