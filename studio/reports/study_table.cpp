#include "studio/reports/study_table.hpp"

#include "engine/base/numbers.hpp"
#include "engine/base/text.hpp"
#include "studio/text/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift::studio {
namespace {

using Json = nlohmann::ordered_json;

std::string with_scatter(double value, double scatter) {
  if (!std::isfinite(value)) return "-";
  return std::isfinite(scatter) ? fmt::format("{:.3f} ± {:.3f}", value, scatter)
                                : fmt::format("{:.3f}", value);
}

double number(const Json& row, const char* name) {
  return row.at(name).is_number() ? row.at(name).get<double>() : std::numeric_limits<double>::quiet_NaN();
}

void add_axes(std::vector<std::string>& cells, const Json& axes) {
  for (const auto& [name, text] : axes.items()) cells.push_back(text.get<std::string>());
}

std::vector<std::string> head_of(const Json& axes) {
  std::vector<std::string> head;
  for (const auto& [name, text] : axes.items()) head.push_back(name);
  return head;
}

/// A field of a csv: text is quoted where it has to be, axes and lists are one text.
std::string csv_field(const Json& value) {
  if (value.is_null()) return {};
  std::string text;
  if (value.is_string()) {
    text = value.get<std::string>();
  } else if (value.is_object()) {
    for (const auto& [name, of_axis] : value.items())
      text += fmt::format("{}{} = {}", text.empty() ? "" : "; ", name, of_axis.get<std::string>());
  } else if (value.is_array()) {
    for (const Json& part : value) text += (text.empty() ? "" : " ") + base::json_text(part);
  } else {
    return base::json_text(value);
  }
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::vector<RowFamily> families(const std::vector<study::SummaryRow>& rows,
                                const std::vector<std::string>& without) {
  std::vector<RowFamily> found;
  for (const study::SummaryRow& row : rows) {
    if (row.is_null()) continue;
    Json axes = row.at("axes");
    for (const std::string& name : without) axes.erase(name);
    const auto same = std::find_if(found.begin(), found.end(), [&](const auto& f) { return f.axes == axes; });
    if (same == found.end()) {
      found.push_back({axes, {row}});
    } else {
      same->rows.push_back(row);
    }
  }
  return found;
}

MeanScatter mean_of(const std::vector<study::SummaryRow>& rows, const std::string& name) {
  std::vector<double> values;
  for (const study::SummaryRow& row : rows)
    if (row.at(name).is_number()) values.push_back(row.at(name).get<double>());
  return {base::mean_of(values), base::deviation_of(values), static_cast<int>(values.size())};
}

Table scenario_table(const std::vector<study::SummaryRow>& rows) {
  Table table;
  for (const study::SummaryRow& row : rows) {
    if (row.is_null()) continue;
    if (table.head.empty()) {
      table.head = head_of(row.at("axes"));
      for (const char* name :
           {"ratio_with_damping", "broberg", "error_broberg", "wall_fracture_s", "outcome"})
        table.head.emplace_back(name);
    }
    std::vector<std::string> cells;
    add_axes(cells, row.at("axes"));
    cells.push_back(with_scatter(number(row, "ratio_with_damping"), number(row, "ratio_scatter")));
    cells.push_back(number_cell(number(row, "broberg"), "{:.3f}"));
    cells.push_back(number_cell(number(row, "error_broberg"), "{:+.3f}"));
    cells.push_back(number_cell(number(row, "wall_fracture_s"), "{:.2f}"));
    cells.push_back(row.at("outcome").get<std::string>());
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table seed_table(const std::vector<study::SummaryRow>& rows) {
  Table table;
  const std::vector<RowFamily> found = families(rows, {"seed"});
  if (std::none_of(found.begin(), found.end(), [](const RowFamily& f) { return f.rows.size() > 1; }))
    return table;
  table.head = head_of(found.front().axes);
  for (const char* name : {"seeds", "ratio_with_damping", "broberg", "error_broberg", "wall_fracture_s"})
    table.head.emplace_back(name);
  for (const RowFamily& family : found) {
    const MeanScatter ratio = mean_of(family.rows, "ratio_with_damping");
    std::vector<std::string> cells;
    add_axes(cells, family.axes);
    cells.push_back(std::to_string(ratio.count));
    cells.push_back(with_scatter(ratio.mean, ratio.scatter));
    cells.push_back(number_cell(mean_of(family.rows, "broberg").mean, "{:.3f}"));
    cells.push_back(number_cell(mean_of(family.rows, "error_broberg").mean, "{:+.3f}"));
    cells.push_back(number_cell(mean_of(family.rows, "wall_fracture_s").mean, "{:.2f}"));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::string study_csv(const std::vector<study::SummaryRow>& rows) {
  std::string out;
  for (const study::SummaryRow& row : rows) {
    if (row.is_null()) continue;
    std::string head = "row,axes", line = csv_field(row.at("row")) + "," + csv_field(row.at("axes"));
    for (const auto& [name, value] : row.items()) {
      if (name == "row" || name == "axes") continue;
      head += "," + name;
      line += "," + csv_field(value);
    }
    if (out.empty()) out = head + "\n";
    out += line + "\n";
  }
  return out;
}

}  // namespace rift::studio
