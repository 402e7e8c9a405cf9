#include "studio/reports/experiment_report.hpp"

#include "engine/base/csv.hpp"
#include "engine/base/text.hpp"
#include "engine/fracture/equation_of_motion.hpp"
#include "studio/reports/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace rift::studio {
namespace {

std::string csv_of(const experiment::Experiment& e) {
  std::string csv =
      "position_m,time_s,crack_velocity_over_cr,g_i0_quasi_static_j_m2,g_idc_j_m2,u_noise_j_m2,u_packing_j_"
      "m2,u_window_j_m2,u_j_m2,efficiency,g_idc_corrected_j_m2,u_corrected_j_m2,correction_factor\n";
  for (const experiment::CriticalPoint& p : e.along)
    csv += base::csv_row(p.position, p.time, p.over_cr, p.quasi_static, p.as_paper, p.of_noise, p.of_packing,
                         p.of_window, p.uncertainty, p.efficiency, p.corrected, p.corrected_uncertainty,
                         p.as_paper / p.quasi_static);
  return csv;
}

/// A table that crack.toughness reads: its columns are apart by semicolons, as measured ones are.
std::string toughness_csv(const ExperimentReport& report, bool by_position) {
  std::string csv =
      fmt::format("# G_IDc of {}, as in the paper{}: for crack.toughness\n{};release_rate [J/m2]\n",
                  base::escaped(report.preset), by_position ? "" : ", monotone fit",
                  by_position ? "position [m]" : "velocity [c_r]");
  if (by_position)
    for (const experiment::CriticalPoint& p : report.experiment.along)
      csv += fmt::format("{};{}\n", p.position, p.as_paper);
  else
    for (const auto& [v, rate, u] : report.experiment.law) csv += fmt::format("{};{}\n", v, rate);
  return csv;
}

using Style = ChartSeries::Style;
using Along = std::function<double(const experiment::CriticalPoint&)>;

constexpr double expanded = 2.0;  // standard uncertainties of a band

double mm(const experiment::CriticalPoint& p) { return 1e3 * p.position; }
double us(const experiment::CriticalPoint& p) { return 1e6 * p.time; }
double over_cr(const experiment::CriticalPoint& p) { return p.over_cr; }

NamedChart history_chart(const ExperimentReport& report) {
  ChartSeries rows =
      series_of("measured", Style::points, 1, report.rows, [](const history::HistoryPoint& row) {
        return ChartPoint{1e6 * row.time, 1e3 * row.position,
                          row.uncertainty > 0.0 ? 1e3 * row.uncertainty : NAN};
      });
  ChartSeries course{.label = "smoothed history"};
  const history::SmoothedHistory& c = report.experiment.course;
  const double duration = report.rows.back().time - report.rows.front().time;
  for (int k = 0; k <= 200; ++k) {
    const double t = duration * k / 200;
    course.add(1e6 * (c.first_time + t), 1e3 * history::tip_at(c.history, t));
  }
  return {
      "history",
      fmt::format("Measured rows and the smoothed history ({}): the rows scatter around it by {:.3g} mm{}.",
                  report.smoothing, 1e3 * c.scatter,
                  c.chi2 > 0.0 ? fmt::format(", χ² {:.2f} per row", c.chi2) : std::string()),
      Chart{.title = "Measured crack history",
            .x_label = "time [µs]",
            .y_label = "tip position [mm]",
            .series = {std::move(rows), std::move(course)}}};
}

NamedChart velocity_chart(const ExperimentReport& report) {
  const experiment::Experiment& e = report.experiment;
  ChartSeries band{.label = "band", .style = Style::band}, line{.label = "smoothed history"},
      raw{.label = "differences of rows", .style = Style::points, .colour = 1};
  double top = 0.0;
  for (std::size_t k = 0; k < e.along.size(); ++k) {
    const experiment::CriticalPoint& p = e.along[k];
    band.add(us(p), p.over_cr,
             k < e.drawn_speed.size() ? expanded * e.drawn_speed[k] / e.rayleigh_speed : 0.0);
    line.add(us(p), p.over_cr);
    top = std::max(top, 1.3 * p.over_cr);
  }
  for (std::size_t k = 1; k < report.rows.size(); ++k) {
    const history::HistoryPoint &a = report.rows[k - 1], &b = report.rows[k];
    raw.add(0.5e6 * (a.time + b.time), (b.position - a.position) / (b.time - a.time) / e.rayleigh_speed);
  }
  return {"velocity",
          "Velocity of the smoothed history, its band of two standard deviations over the resamples, and the "
          "differences of neighbouring rows.",
          Chart{.title = "Velocity of the crack along its course",
                .x_label = "time [µs]",
                .y_label = "velocity [c_R]",
                .y_range = {-0.1 * top, top + 0.1},
                .series = {std::move(band), std::move(raw), std::move(line)}}};
}

/// Both readings, the quasi-static one, and the truth where there is one.
std::vector<ChartSeries> readings(const ExperimentReport& report, const Along& x, Style style) {
  using Point = experiment::CriticalPoint;
  const experiment::Experiment& e = report.experiment;
  std::vector<ChartSeries> all;
  const auto add = [&](std::string label, Style look, int colour, const Along& y, const Along& u = {}) {
    all.push_back(series_of(std::move(label), look, colour, e.along, [&](const Point& p) {
      return ChartPoint{x(p), 1e-3 * y(p), u ? 1e-3 * expanded * u(p) : NAN};
    }));
  };
  const Along paper = [](const Point& p) { return p.as_paper; };
  const Along corrected = [](const Point& p) { return p.corrected; };
  const bool lines = style == Style::line;
  if (lines) {
    add("", Style::band, 0, corrected, [](const Point& p) { return p.corrected_uncertainty; });
    add("", Style::band, 1, paper, [](const Point& p) { return p.uncertainty; });
  }
  add("G_{IDc}, corrected", style, 0, corrected);
  add("G_{IDc}, uncorrected", style, 1, paper);
  add("quasi-static G_{I0}", lines ? Style::dashed : style, 2, [](const Point& p) { return p.quasi_static; });
  if (!lines)
    all.push_back(series_of("monotone fit of the uncorrected", Style::line, 1, e.law, [](const auto& at) {
      return ChartPoint{at[0], 1e-3 * at[1]};
    }));
  if (!report.truth.row.empty())
    add(report.truth_name, style, -1, [&](const Point& p) {
      return fracture::critical_rate(report.truth, p.over_cr, e.rayleigh_speed, p.position);
    });
  return all;
}

/// Around the measured points: the law goes on beyond them, to where nothing was measured.
AxisRange around(const std::vector<experiment::CriticalPoint>& along, const Along& x) {
  AxisRange range;
  for (const experiment::CriticalPoint& p : along) {
    range.min = std::min(range.min.value_or(x(p)), x(p));
    range.max = std::max(range.max.value_or(x(p)), x(p));
  }
  if (!range.min) return range;
  const double margin = 0.05 * (*range.max - *range.min) + 0.02 * *range.max;
  return {*range.min - margin, *range.max + margin};
}

NamedChart rate_chart(const ExperimentReport& report, const char* name, const char* title,
                      const char* x_label, const Along& x, Style style) {
  return {
      name,
      std::string("Corrected: the energy dissipated in the damage zone, divided by the lattice efficiency at "
                  "that velocity; uncorrected: that energy itself, as in the paper; and the quasi-static "
                  "release rate of the same lattice under the same grips.") +
          (style == Style::line ? " Bands: two standard uncertainties of noise, packing and window." : ""),
      Chart{.title = title,
            .x_label = x_label,
            .y_label = "release rate [kJ/m²]",
            .x_range = around(report.experiment.along, x),
            .y_range = {.min = 0.0},
            .series = readings(report, x, style)}};
}

NamedChart efficiency_chart(const experiment::Experiment& e) {
  return {
      "efficiency",
      "Fraction of the energy flux into the tip that the damage zone dissipates, from a steady crack in "
      "a strip of the same lattice, where all the energy stored ahead arrives at the tip (Nilsson 1972). "
      "Bars: scatter along the measuring window of each strip, the standard deviation over its ten parts.",
      Chart{.title = "Lattice efficiency",
            .x_label = "velocity [c_R]",
            .y_label = "efficiency [-]",
            .y_range = {0.0, 1.1},
            .series = {series_of("steady strip", Style::line_points, 0, e.efficiency,
                                 [](const experiment::EfficiencyPoint& p) {
                                   return ChartPoint{p.over_cr, p.efficiency, p.scatter};
                                 })}}};
}

NamedChart application_chart(const experiment::Experiment& e) {
  using Point = experiment::Application::Point;
  return {
      "application",
      fmt::format("Crack driven by the identified G_IDc(v) (monotone fit): its velocity differs from the "
                  "measured one by {:.1f} % rms, its tip position by at most {:.2g} mm.",
                  100 * e.application.velocity_error, 1e3 * e.application.worst_lag),
      Chart{.title = "Forward check: crack driven by the identified G_{IDc}(v)",
            .x_label = "tip position [mm]",
            .y_label = "velocity [c_R]",
            .y_range = {.min = 0.0},
            .series = {series_of("measured", Style::line, 0, e.application.along,
                                 [](const Point& p) {
                                   return ChartPoint{1e3 * p.position, p.measured_over_cr};
                                 }),
                       series_of("predicted", Style::line_points, 1, e.application.along, [](const Point& p) {
                         return ChartPoint{1e3 * p.position, p.over_cr};
                       })}}};
}

std::vector<NamedChart> experiment_charts(const ExperimentReport& report) {
  std::vector<NamedChart> charts{
      history_chart(report),
      velocity_chart(report),
      rate_chart(report, "rate_position", "Critical release rate along the crack", "tip position [mm]", mm,
                 Style::line),
      rate_chart(report, "rate_time", "Critical release rate in time", "time [µs]", us, Style::line),
      rate_chart(report, "rate_velocity", "Critical release rate against velocity", "velocity [c_R]", over_cr,
                 Style::points),
      efficiency_chart(report.experiment)};
  if (!report.experiment.application.along.empty()) charts.push_back(application_chart(report.experiment));
  return charts;
}

}  // namespace

void write_experiment_report(const ExperimentReport& report, const std::filesystem::path& folder) {
  write_report({.title = "Critical dynamic release rate G_IDc from the crack history of " +
                         preset_in_titles(report.preset),
                .made = {report.command, report.build, report.wall_s},
                .opening = {publish_text(report)},
                .scenes = {report.scene},
                .files = {{"summary.json", base::json_text(experiment_json(report), 2) + "\n"},
                          {"table.csv", csv_of(report.experiment)},
                          {"toughness_position.csv", toughness_csv(report, true)},
                          {"toughness_velocity.csv", toughness_csv(report, false)}},
                .sections = {{"Results", conclusions(report)},
                             {"Charts", experiment_charts(report)},
                             {"Along the crack", experiment_table(report), experiment_table_note}}},
               folder);
}

}  // namespace rift::studio
