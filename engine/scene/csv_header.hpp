#pragma once

#include "engine/scene/csv_table.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Which columns of a CSV file are those that are asked for.
namespace rift::scene {

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
