#include "studio/reports/study_report.hpp"

#include "engine/base/csv.hpp"
#include "engine/base/numbers.hpp"
#include "engine/base/text.hpp"
#include "engine/base/world_error.hpp"
#include "engine/scene/needs.hpp"
#include "engine/study/plan.hpp"
#include "engine/study/store.hpp"
#include "studio/charts/chart_script.hpp"
#include "studio/charts/curves.hpp"
#include "studio/reports/report.hpp"
#include "studio/text/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

void add_axes(std::vector<std::string>& cells, const study::AxisTexts& axes) {
  for (const auto& [name, text] : axes) cells.push_back(text);
}

std::vector<std::string> head_of(const study::AxisTexts& axes) {
  std::vector<std::string> head;
  for (const auto& [name, text] : axes) head.push_back(name);
  return head;
}

/// A field of a csv: what is no number is empty, axes and lists are one text.
std::string field_of(const Json& value) {
  if (value.is_null() || (value.is_number_float() && !std::isfinite(value.get<double>()))) return {};
  if (value.is_string()) return base::csv_field(value.get<std::string>());
  std::string text;
  if (value.is_object())
    for (const auto& [name, of_axis] : value.items())
      text += fmt::format("{}{} = {}", text.empty() ? "" : "; ", name, of_axis.get<std::string>());
  else if (value.is_array())
    for (const Json& part : value)
      text +=
          (text.empty() ? "" : " ") + (part.is_string() ? part.get<std::string>() : base::json_text(part));
  else
    text = base::json_text(value);
  return base::csv_field(text);
}

/// Rows that differ at most in the axes left out, and what they have in common.
struct RowFamily {
  study::AxisTexts axes;
  std::vector<study::SummaryRow> rows;
};

/// Rows by the axes other than `without`, families and rows in the order of the study.
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

/// Mean of a number of the rows and its standard deviation (n - 1), NaN of fewer than two; what is undefined
/// does not count.
struct MeanScatter {
  double mean, scatter;
  int count;
};
MeanScatter mean_of(const std::vector<study::SummaryRow>& rows, double study::SummaryRow::*number) {
  std::vector<double> values;
  for (const study::SummaryRow& row : rows)
    if (!std::isnan(row.*number)) values.push_back(row.*number);
  return {base::mean_of(values), base::deviation_of(values), static_cast<int>(values.size())};
}

}  // namespace

