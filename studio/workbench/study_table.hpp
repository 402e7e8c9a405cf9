#pragma once

#include "engine/results/lane_summary.hpp"
#include "engine/scene/preset.hpp"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rift::studio {

/// The scenarios of a study as a table: a column for each value of one axis, a row for each combination of
/// the others.
struct StudyTable {
  std::string axis;  // of the columns: the velocity where it is varied, else the last one
  std::vector<std::string> columns, rows;
  std::vector<int> row_of;                           // by scenario
  std::map<std::pair<int, int>, std::size_t> cells;  // the scenario of a row and a column

  explicit StudyTable(const scene::Preset& preset);
};

/// A row's letter: a to z, A to Z, and from the beginning again.
[[nodiscard]] char32_t letter_of_row(int row);

using StudyResults = std::vector<std::optional<results::LaneSummary>>;

/// What a scheme costs against what it is worth: run time [s] and |difference to Broberg|, as log10 of each.
struct ErrorPoint {
  int row = 0;  // of the table
  std::array<double, 2> at{};
};
[[nodiscard]] std::vector<ErrorPoint> error_points(const StudyTable& table, const StudyResults& results);

/// The efficient points by run time: none has both a smaller error and a shorter run time.
[[nodiscard]] std::vector<std::array<double, 2>> efficient_front(std::vector<ErrorPoint> points);

}  // namespace rift::studio
