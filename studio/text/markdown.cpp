#include "studio/text/markdown.hpp"

#include <vector>

namespace rift::studio {
namespace {

std::string cell(const std::string& text) {
  std::string out;
  for (char c : text) out += c == '|' ? "\\|" : c == '\n' ? " " : std::string(1, c);
  return out;
}

std::string row_of(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (const std::string& text : cells) row += " " + cell(text) + " |";
  return row + "\n";
}

}  // namespace

std::string markdown_table(const Table& table) {
  std::string text = row_of(table.head) + row_of(std::vector<std::string>(table.head.size(), "---"));
  for (const auto& row : table.rows) text += row_of(row);
  return text;
}

}  // namespace rift::studio
