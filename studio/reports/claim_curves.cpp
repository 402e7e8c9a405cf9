#include "studio/reports/claim_curves.hpp"

#include "engine/base/numbers.hpp"
#include "engine/theory/references.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace rift::studio {

ChartSeries echo_marks() { return {"first boundary reflection", {}, {}, {}, ChartSeries::Style::points, -1}; }

void mark_echo(ChartSeries& marks, const ChartSeries& curve, double echo) {
  if (curve.x.size() < 2 || !(echo >= curve.x.front() && echo <= curve.x.back())) return;
  const auto [k, part] = base::interval_at(curve.x, echo);
  marks.add(echo, curve.y[k - 1] + part * (curve.y[k] - curve.y[k - 1]));
}

namespace {

using Style = ChartSeries::Style;
using Points = std::vector<std::pair<double, double>>;  // tip position over length, value
using Rows = std::vector<study::SummaryRow>;

constexpr double half_width = 0.02, between = 0.01;  // of the length

std::map<double, Rows> rows_by_velocity(const claims::Evidence& evidence, claims::Selection selection) {
  std::map<double, Rows> rows;
  for (const study::SummaryRow& row : claims::rows_in(evidence, std::move(selection)))
    rows[row.crack_velocity_over_cr].push_back(row);
  for (auto& [v, of_v] : rows)
    std::sort(of_v.begin(), of_v.end(),
              [](const study::SummaryRow& a, const study::SummaryRow& b) { return a.seed < b.seed; });
  return rows;
}

Points fracture_points(const claims::Evidence& evidence, const study::SummaryRow& row, const char* column) {
  const study::SeriesTable table = evidence.series(row);
  Points points;
  for (std::size_t k = 0; k < table.phase.size(); ++k) {
    const double value = table.at(column)[k];
    if (table.phase[k] == "fracture" && !std::isnan(value))
      points.emplace_back(table.at("tip_m")[k] / row.length_m, value);
  }
  return points;
}

/// Mean of all values near a position, for positions that all specimens reach.
ChartSeries running_mean(const std::string& label, const std::vector<Points>& specimens) {
  ChartSeries curve{.label = label, .style = Style::line};
  double from = 0.0, to = 10.0;
  Points all;
  for (const Points& points : specimens) {
    if (points.empty()) continue;
    from = std::max(from, points.front().first), to = std::min(to, points.back().first);
    all.insert(all.end(), points.begin(), points.end());
  }
  if (all.empty()) return curve;
  for (double x = from + half_width; x <= to - half_width + 1e-9; x += between) {
    double sum = 0.0;
    int count = 0;
    for (const auto& [at, value] : all)
      if (std::abs(at - x) <= half_width) sum += value, ++count;
    if (count > 0) curve.add(x, sum / count);
  }
  return curve;
}

std::string velocity_label(double v) { return fmt::format("{:g} c_R", v); }

/// One curve of a velocity's specimens each, against the tip's position, with the moment of the first echo.
template <class CurveOf>
bool draw_velocities(Chart& chart, const claims::Evidence& evidence, claims::Selection selection,
                     const CurveOf& curve_of) {
  chart.x_label = "tip position / length [-]";
  chart.x_range = {0.0, {}};
  ChartSeries echo = echo_marks();
  for (const auto& [v, rows] : rows_by_velocity(evidence, std::move(selection))) {
    ChartSeries curve = curve_of(velocity_label(v), rows);
    if (curve.x.empty()) continue;
    mark_echo(echo, curve, rows.front().echo_free_over_length);
    chart.series.push_back(std::move(curve));
  }
  shade_in_order(chart.series);
  if (!echo.x.empty()) chart.series.push_back(std::move(echo));
  return !chart.series.empty();
}

}  // namespace

bool draw_ratio_against_position(Chart& chart, const claims::Evidence& evidence,
                                 claims::Selection selection) {
  chart.y_label = "G_{ID} / G_{I0}, mean over 0.04 L [-]";
  chart.y_range = {0.0, {}};
  return draw_velocities(chart, evidence, std::move(selection),
                         [&](const std::string& label, const Rows& rows) {
                           std::vector<Points> specimens;
                           for (const study::SummaryRow& row : rows)
                             specimens.push_back(fracture_points(evidence, row, "ratio"));
                           return running_mean(label, specimens);
                         });
}

bool draw_fracture_against_position(Chart& chart, const claims::Evidence& evidence,
                                    claims::Selection selection) {
  chart.y_label = "fracture energy [J]";
  return draw_velocities(
      chart, evidence, std::move(selection), [&](const std::string& label, const Rows& rows) {
        return series_of(label, Style::line, 0, fracture_points(evidence, rows.front(), "energy_fracture_j"),
                         [](const auto& p) {
                           return ChartPoint{p.first, p.second};
                         });
      });
}

std::vector<ChartSeries> theory_curves(double poisson_ratio, theory::Plane plane) {
  std::vector<ChartSeries> curves{{.label = "Broberg"}, {.label = "Freund"}, {.label = "strip"}};
  for (ChartSeries& curve : curves) curve.style = Style::dashed, curve.colour = -1;
  for (int k = 0; k <= 100; ++k) {
    const double v = 0.01 * k;
    curves[0].add(v, theory::broberg(v, poisson_ratio, plane).g);
    curves[1].add(v, theory::freund(v, poisson_ratio, plane).g);
    curves[2].add(v, theory::strip(v, poisson_ratio, plane).g);
  }
  return curves;
}

Chart chart_of_references(const std::string& title) {
  return {.title = title,
          .x_label = "crack velocity v / c_R, nominal c_R [-]",
          .y_label = "G_{ID} / G_{I0} [-]",
          .x_range = {0.0, 1.05},
          .y_range = {.min = 0.0},
          .series = theory_curves(0.3, theory::Plane::stress)};
}

ChartPoint mean_point(double x, const std::vector<double>& values) {
  return {x, base::mean_of(values), base::deviation_of(values)};
}

}  // namespace rift::studio
