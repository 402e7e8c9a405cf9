#include "engine/base/numbers.hpp"
#include "engine/base/student.hpp"
#include "engine/claims/broberg_problem.hpp"
#include "engine/claims/lattice_efficiency.hpp"
#include "studio/reports/claim_curves.hpp"
#include "studio/reports/reproduction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <set>

namespace rift::studio {
namespace {

using Style = ChartSeries::Style;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// The cells' values over r_l (columns) and p (rows).
HeatMap map_chart(const std::vector<claims::MapCell>& cells, const std::string& title,
                  const std::function<double(const claims::MapCell&)>& value) {
  std::set<double> zones, powers;
  for (const claims::MapCell& cell : cells) zones.insert(cell.zone), powers.insert(cell.relaxation);
  HeatMap map{.title = title,
              .x_label = "length of the damage zone r_l [mean radii]",
              .y_label = "power p of the relaxation [-]",
              .value_label = "|G_{ID}/G_{I0} - Broberg| [-]",
              .x = {zones.begin(), zones.end()},
              .y = {powers.begin(), powers.end()},
              .value = std::vector<double>(zones.size() * powers.size(), nothing),
              .text = std::vector<std::string>(zones.size() * powers.size()),
              .value_range = {}};
  for (const claims::MapCell& cell : cells) {
    const auto column = std::distance(zones.begin(), zones.find(cell.zone));
    const auto row = std::distance(powers.begin(), powers.find(cell.relaxation));
    const std::size_t at = static_cast<std::size_t>(row) * zones.size() + static_cast<std::size_t>(column);
    map.value[at] = value(cell);
    map.text[at] = fmt::format("{:.2f}", map.value[at]);
  }
  return map;
}

double distance_at(const claims::MapCell& cell, double v) {
  for (std::size_t k = 0; k < cell.v.size(); ++k)
    if (std::abs(cell.v[k] - v) < 1e-9) return cell.distance[k];
  return nothing;
}

std::vector<NamedChart> maps(const claims::Evidence& evidence) {
  const std::vector<claims::MapCell> cells = claims::map_of(evidence);
  if (cells.empty()) return {};
  const std::string title = "Difference to Broberg", schemes = scheme_text(evidence.rows);
  std::vector<NamedChart> charts{
      {"beyond_map",
       "Difference to Broberg over relaxation and damage zone, mean over the velocities" + schemes + ".",
       map_chart(cells, title + ", mean over the velocities",
                 [](const claims::MapCell& cell) { return base::mean_of(cell.distance); })}};
  for (const double v : cells.front().v)
    charts.push_back(
        {fmt::format("beyond_map_{:02.0f}", 10.0 * v),
         fmt::format("Difference to Broberg at {:g} c_R over relaxation and damage zone{}; the colours "
                     "reach over this map's own values.",
                     v, schemes),
         map_chart(cells, fmt::format("{} at {:g} c_R", title, v),
                   [v](const claims::MapCell& cell) { return distance_at(cell, v); })});
  return charts;
}

ChartSeries efficiency_series(const std::string& label, const std::vector<claims::EfficiencyPoint>& points,
                              int colour) {
  return series_of(label, Style::line_points, colour, points,
                   [](const claims::EfficiencyPoint& p) { return mean_point(p.v, p.ratio); });
}

constexpr const char* efficiency_label = "G_{ID} / G_{I0} = η [-]";

Chart efficiency_against_velocity(const std::string& title) {
  Chart chart = chart_of_references(title);
  chart.y_label = efficiency_label;
  return chart;
}

/// The efficiency over r_l, a curve per velocity.
Chart efficiency_against_zone(const claims::Evidence& evidence) {
  Chart chart{.title = "Lattice efficiency of a steady strip",
              .x_label = "length of the damage zone r_l [mean radii]",
              .y_label = efficiency_label,
              .y_range = {0.0, 1.1},
              .log_x = true};
  std::map<double, ChartSeries> curves;
  const std::vector<double> zones = claims::zones_of(evidence);
  for (const double zone : zones)
    for (const claims::EfficiencyPoint& p : claims::efficiency(evidence, 1.0, zone)) {
      const ChartPoint mean = mean_point(zone, p.ratio);
      curves[p.v].add(mean.x, mean.y, mean.error);
    }
  for (auto& [v, curve] : curves) {
    curve.label = fmt::format("{:g} c_R", v);
    curve.style = Style::line_points, curve.colour = static_cast<int>(chart.series.size());
    chart.series.push_back(std::move(curve));
  }
  shade_in_order(chart.series);
  if (!zones.empty()) chart.series.push_back(level("strip limit", 1.0, zones.front(), zones.back()));
  return chart;
}

/// Shares of the wake's kinetic energy by size, a curve per row.
Chart wake_chart(const std::string& title,
                 const std::vector<std::pair<std::string, study::SummaryRow>>& rows) {
  Chart chart{.title = title,
              .x_label = "coherence length of the motion [mean radii]",
              .y_label = "fraction of the kinetic energy behind the tip [-]",
              .y_range = {.min = 0.0},
              .log_x = true};
  int colour = 0;
  for (const auto& [label, row] : rows) {
    ChartSeries curve = series_of(label, Style::line_points, colour++, claims::wake_bands(row),
                                  [](const claims::WakeBand& band) {
                                    return ChartPoint{band.cell, band.share};
                                  });
    if (!curve.x.empty()) chart.series.push_back(std::move(curve));
  }
  shade_in_order(chart.series);
  return chart;
}

/// The first specimen's rows with linear relaxation, by velocity and zone.
std::map<std::pair<double, double>, study::SummaryRow> strip_rows(const claims::Evidence& evidence) {
  std::map<std::pair<double, double>, study::SummaryRow> rows;
  for (const study::SummaryRow& row : evidence.rows)
    if (row.relaxation == 1.0 && row.seed == 1)
      rows[{row.crack_velocity_over_cr, row.damage_zone_ratio}] = row;
  return rows;
}

void add_wakes(std::vector<NamedChart>& charts, const claims::Evidence& evidence) {
  std::vector<std::pair<std::string, study::SummaryRow>> zones, velocities;
  for (const auto& [place, row] : strip_rows(evidence)) {
    if (place.first == 0.5) zones.emplace_back(fmt::format("r_l = {:g}", place.second), row);
    if (place.second == 1.0) velocities.emplace_back(fmt::format("{:g} c_R", place.first), row);
  }
  const auto add = [&](const std::string& name, const std::string& title, const auto& rows) {
    Chart chart = wake_chart(title, rows);
    if (!chart.series.empty())
      charts.push_back({name,
                        "Shares of the kinetic energy of the first specimen by coherence length" +
                            scheme_text(evidence.rows) + "; what they lack of 1 is rotation.",
                        std::move(chart)});
  };
  add("beyond_wake_zone", "Kinetic energy behind the tip by coherence length, at 0.5 c_R", zones);
  add("beyond_wake_velocity", "Kinetic energy behind the tip by coherence length, r_l = 1", velocities);
}

std::vector<NamedChart> efficiencies(const claims::Evidence& evidence) {
  Chart zones = efficiency_against_zone(evidence);
  if (zones.series.size() < 2) return {};
  Chart velocity = efficiency_against_velocity("Lattice efficiency of a steady strip, linear relaxation");
  int colour = 0;
  std::vector<ChartSeries> of_zones;
  for (const double zone : claims::zones_of(evidence))
    of_zones.push_back(efficiency_series(fmt::format("r_l = {:g}", zone),
                                         claims::efficiency(evidence, 1.0, zone), colour++));
  shade_in_order(of_zones);
  velocity.series.insert(velocity.series.end(), of_zones.begin(), of_zones.end());
  std::vector<NamedChart> charts{
      {"beyond_efficiency", "Linear relaxation, α = 0; mean, bars: standard deviation between specimens.",
       std::move(zones)},
      {"beyond_efficiency_velocity",
       "Linear relaxation, α = 0; Broberg, Freund and strip are theory of a continuum.",
       std::move(velocity)}};
  for (const double zone : {1.0, 4.0, 16.0}) {
    Chart chart = efficiency_against_velocity(fmt::format("Lattice efficiency at r_l = {:g}", zone));
    colour = 0;
    for (const auto& [label, p] : {std::pair{"square root", 0.5}, {"linear", 1.0}, {"quadratic", 2.0}}) {
      const std::vector<claims::EfficiencyPoint> points = claims::efficiency(evidence, p, zone);
      if (!points.empty()) chart.series.push_back(efficiency_series(label, points, colour));
      ++colour;
    }
    if (chart.series.size() > 4)
      charts.push_back(
          {fmt::format("beyond_relaxation_{:g}", zone),
           fmt::format("Three relaxations at r_l = {:g}, α = 0; bars: standard deviation between specimens.",
                       zone),
           std::move(chart)});
  }
  add_wakes(charts, evidence);
  return charts;
}

/// Measured ratios and efficiency times Broberg, of the smallest elements; and ratio over efficiency.
Chart own_problem_chart(const std::vector<claims::BrobergProblem>& points, bool over_efficiency) {
  Chart chart = chart_of_references(
      over_efficiency ? "A crack opening in a large plate: release rate over the lattice efficiency"
                      : "A crack opening in a large plate (Broberg's problem)");
  chart.series.resize(1);  // Broberg alone
  chart.x_label = "crack velocity v / c_R, the specimens' own c_R [-]";
  if (over_efficiency) chart.y_label = "G_{ID} / (G_{I0} η) [-]";
  std::map<double, std::pair<ChartSeries, ChartSeries>> curves;
  double most = 0.0;
  for (const claims::BrobergProblem& p : points) most = std::max(most, p.elements);
  for (const claims::BrobergProblem& p : points) {
    if (p.elements < most) continue;
    auto& [measured, expected] = curves[p.zone];
    const double factor = over_efficiency ? p.broberg : 1.0;
    const std::vector<double>& numbers = over_efficiency ? p.over_theory : p.ratio;
    measured.add(p.own_v, factor * base::mean_of(numbers), factor * base::standard_error_of(numbers));
    expected.add(p.own_v, base::mean_of(p.efficiency) * p.broberg);
  }
  int colour = 0;
  for (auto& [zone, pair] : curves) {
    auto& [measured, expected] = pair;
    measured.label = fmt::format("r_l = {:g}", zone);
    measured.style = Style::points;
    measured.colour = expected.colour = colour++;
    chart.series.push_back(measured);
    if (over_efficiency) continue;
    expected.label = fmt::format("η Broberg, r_l = {:g}", zone);
    expected.style = Style::line;
    chart.series.push_back(expected);
  }
  return chart;
}

/// Ratio over efficiency and Broberg, against the size of the elements, and the limits at 0; 0.9 c_R, which
/// is not judged and far off, is left out.
Chart size_chart(const std::vector<claims::BrobergProblem>& points) {
  Chart chart{.title = "Broberg's problem: release rate over efficiency and theory as elements grow small",
              .x_label = "mean radius over half length R / a [-]",
              .y_label = "G_{ID} / (G_{I0} η Broberg) [-]",
              .x_range = {.min = 0.0}};
  const auto judged = [](double v) {
    return std::any_of(std::begin(claims::decided_velocities), std::end(claims::decided_velocities),
                       [v](double decided) { return std::abs(v - decided) < 1e-6; });
  };
  std::map<std::pair<double, double>, ChartSeries> curves;
  double farthest = 0.0;
  for (const claims::BrobergProblem& p : points) {
    if (!judged(p.v)) continue;
    curves[{p.v, p.zone}].add(p.radius_over_half_length, base::mean_of(p.over_theory),
                              base::standard_error_of(p.over_theory));
    farthest = std::max(farthest, p.radius_over_half_length);
  }
  int colour = 0;
  for (auto& [place, curve] : curves) {
    curve.label = fmt::format("{:g} c_R, r_l = {:g}", place.first, place.second);
    curve.style = Style::line_points;
    curve.colour = colour++;
    chart.series.push_back(std::move(curve));
  }
  ChartSeries limits{.label = "R = 0, both r_l", .style = Style::points, .colour = colour};
  const std::vector<claims::BrobergLimit> all = claims::broberg_limits(points);
  for (const claims::BrobergLimit& limit : all)
    if (judged(limit.v)) {  // side by side
      limits.add(0.001 + 0.005 * static_cast<double>(limits.x.size()), limit.limit, limit.uncertainty);
      limits.text.push_back(fmt::format("{:g}", limit.v));
    }
  if (!limits.x.empty()) chart.series.push_back(std::move(limits));
  chart.series.push_back(level("Broberg", 1.0, 0.0, farthest));
  return chart;
}

std::vector<NamedChart> own_problems(const claims::Evidence& evidence) {
  const std::vector<claims::BrobergProblem> points = claims::broberg_problem(evidence);
  if (points.empty()) return {};
  std::vector<NamedChart> charts{
      {"beyond_broberg",
       "Computed (symbols) and lattice efficiency of the same beams times Broberg's "
       "factor (lines) with the smallest elements, over the specimens' own c_R; linear "
       "relaxation, α = 0; bars: standard uncertainty of the mean.",
       own_problem_chart(points, false)},
      {"beyond_broberg_over_efficiency",
       "Computed release rate over the lattice efficiency of the same beams with "
       "the smallest elements, over the specimens' own c_R; linear relaxation, α = 0; "
       "bars: standard uncertainty of the mean.",
       own_problem_chart(points, true)}};
  if (Chart sizes = size_chart(points); sizes.series.size() > 1)
    charts.push_back({"beyond_broberg_size",
                      "Two sizes of elements, and at the left, side by side, the limits for R = 0 at 0.3, "
                      "0.5 and 0.7 c_R; linear "
                      "relaxation, α = 0; bars: standard uncertainty.",
                      std::move(sizes)});
  return charts;
}

}  // namespace

std::vector<NamedChart> beyond_charts(const claims::Claim& claim, const claims::Evidence& evidence) {
  if (claim.name == "beyond_map") return maps(evidence);
  if (claim.name == "beyond_efficiency") return efficiencies(evidence);
  return own_problems(evidence);
}

}  // namespace rift::studio
