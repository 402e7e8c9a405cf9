#include "studio/reports/experiment_charts.hpp"

#include "engine/fracture/equation_of_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace rift::studio {
namespace {

using Style = ChartSeries::Style;
using Along = std::function<double(const experiment::CriticalPoint&)>;

constexpr double expanded = 2.0;  // standard uncertainties of a band

ChartSeries series(std::string label, Style style, int colour) {
  ChartSeries s;
  s.label = std::move(label), s.style = style, s.colour = colour;
  return s;
}

double mm(const experiment::CriticalPoint& p) { return 1e3 * p.position; }
double us(const experiment::CriticalPoint& p) { return 1e6 * p.time; }
double over_cr(const experiment::CriticalPoint& p) { return p.over_cr; }

NamedChart history_chart(const ExperimentReport& report) {
  NamedChart named{"history", "", {}};
  named.chart.title = "The measured crack";
  named.chart.x_label = "time [us]", named.chart.y_label = "tip position [mm]";
  ChartSeries rows = series("measured", Style::points, 1), course = series("course", Style::line, 0);
  for (const history::HistoryPoint& row : report.rows) {
    rows.x.push_back(1e6 * row.time), rows.y.push_back(1e3 * row.position);
    if (row.uncertainty > 0.0) rows.error.push_back(1e3 * row.uncertainty);
  }
  const history::SmoothedHistory& c = report.experiment.course;
  const double duration = report.rows.back().time - report.rows.front().time;
  for (int k = 0; k <= 200; ++k) {
    const double t = duration * k / 200;
    course.x.push_back(1e6 * (c.first_time + t)), course.y.push_back(1e3 * history::tip_at(c.history, t));
  }
  named.chart.series = {std::move(rows), std::move(course)};
  named.caption = fmt::format(
      "What was measured, and the course made of it ({}): the rows scatter around it by {:.3g} mm{}.",
      report.smoothing, 1e3 * c.scatter,
      c.chi2 > 0.0 ? fmt::format(", chi^2 {:.2f} a row", c.chi2) : std::string());
  return named;
}

NamedChart velocity_chart(const ExperimentReport& report) {
  const experiment::Experiment& e = report.experiment;
  NamedChart named{"velocity",
                   "The course's velocity, its band of two standard deviations from the histories "
                   "drawn anew, and the differences of neighbouring rows.",
                   {}};
  named.chart.title = "Its velocity";
  named.chart.x_label = "time [us]", named.chart.y_label = "velocity [c_R]";
  ChartSeries band = series("band", Style::band, 0), line = series("course", Style::line, 0),
              raw = series("differences of rows", Style::points, 1);
  for (std::size_t k = 0; k < e.along.size(); ++k) {
    const experiment::CriticalPoint& p = e.along[k];
    band.x.push_back(us(p)), band.y.push_back(p.over_cr);
    band.error.push_back(k < e.drawn_speed.size() ? expanded * e.drawn_speed[k] / e.rayleigh_speed : 0.0);
    line.x.push_back(us(p)), line.y.push_back(p.over_cr);
  }
  for (std::size_t k = 1; k < report.rows.size(); ++k) {
    const history::HistoryPoint &a = report.rows[k - 1], &b = report.rows[k];
    raw.x.push_back(0.5e6 * (a.time + b.time));
    raw.y.push_back((b.position - a.position) / (b.time - a.time) / e.rayleigh_speed);
  }
  const double top = 1.3 * std::max_element(e.along.begin(), e.along.end(), [](const auto& a, const auto& b) {
                             return a.over_cr < b.over_cr;
                           })->over_cr;
  named.chart.y_range = {-0.1 * top, top + 0.1};
  named.chart.series = {std::move(band), std::move(raw), std::move(line)};
  return named;
}

ChartSeries band(const experiment::Experiment& e, std::string label, int colour, const Along& x,
                 const Along& y, const Along& u) {
  ChartSeries s = series(std::move(label), Style::band, colour);
  for (const experiment::CriticalPoint& p : e.along)
    s.x.push_back(x(p)), s.y.push_back(1e-3 * y(p)), s.error.push_back(1e-3 * expanded * u(p));
  return s;
}

ChartSeries curve(const experiment::Experiment& e, std::string label, Style style, int colour, const Along& x,
                  const Along& y) {
  ChartSeries s = series(std::move(label), style, colour);
  for (const experiment::CriticalPoint& p : e.along) s.x.push_back(x(p)), s.y.push_back(1e-3 * y(p));
  return s;
}

/// Both readings, the quasi-static one, and the truth where there is one.
std::vector<ChartSeries> readings(const ExperimentReport& report, const Along& x, Style style) {
  const experiment::Experiment& e = report.experiment;
  const Along paper = [](const experiment::CriticalPoint& p) { return p.as_paper; };
  const Along corrected = [](const experiment::CriticalPoint& p) { return p.corrected; };
  std::vector<ChartSeries> all;
  if (style == Style::line) {
    all.push_back(band(e, "", 0, x, paper, [](const experiment::CriticalPoint& p) { return p.uncertainty; }));
    all.push_back(band(e, "", 1, x, corrected,
                       [](const experiment::CriticalPoint& p) { return p.corrected_uncertainty; }));
  }
  all.push_back(curve(e, "G_{IDc}, as the paper", style, 0, x, paper));
  all.push_back(curve(e, "G_{IDc}, corrected", style, 1, x, corrected));
  all.push_back(curve(e, "quasi-static G_{I0}", style == Style::line ? Style::dashed : style, 2, x,
                      [](const experiment::CriticalPoint& p) { return p.quasi_static; }));
  if (style == Style::points) {
    ChartSeries law = series("law, made to rise", Style::line, 0);
    for (const auto& [v, rate, u] : e.law) law.x.push_back(v), law.y.push_back(1e-3 * rate);
    all.push_back(std::move(law));
  }
  if (!report.truth.row.empty())
    all.push_back(curve(e, report.truth_name, style == Style::line ? Style::line : Style::points, -1, x,
                        [&](const experiment::CriticalPoint& p) {
                          return fracture::critical_rate(report.truth, p.over_cr, e.rayleigh_speed,
                                                         p.position);
                        }));
  return all;
}

NamedChart rate_chart(const ExperimentReport& report, const char* name, const char* title,
                      const char* x_label, const Along& x, Style style) {
  NamedChart named{name, "", {}};
  named.chart.title = title, named.chart.x_label = x_label;
  named.chart.y_label = "release rate [kJ/m^2]", named.chart.key_outside = true;
  named.chart.series = readings(report, x, style);
  named.chart.y_range.min = 0.0;
  named.caption =
      "What the lattice's damage zone takes (as the paper reads it), the same over the lattice's efficiency "
      "at "
      "that velocity, and what a crack without waves would release under the same grips.";
  if (style == Style::line)
    named.caption += " Bands: two standard uncertainties of noise, packing and window.";
  return named;
}

NamedChart efficiency_chart(const experiment::Experiment& e) {
  NamedChart named{
      "efficiency",
      "The share of what arrives at the tip that the damage zone takes: a crack that runs steadily "
      "through the same lattice's strip, where all that is stored ahead arrives (Nilsson 1972).",
      {}};
  named.chart.title = "Efficiency of the lattice";
  named.chart.x_label = "velocity [c_R]", named.chart.y_label = "efficiency [-]";
  named.chart.y_range = {0.0, 1.1};
  ChartSeries s = series("steady strip", Style::line_points, 0);
  for (const experiment::EfficiencyPoint& p : e.efficiency)
    s.x.push_back(p.over_cr), s.y.push_back(p.efficiency), s.error.push_back(p.scatter);
  named.chart.series = {std::move(s)};
  return named;
}

NamedChart application_chart(const experiment::Experiment& e) {
  NamedChart named{"application",
                   fmt::format("A crack that runs by itself, given G_{{IDc}} against the velocity, made to "
                               "rise: its velocity is off by "
                               "{:.1f} % (root of the mean square), its tip by at most {:.2g} mm.",
                               100 * e.application.velocity_error, 1e3 * e.application.worst_lag),
                   {}};
  std::erase_if(named.caption, [](char c) { return c == '{' || c == '}'; });
  named.chart.title = "Given back: the crack that runs by itself";
  named.chart.x_label = "tip position [mm]", named.chart.y_label = "velocity [c_R]";
  ChartSeries own = series("by itself", Style::line_points, 1), measured = series("measured", Style::line, 0);
  for (const experiment::Application::Point& p : e.application.along) {
    own.x.push_back(1e3 * p.position), own.y.push_back(p.over_cr);
    measured.x.push_back(1e3 * p.position), measured.y.push_back(p.measured_over_cr);
  }
  named.chart.y_range.min = 0.0;
  named.chart.series = {std::move(measured), std::move(own)};
  return named;
}

}  // namespace

std::vector<NamedChart> experiment_charts(const ExperimentReport& report) {
  std::vector<NamedChart> charts{
      history_chart(report),
      velocity_chart(report),
      rate_chart(report, "rate_position", "Critical release rate along the crack", "tip position [mm]", mm,
                 Style::line),
      rate_chart(report, "rate_time", "Critical release rate in time", "time [us]", us, Style::line),
      rate_chart(report, "rate_velocity", "Critical release rate against velocity", "velocity [c_R]", over_cr,
                 Style::points),
      efficiency_chart(report.experiment)};
  if (!report.experiment.application.along.empty()) charts.push_back(application_chart(report.experiment));
  return charts;
}

}  // namespace rift::studio
