#include "studio/reports/study_report.hpp"

#include "engine/base/files.hpp"
#include "engine/base/world_error.hpp"
#include "engine/claims/curve.hpp"
#include "engine/study/store.hpp"
#include "engine/theory/references.hpp"
#include "studio/charts/chart_script.hpp"
#include "studio/charts/curves.hpp"
#include "studio/reports/study_table.hpp"
#include "studio/text/html.hpp"
#include "studio/text/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <sstream>

namespace rift::studio {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::size_t most_families = 12, most_curves = 6;  // in a chart against velocity, against position
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

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

/// "name", "name_2", ... for charts that share what is too much for one.
std::string numbered(const std::string& name, std::size_t k) {
  return k == 0 ? name : fmt::format("{}_{}", name, k + 1);
}

ChartSeries reference(const std::string& label, const study::SummaryRow& row, double last,
                      theory::Factor (*of)(double, double, theory::Plane)) {
  ChartSeries series;
  series.label = label;
  series.colour = -1;
  const theory::Plane plane = row.at("plane") == "stress" ? theory::Plane::stress : theory::Plane::strain;
  constexpr int points = 60;
  for (int k = 1; k <= points; ++k) {
    const double v = last * k / points;
    series.x.push_back(v);
    series.y.push_back(of(v, row.at("poisson_ratio").get<double>(), plane).g);
  }
  return series;
}

/// Mean over the rows of one velocity, velocities ascending; no bar where there is one row only.
ChartSeries against_velocity(const RowFamily& family, int colour) {
  ChartSeries series;
  series.label = axes_label(family.axes);
  series.style = ChartSeries::Style::line_points;
  series.colour = colour;
  std::vector<std::pair<double, std::vector<study::SummaryRow>>> by_velocity;
  for (const study::SummaryRow& row : family.rows) {
    if (!row.at("crack_velocity_over_cr").is_number()) continue;
    const double v = row.at("crack_velocity_over_cr").get<double>();
    const auto same = std::find_if(by_velocity.begin(), by_velocity.end(),
                                   [&](const auto& entry) { return entry.first == v; });
    if (same == by_velocity.end()) {
      by_velocity.push_back({v, {row}});
    } else {
      same->second.push_back(row);
    }
  }
  std::sort(by_velocity.begin(), by_velocity.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [v, rows] : by_velocity) {
    const MeanScatter ratio = mean_of(rows, "ratio_with_damping");
    series.x.push_back(v);
    series.y.push_back(ratio.mean);
    series.error.push_back(ratio.scatter);
  }
  return series;
}

bool has_points(const ChartSeries& series) {
  return std::any_of(series.y.begin(), series.y.end(), [](double y) { return std::isfinite(y); });
}

/// The columns of a csv by name, as numbers; NaN for an empty field.
std::vector<std::vector<double>> columns(const std::string& csv, const std::vector<std::string>& names) {
  std::vector<std::vector<double>> found(names.size());
  std::vector<std::size_t> place;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> fields;
    std::istringstream parts(line + ",");
    for (std::string field; std::getline(parts, field, ',');) fields.push_back(field);
    if (place.empty()) {
      for (const std::string& name : names)
        place.push_back(
            static_cast<std::size_t>(std::find(fields.begin(), fields.end(), name) - fields.begin()));
      continue;
    }
    for (std::size_t k = 0; k < names.size(); ++k) {
      const bool given = place[k] < fields.size() && !fields[place[k]].empty();
      found[k].push_back(given ? std::strtod(fields[place[k]].c_str(), nullptr) : nan);
    }
  }
  return found;
}

ChartSeries against_tip(const study::SummaryRow& row, const std::filesystem::path& csv, int colour) {
  const auto numbers = columns(base::read_whole_file(csv), {"tip_m", "ratio_with_damping"});
  ChartSeries series;
  series.label = axes_label(row.at("axes"));
  series.x = numbers[0];
  series.y = numbers[1];
  series.colour = colour;
  for (double& x : series.x) x *= 1e3;
  return series;
}

/// Tip position up to which no echo has come back [mm]; NaN where the row does not know.
double echo_free_mm(const study::SummaryRow& row) {
  return 1e3 * study::number_in(row, "echo_free_over_length") * study::number_in(row, "length_m");
}

}  // namespace

std::string axes_label(const Json& axes) {
  std::string label;
  for (const auto& [name, text] : axes.items()) {
    if (text == "-") continue;
    label += (label.empty() ? "" : ", ") + part_of_label(name, text.get<std::string>());
  }
  return label.empty() ? "rift" : label;
}

