#include "studio/workbench/study_table.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace rift::studio {
namespace {

std::size_t column_axis(const scene::StudyRow& row) {
  for (std::size_t k = 0; k < row.axes.size(); ++k)
    if (row.axes[k].first == "crack_velocity") return k;
  return row.axes.size() - 1;
}

/// "progressive linear r_l 4 seed 1": words speak for themselves, numbers by the name of their axis.
std::string row_name(const scene::StudyRow& row, std::size_t without) {
  std::string name;
  for (std::size_t k = 0; k < row.axes.size(); ++k) {
    const auto& [axis, value] = row.axes[k];
    if (k == without || value == "-") continue;
    const bool number = value.find_first_not_of("0123456789.e-+") == std::string::npos;
    const std::string label = axis == "damage_zone_ratio" ? "r_l" : axis == "damping_alpha" ? "alpha" : axis;
    name += (name.empty() ? "" : " ") + (number ? label + " " + value : value);
  }
  return name;
}

/// Where the text stands in the list, at its end where it was not there.
int place_in(std::vector<std::string>& list, const std::string& text) {
  const auto found = std::find(list.begin(), list.end(), text);
  const int place = static_cast<int>(found - list.begin());
  if (found == list.end()) list.push_back(text);
  return place;
}

}  // namespace

StudyTable::StudyTable(const scene::Preset& preset) {
  const std::size_t varied = column_axis(preset.study.front());
  axis = preset.study.front().axes[varied].first;
  for (std::size_t k = 0; k < preset.study.size(); ++k) {
    const scene::StudyRow& scenario = preset.study[k];
    const int row = place_in(rows, row_name(scenario, varied));
    row_of.push_back(row);
    cells[{row, place_in(columns, scenario.axes[varied].second)}] = k;
  }
}

char32_t letter_of_row(int row) {
  constexpr std::u32string_view letters = U"abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
  return letters[static_cast<std::size_t>(row) % letters.size()];
}

std::vector<ErrorPoint> error_points(const StudyTable& table, const StudyResults& results) {
  std::vector<ErrorPoint> points;
  for (std::size_t k = 0; k < results.size(); ++k) {
    if (!results[k]) continue;
    const double seconds = results[k]->cost_s, error = std::abs(results[k]->error_broberg);
    if (seconds > 0 && error > 0)
      points.push_back({table.row_of[k], {std::log10(seconds), std::log10(error)}});
  }
  return points;
}

std::vector<std::array<double, 2>> efficient_front(std::vector<ErrorPoint> points) {
  std::sort(points.begin(), points.end(),
            [](const ErrorPoint& a, const ErrorPoint& b) { return a.at < b.at; });
  std::vector<std::array<double, 2>> front;
  for (const ErrorPoint& point : points)
    if (front.empty() || point.at[1] < front.back()[1]) front.push_back(point.at);
  return front;
}

}  // namespace rift::studio