Table scenario_table(const study::StudyRows& rows) {
  Table table;
  for (const auto& row : rows) {
    if (!row) continue;
    if (table.head.empty()) {
      table.head = head_of(row->axes);
      for (const char* name :
           {"ratio_with_damping", "broberg", "error_broberg", "wall_fracture_s", "outcome"})
        table.head.emplace_back(name);
    }
    std::vector<std::string> cells;
    add_axes(cells, row->axes);
    cells.push_back(scatter_cell(row->ratio_with_damping, row->ratio_scatter));
    cells.push_back(number_cell(row->broberg, "{:.3f}"));
    cells.push_back(number_cell(row->error_broberg, "{:+.3f}"));
    cells.push_back(number_cell(row->wall_fracture_s, "{:.2f}"));
    cells.push_back(row->outcome);
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table seed_table(const study::StudyRows& rows) {
  Table table;
  const std::vector<RowFamily> found = families(rows, {"seed"});
  if (std::none_of(found.begin(), found.end(), [](const RowFamily& f) { return f.rows.size() > 1; }))
    return table;
  table.head = head_of(found.front().axes);
  for (const char* name : {"seeds", "ratio_with_damping", "broberg", "error_broberg", "wall_fracture_s"})
    table.head.emplace_back(name);
  for (const RowFamily& family : found) {
    const MeanScatter ratio = mean_of(family.rows, &study::SummaryRow::ratio_with_damping);
    std::vector<std::string> cells;
    add_axes(cells, family.axes);
    cells.push_back(std::to_string(ratio.count));
    cells.push_back(scatter_cell(ratio.mean, ratio.scatter));
    cells.push_back(number_cell(mean_of(family.rows, &study::SummaryRow::broberg).mean, "{:.3f}"));
    cells.push_back(number_cell(mean_of(family.rows, &study::SummaryRow::error_broberg).mean, "{:+.3f}"));
    cells.push_back(number_cell(mean_of(family.rows, &study::SummaryRow::wall_fracture_s).mean, "{:.2f}"));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::string left_out_text(const study::StudyRows& rows) {
  std::vector<std::string> parts;
  const auto there = std::count_if(rows.begin(), rows.end(), [](const auto& row) { return row.has_value(); });
  for (const scene::OptionalPart& part : scene::optional_parts()) {
    const auto without = std::count_if(rows.begin(), rows.end(), [&](const auto& row) {
      return row && std::find(row->left_out.begin(), row->left_out.end(), part.name) != row->left_out.end();
    });
    if (without == 0) continue;
    std::string& text = parts.emplace_back(part.name);
    std::replace(text.begin(), text.end(), '_', ' ');
    if (without < there) text += fmt::format(" ({} of {} scenarios)", without, there);
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

namespace {

/// The columns of all rows. One that not every row has, such as friction, stands where a row has it.
std::vector<std::string> columns_of(const std::vector<Json>& rows) {
  std::vector<std::string> names;
  for (const Json& row : rows) {
    auto place = names.begin();
    for (const auto& [name, value] : row.items()) {
      const auto known = std::find(names.begin(), names.end(), name);
      place = std::next(known == names.end() ? names.insert(place, name) : known);
    }
  }
  return names;
}

}  // namespace

std::string rows_csv(const std::vector<Json>& rows) {
  const std::vector<std::string> names = columns_of(rows);
  if (names.empty()) return {};
  std::string csv = fmt::format("{}\n", fmt::join(names, ","));
  for (const Json& row : rows) {
    std::string line;
    for (const std::string& name : names) line += "," + field_of(row.value(name, Json(nullptr)));
    csv += line.substr(1) + "\n";
  }
  return csv;
}

std::string study_csv(const Json& rows) {
  std::vector<Json> ordered;
  for (const Json& row : rows) {
    if (row.is_null()) continue;
    Json& to = ordered.emplace_back(Json{{"row", row.at("row")}, {"axes", row.at("axes")}});
    to.update(row);
  }
  return rows_csv(ordered);
}

namespace {

constexpr std::size_t most_families = 12, most_curves = 6;  // in a chart against velocity, against position

/// How an axis' value reads in a label; others speak for themselves: "progressive", "0.5 c_r".
std::string part_of_label(const std::string& name, const std::string& text) {
  const std::string value = escape_label(text);
  if (name == "damage_zone_ratio") return "r_l = " + value;
  if (name == "damping_alpha") return "α = " + value;
  if (name == "beta") return "β = " + value;
  if (name == "dt_fraction") return "dt = " + value + " dt_c";
  if (name == "seed") return "seed " + value;
  if (name == "elements" || name == "layers" || name == "samples") return value + " " + name;
  if (name == "relaxation" && text.find_first_not_of("0123456789.") == std::string::npos)
    return "p = " + value;
  return name == "crack_velocity" ? text : value;
}

/// What sets a scenario or a family apart: "progressive, linear, r_l = 1, seed 2".
std::string axes_label(const study::AxisTexts& axes) {
  std::string label;
  for (const auto& [name, text] : axes)
    if (text != "-") label += (label.empty() ? "" : ", ") + part_of_label(name, text);
  return label.empty() ? "rift" : label;
}

/// "name", "name_2", ... for charts that share what is too much for one.
std::string numbered(const std::string& name, std::size_t k) {
  return k == 0 ? name : fmt::format("{}_{}", name, k + 1);
}

/// Mean over the rows of one velocity, velocities ascending; no bar where there is one row only.
ChartSeries against_velocity(const RowFamily& family, int colour) {
  std::map<double, std::vector<study::SummaryRow>> by_velocity;
  for (const study::SummaryRow& row : family.rows)
    if (!std::isnan(row.crack_velocity_over_cr)) by_velocity[row.crack_velocity_over_cr].push_back(row);
  return series_of(axes_label(family.axes), ChartSeries::Style::line_points, colour, by_velocity,
                   [](const auto& at) {
                     const MeanScatter ratio = mean_of(at.second, &study::SummaryRow::ratio_with_damping);
                     return ChartPoint{at.first, ratio.mean, ratio.scatter};
                   });
}

bool has_points(const ChartSeries& series) {
  return std::any_of(series.y.begin(), series.y.end(), [](double y) { return std::isfinite(y); });
}

ChartSeries against_tip(const study::SummaryRow& row, const std::filesystem::path& csv, int colour) {
  const study::SeriesTable table = study::read_series(csv);
  if (table.empty()) throw base::WorldError("read", csv, "it holds no series");
  ChartSeries series{.label = axes_label(row.axes),
                     .x = table.at("tip_m"),
                     .y = table.at("ratio_with_damping"),
                     .colour = colour};
  for (double& x : series.x) x *= 1e3;
  return series;
}

/// Tip position up to which no echo has come back [mm]; NaN where the row does not know.
double echo_free_mm(const study::SummaryRow& row) { return 1e3 * row.echo_free_over_length * row.length_m; }

/// Ratio against crack velocity beside Broberg, Freund and the strip, mean over seeds with their scatter as
/// bars; none where the study does not vary the velocity. At most 12 series a chart.
std::vector<NamedChart> velocity_charts(const study::StudyRows& rows) {
  std::vector<NamedChart> charts;
  std::vector<ChartSeries> measured;
  for (const RowFamily& family : families(rows, {"crack_velocity", "seed"})) {
    const study::AxisTexts& axes = family.rows.front().axes;
    if (std::none_of(axes.begin(), axes.end(), [](const auto& a) { return a.first == "crack_velocity"; }))
      return charts;
    measured.push_back(against_velocity(family, static_cast<int>(measured.size() % most_families)));
  }
  std::erase_if(measured, [](const ChartSeries& series) { return !has_points(series); });
  const auto first = std::find_if(rows.begin(), rows.end(), [](const auto& row) { return row.has_value(); });
  for (std::size_t from = 0; from < measured.size(); from += most_families) {
    Chart chart{.title = "Release rate against crack velocity",
                .x_label = "crack velocity [c_r]",
                .y_label = "G_{ID} / G_{I0} [-]",
                .x_range = {.min = 0.0},
                .y_range = {.min = 0.0}};
    const auto to = std::min(measured.size(), from + most_families);
    chart.series.assign(measured.begin() + static_cast<std::ptrdiff_t>(from),
                        measured.begin() + static_cast<std::ptrdiff_t>(to));
    for (ChartSeries& reference :
         theory_curves((*first)->poisson_ratio,
                       (*first)->plane == "stress" ? theory::Plane::stress : theory::Plane::strain))
      chart.series.push_back(std::move(reference));
    charts.push_back(
        {numbered("ratio_velocity", charts.size()),
         "Release rate in the window against crack velocity; bars: standard deviation over seeds.",
         std::move(chart)});
  }
  return charts;
}

/// Ratio against tip position of each scenario. @param series  their files, by row of the study
std::vector<NamedChart> tip_charts(const study::StudyRows& rows,
                                   const std::vector<std::filesystem::path>& series) {
  std::vector<Chart> charts;
  std::vector<ChartSeries> echo;  // of each chart
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (!rows[k]) continue;
    if (charts.empty() || charts.back().series.size() == most_curves) {
      charts.push_back({.title = "Release rate against tip position",
                        .x_label = "tip position [mm]",
                        .y_label = "G_{ID} / G_{I0} [-]"});
      echo.push_back(echo_marks());
    }
    std::vector<ChartSeries>& drawn = charts.back().series;
    ChartSeries curve = against_tip(*rows[k], series[k], static_cast<int>(drawn.size()));
    if (!has_points(curve)) continue;
    mark_echo(echo.back(), curve, echo_free_mm(*rows[k]));
    drawn.push_back(std::move(curve));
  }
  std::vector<NamedChart> named;
  for (std::size_t k = 0; k < charts.size(); ++k) {
    if (charts[k].series.empty()) continue;
    if (!echo[k].x.empty()) charts[k].series.push_back(echo[k]);
    named.push_back(
        {numbered("ratio_tip", k),
         "Release rate against tip position, damping included; free of a boundary's echo up to the dot.",
         std::move(charts[k])});
  }
  return named;
}

std::vector<fs::path> series_files(const scene::Preset& preset, const simulation::BuildInfo& build,
                                   const fs::path& folder) {
  std::vector<fs::path> files;
  for (const scene::Scene& scene : study::scenes_of_study(preset))
    files.push_back(
        study::result_file(folder, study::result_key(scene, build.version)).replace_extension(".csv"));
  return files;
}

std::string timings(const study::StudyResult& result) {
  double marching = 0.0;
  std::size_t there = 0;
  for (const auto& row : result.rows)
    if (row) marching += row->wall_fracture_s, ++there;
  return fmt::format(
      "{} of {} scenarios; the cracks took {} in all, the last call {} ({} computed, {} found).", there,
      result.rows.size(), duration_text(marching), duration_text(result.wall_s), result.computed,
      result.found);
}

}  // namespace

void write_study_report(const scene::Preset& preset, const simulation::BuildInfo& build,
                        const study::StudyResult& result, const fs::path& folder) {
  std::vector<NamedChart> charts = velocity_charts(result.rows);
  for (NamedChart& chart : tip_charts(result.rows, series_files(preset, build, folder)))
    charts.push_back(std::move(chart));
  Report report{
      .title = "Study " + fs::path(preset.name).stem().string(),
      .opening = {fmt::format("Preset {}, rift {} ({}).", preset.name, build.version, build.compiler),
                  timings(result), fmt::format("Left out: {}.", left_out_text(result.rows))}};
  if (const Table seeds = seed_table(result.rows); !seeds.rows.empty())
    report.sections.push_back({"Mean and scatter over seeds", seeds});
  report.sections.push_back({"Scenarios", scenario_table(result.rows)});
  report.sections.push_back({"Charts", std::move(charts)});
  write_report(report, folder);
}

}  // namespace rift::studio