std::vector<NamedChart> velocity_charts(const std::vector<study::SummaryRow>& rows) {
  std::vector<NamedChart> charts;
  std::vector<ChartSeries> measured;
  for (const RowFamily& family : families(rows, {"crack_velocity", "seed"})) {
    if (!family.rows.front().at("axes").contains("crack_velocity")) return charts;
    measured.push_back(against_velocity(family, static_cast<int>(measured.size() % most_families)));
  }
  std::erase_if(measured, [](const ChartSeries& series) { return !has_points(series); });
  const auto first = std::find_if(rows.begin(), rows.end(), [](const auto& row) { return !row.is_null(); });
  for (std::size_t from = 0; from < measured.size(); from += most_families) {
    NamedChart named{
        numbered("ratio_velocity", charts.size()),
        "Release rate in the window against crack velocity; bars: standard deviation over seeds.",
        {}};
    Chart& chart = named.chart;
    chart.title = "Release rate against crack velocity";
    chart.x_label = "crack velocity [c_r]";
    chart.y_label = "G_{ID} / G_{I0} [-]";
    chart.x_range = {0.0, {}};
    chart.y_range = {0.0, {}};
    chart.key_outside = measured.size() > 3;
    const auto to = std::min(measured.size(), from + most_families);
    chart.series.assign(measured.begin() + static_cast<std::ptrdiff_t>(from),
                        measured.begin() + static_cast<std::ptrdiff_t>(to));
    chart.series.push_back(reference("Broberg", *first, 1.0, theory::broberg));
    chart.series.push_back(reference("Freund", *first, 1.0, theory::freund));
    chart.series.push_back(reference("strip", *first, 1.0, theory::strip));
    charts.push_back(std::move(named));
  }
  return charts;
}

std::vector<NamedChart> tip_charts(const std::vector<study::SummaryRow>& rows,
                                   const std::vector<std::filesystem::path>& series) {
  std::vector<NamedChart> charts;
  std::vector<ChartSeries> echo;  // of each chart
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (rows[k].is_null()) continue;
    if (charts.empty() || charts.back().chart.series.size() == most_curves) {
      Chart chart;
      chart.title = "Release rate against tip position";
      chart.x_label = "tip position [mm]";
      chart.y_label = "G_{ID} / G_{I0} [-]";
      chart.key_outside = true;
      charts.push_back(
          {numbered("ratio_tip", charts.size()),
           "Release rate against tip position, damping included; free of a boundary's echo up to the dot.",
           chart});
      echo.push_back(echo_marks());
    }
    std::vector<ChartSeries>& drawn = charts.back().chart.series;
    ChartSeries curve = against_tip(rows[k], series[k], static_cast<int>(drawn.size()));
    if (!has_points(curve)) continue;
    mark_echo(echo.back(), curve, echo_free_mm(rows[k]));
    drawn.push_back(std::move(curve));
  }
  for (std::size_t k = 0; k < charts.size(); ++k)
    if (!echo[k].x.empty()) charts[k].chart.series.push_back(echo[k]);
  std::erase_if(charts, [](const NamedChart& named) { return named.chart.series.empty(); });
  return charts;
}

namespace fs = std::filesystem;
namespace {

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
  for (const study::SummaryRow& row : result.rows)
    if (!row.is_null()) marching += row.at("wall_fracture_s").get<double>(), ++there;
  return html_paragraph(
      fmt::format("{} of {} scenarios; the cracks took {} in all, the last call {} ({} computed, {} found).",
                  there, result.rows.size(), duration_text(marching), duration_text(result.wall_s),
                  result.computed, result.found));
}

std::string tables(const study::StudyResult& result) {
  std::string body;
  const Table seeds = seed_table(result.rows);
  if (!seeds.rows.empty()) body += html_section("Mean and scatter over seeds", html_table(seeds));
  return body + html_section("Scenarios", html_table(scenario_table(result.rows)));
}

}  // namespace

void write_study_report(const scene::Preset& preset, const simulation::BuildInfo& build,
                        const study::StudyResult& result, const fs::path& folder) {
  std::string figures;
  std::optional<base::WorldError> failure;
  std::vector<NamedChart> charts = velocity_charts(result.rows);
  for (NamedChart& chart : tip_charts(result.rows, series_files(preset, build, folder)))
    charts.push_back(std::move(chart));
  for (const NamedChart& named : charts) {
    try {
      figures += html_figure(draw_chart(named.chart, folder / "charts", named.name).svg_text, named.caption);
    } catch (const base::WorldError& error) {
      failure = error;
      figures += html_paragraph(fmt::format("{}: {}", named.name, error.what()));
    }
  }
  const std::string name = fs::path(preset.name).stem().string();
  std::string body =
      html_paragraph(fmt::format("Preset {}, rift {} ({}).", preset.name, build.version, build.compiler));
  body += timings(result) + tables(result) + html_section("Charts", figures);
  base::write_whole_file(folder / "report.html", html_page("Study " + name, body));
  if (failure) throw base::WorldError(*failure);
}

}  // namespace rift::studio
