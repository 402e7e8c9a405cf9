#include "studio/reports/experiment_charts.hpp"

#include "engine/base/numbers.hpp"
#include "engine/fracture/equation_of_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace rift::studio {
namespace {

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
  ChartSeries band{.label = "± two standard deviations of the resamples", .style = Style::band},
      line{.label = "smoothed history"},
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
                .y_label = "velocity [nominal c_R]",
                .y_range = {-0.1 * top, top + 0.1},
                .series = {std::move(band), std::move(raw), std::move(line)}}};
}

constexpr const char* band_label = "± two standard uncertainties";

/// The law where the crack's velocities were measured, and before and behind them.
struct LawParts {
  std::vector<std::array<double, 3>> below, measured, above;  // v / c_R, rate [J/m2] and its uncertainty
};

LawParts parts_of_law(const experiment::Experiment& e) {
  const auto [slow, fast] = std::minmax_element(
      e.along.begin(), e.along.end(), [](const auto& a, const auto& b) { return a.over_cr < b.over_cr; });
  const auto at = [&](double v) -> std::array<double, 3> {
    const auto [k, part] = base::interval_at(e.law, v, [](const auto& row) { return row[0]; });
    const auto &low = e.law[k - 1], &high = e.law[k];
    return {v, std::lerp(low[1], high[1], part), std::lerp(low[2], high[2], part)};
  };
  LawParts parts{.below = {}, .measured = {at(slow->over_cr)}, .above = {at(fast->over_cr)}};
  for (const auto& row : e.law) {
    if (row[0] < slow->over_cr) parts.below.push_back(row);
    if (row[0] > slow->over_cr && row[0] < fast->over_cr) parts.measured.push_back(row);
    if (row[0] > fast->over_cr) parts.above.push_back(row);
  }
  parts.below.push_back(parts.measured.front());
  parts.measured.push_back(parts.above.front());
  return parts;
}

/// The monotone fit with its band, and as it goes on where no velocity was measured.
std::vector<ChartSeries> law_series(const experiment::Experiment& e) {
  if (e.law.size() < 2) return {};
  const LawParts law = parts_of_law(e);
  const auto point = [](const auto& row) { return ChartPoint{row[0], 1e-3 * row[1]}; };
  ChartSeries band = series_of(band_label, Style::band, 1, law.measured, [](const auto& row) {
    return ChartPoint{row[0], 1e-3 * row[1], 1e-3 * expanded * row[2]};
  });
  band.name = "monotone fit, ± two standard uncertainties";
  const char* beyond = "continued beyond the measured velocities";
  return {std::move(band), series_of("monotone fit of the uncorrected", Style::line, 1, law.measured, point),
          series_of(beyond, Style::dashed, 1, law.below, point),
          series_of(beyond, Style::dashed, 1, law.above, point)};
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
    add(band_label, Style::band, 0, corrected, [](const Point& p) { return p.corrected_uncertainty; });
    all.back().name = "G_{IDc}, corrected, ± two standard uncertainties";
    add(band_label, Style::band, 1, paper, [](const Point& p) { return p.uncertainty; });
    all.back().name = "G_{IDc}, uncorrected, ± two standard uncertainties";
    add(
        band_label, Style::band, 2, [](const Point& p) { return p.quasi_static; },
        [](const Point& p) { return p.quasi_static_uncertainty; });
    all.back().name = "quasi-static G_{I0}, ± two standard uncertainties";
  }
  add("G_{IDc}, corrected", style, 0, corrected);
  add("G_{IDc}, uncorrected", style, 1, paper);
  add("quasi-static G_{I0}", lines ? Style::dashed : style, 2, [](const Point& p) { return p.quasi_static; });
  if (!lines)
    for (ChartSeries& of_law : law_series(e)) all.push_back(std::move(of_law));
  if (!report.truth.row.empty())
    add(report.truth_name, style, -1, [&](const Point& p) {
      return fracture::critical_rate(report.truth, p.over_cr, e.rayleigh_speed, p.position);
    });
  return all;
}

/// Around the measured points: the law goes on far beyond them.
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

constexpr const char* quasi_static_text =
    " G_I0 is read between eight positions; its band is of packing and window.";

NamedChart rate_chart(const ExperimentReport& report, const char* name, const char* title,
                      const char* x_label, const Along& x, Style style) {
  return {
      name,
      std::string("Corrected: the energy dissipated in the damage zone, divided by the lattice efficiency at "
                  "that velocity; uncorrected: that energy itself, as in the paper; and the quasi-static "
                  "release rate of the same lattice under the same grips.") +
          (style == Style::line
               ? " Bands: two standard uncertainties of noise, packing and window."
               : " Band: two standard uncertainties of noise, packing and window around the monotone fit of "
                 "the "
                 "uncorrected G_IDc; beyond the measured velocities the fit continues with its mean slope, "
                 "which nothing measured.") +
          quasi_static_text,
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
            .x_label = "velocity [nominal c_R]",
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
            .y_label = "velocity [nominal c_R]",
            .y_range = {.min = 0.0},
            .series = {series_of("measured", Style::line, 0, e.application.along,
                                 [](const Point& p) {
                                   return ChartPoint{1e3 * p.position, p.measured_over_cr};
                                 }),
                       series_of("predicted", Style::line_points, 1, e.application.along, [](const Point& p) {
                         return ChartPoint{1e3 * p.position, p.over_cr};
                       })}}};
}

}  // namespace

std::vector<NamedChart> experiment_charts(const ExperimentReport& report) {
  std::vector<NamedChart> charts{
      history_chart(report),
      velocity_chart(report),
      rate_chart(report, "rate_position", "Critical release rate along the crack", "tip position [mm]", mm,
                 Style::line),
      rate_chart(report, "rate_time", "Critical release rate in time", "time [µs]", us, Style::line),
      rate_chart(report, "rate_velocity", "Critical release rate against velocity", "velocity [nominal c_R]",
                 over_cr, Style::points),
      efficiency_chart(report.experiment)};
  if (!report.experiment.application.along.empty()) charts.push_back(application_chart(report.experiment));
  return charts;
}

}  // namespace rift::studio
