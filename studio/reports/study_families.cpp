#include "studio/reports/study_families.hpp"

#include "engine/base/numbers.hpp"
#include "studio/charts/label.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>

namespace rift::studio {
namespace {

/// Velocities are written "0.5 c_r" in presets; the symbol is c_R.
std::string velocity_text(std::string text) {
  if (const auto at = text.find("c_r"); at != std::string::npos) text.replace(at, 3, "c_R");
  return text;
}

/// How an axis' value reads in a label; others speak for themselves: "progressive", "0.5 c_R".
std::string part_of_label(const std::string& name, const std::string& text) {
  const std::string value = escape_label(text);
  if (name == "damage_zone_ratio") return "r_l = " + value;
  if (name == "damping_alpha") return "α = " + value;
  if (name == "beta") return "β = " + value;
  if (name == "dt_fraction") return value + " of critical";
  if (name == "seed") return "seed " + value;
  if (name == "elements" || name == "layers" || name == "samples") return value + " " + name;
  if (name == "relaxation" && std::isfinite(number_of_value(text))) return "p = " + value;
  return name == "crack_velocity" ? velocity_text(text) : value;
}

}  // namespace

std::vector<RowFamily> families(const study::StudyRows& rows, const std::vector<std::string>& without) {
  std::vector<RowFamily> found;
  for (const auto& row : rows) {
    if (!row) continue;
    study::AxisTexts axes = row->axes;
    std::erase_if(axes, [&](const auto& axis) {
      return std::find(without.begin(), without.end(), axis.first) != without.end();
    });
    const auto same = std::find_if(found.begin(), found.end(), [&](const auto& f) { return f.axes == axes; });
    (same == found.end() ? found.emplace_back(RowFamily{axes, {}}) : *same).rows.push_back(*row);
  }
  return found;
}

MeanScatter mean_over(const std::vector<study::SummaryRow>& rows, double study::SummaryRow::*number) {
  std::vector<double> values;
  for (const study::SummaryRow& row : rows)
    if (!std::isnan(row.*number)) values.push_back(row.*number);
  return {base::mean_of(values), base::deviation_of(values), static_cast<int>(values.size())};
}

std::string value_of_axis(const study::AxisTexts& axes, std::string_view name) {
  const auto found = std::find_if(axes.begin(), axes.end(), [&](const auto& a) { return a.first == name; });
  return found == axes.end() ? "-" : found->second;
}

double number_of_value(const std::string& text) {
  double number = std::numeric_limits<double>::quiet_NaN();
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

std::vector<std::string> values_of_axis(const study::StudyRows& rows, const std::string& name) {
  std::vector<std::string> values;
  for (const auto& row : rows) {
    if (!row) continue;
    const std::string value = value_of_axis(row->axes, name);
    if (value != "-" && std::find(values.begin(), values.end(), value) == values.end())
      values.push_back(value);
  }
  const auto is_number = [](const std::string& text) { return std::isfinite(number_of_value(text)); };
  if (std::all_of(values.begin(), values.end(), is_number))
    std::stable_sort(values.begin(), values.end(), [](const std::string& a, const std::string& b) {
      return number_of_value(a) < number_of_value(b);
    });
  return values;
}

std::vector<std::string> varied_axes(const study::StudyRows& rows) {
  const auto first = std::find_if(rows.begin(), rows.end(), [](const auto& row) { return row.has_value(); });
  std::vector<std::string> names;
  if (first == rows.end()) return names;
  for (const auto& [name, text] : (*first)->axes)
    if (std::any_of(first, rows.end(),
                    [&](const auto& row) { return row && value_of_axis(row->axes, name) != text; }))
      names.push_back(name);
  return names;
}

bool is_ordered_axis(const study::StudyRows& rows, const std::string& name) {
  const std::vector<std::string> values = values_of_axis(rows, name);
  return name != "seed" && values.size() > 1 &&
         std::all_of(values.begin(), values.end(),
                     [](const std::string& text) { return std::isfinite(number_of_value(text)); });
}

std::string axis_in_words(const std::string& name) {
  static const std::map<std::string, std::string> words{{"damage_zone_ratio", "r_l"},
                                                        {"damping_alpha", "α"},
                                                        {"damping_region", "damped beams"},
                                                        {"crack_velocity", "v"},
                                                        {"beta", "β"},
                                                        {"dt_fraction", "step over critical"},
                                                        {"prestress_method", "pre-stress"},
                                                        {"seed", "specimen (seed)"}};
  const auto found = words.find(name);
  return found == words.end() ? name : found->second;
}

std::string axes_label(const study::AxisTexts& axes) {
  std::string label;
  for (const auto& [name, text] : axes)
    if (text != "-") label += (label.empty() ? "" : ", ") + part_of_label(name, text);
  return label.empty() ? "rift" : label;
}

}  // namespace rift::studio
