#include "studio/reports/comparison_report.hpp"

#include "engine/base/text.hpp"
#include "engine/study/store.hpp"
#include "studio/charts/label.hpp"
#include "studio/reports/claim_curves.hpp"
#include "studio/reports/report.hpp"
#include "studio/reports/study_report.hpp"
#include "studio/text/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rift::studio {
namespace {

constexpr std::size_t most_compared = 6;  // in one chart
constexpr std::size_t page_columns = 100;

std::string label_of(const ComparedScenario& scenario, std::size_t number) {
  return fmt::format("{} {}", number + 1, escape_label(scenario.title));
}

/// The scenario's release rate along its crack.
ChartSeries along_crack(const ComparedScenario& scenario, std::size_t number) {
  const study::SeriesTable table = study::read_series(scenario.series);
  if (table.empty()) throw base::WorldError("read", scenario.series, "it holds no series");
  ChartSeries series{.label = label_of(scenario, number), .colour = static_cast<int>(number % most_compared)};
  const std::vector<double>&lane = table.at("lane"), &tip = table.at("tip_m"), &ratio = table.at("ratio");
  for (std::size_t k = 0; k < tip.size(); ++k) {
    if (lane[k] != scenario.series_lane || !(tip[k] >= 0.0) || !std::isfinite(ratio[k])) continue;
    series.x.push_back(1e3 * tip[k]);
    series.y.push_back(ratio[k]);
  }
  return series;
}

std::vector<NamedChart> tip_charts_of(const std::vector<ComparedScenario>& scenarios) {
  std::vector<NamedChart> charts;
  for (std::size_t from = 0; from < scenarios.size(); from += most_compared) {
    Chart chart{.title = "Release rate against tip position",
                .x_label = "tip position [mm]",
                .y_label = "G_{ID} / G_{I0} [-]"};
    ChartSeries echo = echo_marks();
    for (std::size_t k = from; k < std::min(scenarios.size(), from + most_compared); ++k) {
      ChartSeries curve = along_crack(scenarios[k], k);
      if (curve.x.empty()) continue;
      const results::LaneSummary& s = scenarios[k].summary;
      mark_echo(echo, curve, 1e3 * s.echo_free_over_length * s.length_m);
      chart.series.push_back(std::move(curve));
    }
    if (chart.series.empty()) continue;
    if (!echo.x.empty()) chart.series.push_back(std::move(echo));
    charts.push_back({charts.empty() ? "ratio_tip" : fmt::format("ratio_tip_{}", charts.size() + 1),
                      "Release rate against tip position, damping counted in; up to the mark no boundary "
                      "reflection has reached the tip.",
                      std::move(chart)});
  }
  return charts;
}

/// Each scenario of one velocity beside the theory's curves, with its scatter along the window.
std::vector<NamedChart> velocity_chart_of(const std::vector<ComparedScenario>& scenarios) {
  Chart chart = chart_of_references("Release rate against crack velocity");
  for (std::size_t k = 0; k < scenarios.size(); ++k) {
    const results::LaneSummary& s = scenarios[k].summary;
    if (!std::isfinite(s.crack_velocity_over_cr) || !std::isfinite(s.ratio)) continue;
    ChartSeries point{.label = label_of(scenarios[k], k),
                      .style = ChartSeries::Style::points,
                      .colour = static_cast<int>(k)};
    point.add(s.crack_velocity_over_cr, s.ratio, s.ratio_scatter);
    chart.series.push_back(std::move(point));
  }
  const bool any = std::any_of(chart.series.begin(), chart.series.end(), [](const ChartSeries& series) {
    return series.style == ChartSeries::Style::points;
  });
  if (!any || scenarios.size() > most_compared) return {};
  return {
      {"ratio_velocity", "Release rate in the window; the bars are the scatter along it.", std::move(chart)}};
}

}  // namespace

void write_comparison_report(const Comparison& comparison, const std::filesystem::path& folder) {
  const std::vector<nlohmann::ordered_json> rows = comparison_rows(comparison.scenarios);
  std::vector<NamedChart> charts = velocity_chart_of(comparison.scenarios);
  for (NamedChart& chart : tip_charts_of(comparison.scenarios)) charts.push_back(std::move(chart));
  write_report(
      {.title = fmt::format("{} scenarios side by side", comparison.scenarios.size()),
       .made = {comparison.command, comparison.build, {}},
       .files = {{"summary.json", base::json_text(nlohmann::ordered_json{{"scenarios", rows}}, 2) + "\n"},
                 {"table.csv", rows_csv(rows)}},
       .sections = {{"Numbers", html_lines(comparison_text(comparison.scenarios, page_columns, false))},
                    {"Charts", std::move(charts)}}},
      folder);
}

}  // namespace rift::studio
