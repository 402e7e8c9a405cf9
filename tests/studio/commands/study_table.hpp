#pragma once

#include "tests/studio/run_rift.hpp"

#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace rift::studio {

/// table.csv by row and name, without what depends on when and beside what it was computed.
inline std::vector<std::map<std::string, std::string>> table_in(const std::filesystem::path& folder) {
  const std::set<std::string> passing{
      "lanes",  "threads",           "element_steps_per_s", "beam_steps_per_s",
      "cost_s", "memory_peak_bytes", "packing_from_cache",  "prestress_from_cache"};
  std::vector<std::map<std::string, std::string>> rows;
  std::vector<std::string> names;
  std::istringstream lines(read_text(folder / "table.csv"));
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> fields;
    std::istringstream parts(line);
    for (std::string field; std::getline(parts, field, ',');) fields.push_back(field);
    if (names.empty()) {
      names = fields;
      continue;
    }
    rows.emplace_back();
    for (std::size_t k = 0; k < names.size() && k < fields.size(); ++k)
      if (!names[k].starts_with("wall_") && !passing.contains(names[k])) rows.back()[names[k]] = fields[k];
  }
  return rows;
}

}  // namespace rift::studio
