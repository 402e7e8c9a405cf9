#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rift::study {

/// A scenario's series, column by column; an empty field is NaN, and `phase` is kept as text.
struct SeriesTable {
  std::map<std::string, std::vector<double>> column;
  std::vector<std::string> phase;

  /// The column of a name; throws std::out_of_range where there is none.
  const std::vector<double>& at(const std::string& name) const { return column.at(name); }
  bool empty() const { return phase.empty(); }
};

/// Reads a series as results::series_csv() writes it; empty where there is no such file.
SeriesTable read_series(const std::filesystem::path& path);

/// Straight line through points by least squares, and the share of the variance it explains (R^2; 1 for
/// points on a line). NaN for less than three points.
struct Line {
  double slope = 0, r_squared = 0;
};
Line line_through(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace rift::study
