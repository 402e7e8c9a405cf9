#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rift::studio {

/// A table as it is read: texts, equally many in each row. Terminal and report show the same one.
struct Table {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};

/// The text as a heading: escaped, bold where `color`.
std::string heading(std::string_view text, bool color);

/// Columns two spaces apart under their heads, numbers (with their ±) to the right; the head bold where
/// `color`. What a cell holds is escaped.
std::string plain_table(const Table& table, bool color);

/// The same, its last column in lines so that nothing is wider than `width` letters; as it is for a width of
/// 0.
std::string plain_table(const Table& table, bool color, std::size_t width);

/// The text in lines of at most `width` letters, broken at its blanks; a longer word is a line by itself.
std::vector<std::string> wrapped(std::string_view text, std::size_t width);

/// A number by fmt's format, "-" where it is none or infinite.
std::string number_cell(double value, std::string_view format = "{:.4g}");

/// "0.566 ± 0.088"; without the scatter where there is none, "-" without the value.
std::string scatter_cell(double value, double scatter, int digits = 3);

/// A line of a list: "  label                 content".
std::string label_line(std::string_view label, std::string_view content, int width = 22);

/// Letters that a UTF-8 text takes on a terminal.
std::size_t width_of(const std::string& text);

/// Whether a cell is set to the right: "0.5", "-0.012", "0.566 ± 0.088", "-".
bool is_numeric(const std::string& cell);

}  // namespace rift::studio
