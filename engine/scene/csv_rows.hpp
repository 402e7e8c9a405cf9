#pragma once

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

}  // namespace rift::scene
