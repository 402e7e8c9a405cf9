#include "engine/scene/csv_rows.hpp"

#include "engine/scene/wording.hpp"

#include <algorithm>

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

}  // namespace rift::scene
