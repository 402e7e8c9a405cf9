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

using Json = nlohmann::ordered_json;

std::string with_band(double rate, double uncertainty) {
  return fmt::format("{:.3f} ± {:.3f}", 1e-3 * rate, 2e-3 * uncertainty);
}

/// Over the points: of what the uncertainty is made, and how wrong a quasi-static reading is.
struct Means {
  double noise = 0, packing = 0, window = 0, over_static = 0, corrected_over_static = 0;
};

Means means_of(const experiment::Experiment& e) {
  Means m;
  for (const experiment::CriticalPoint& p : e.along) {
    m.noise += p.of_noise / p.as_paper, m.packing += p.of_packing / p.as_paper,
        m.window += p.of_window / p.as_paper;
    m.over_static += p.quasi_static / p.as_paper, m.corrected_over_static += p.quasi_static / p.corrected;
  }
  const auto count = static_cast<double>(e.along.size());
  for (double* part : {&m.noise, &m.packing, &m.window, &m.over_static, &m.corrected_over_static})
    *part /= count;
  return m;
}

/// Of what was asked for; what was not is no zero.
std::string uncertainty_text(const experiment::Experiment& e, const Means& m) {
  std::string text = e.resamples == 0
                         ? std::string("noise not evaluated (0 resamples)")
                         : fmt::format("noise {:.1f} % ({} resamples", 100 * m.noise, e.resamples);
  if (e.resamples > 0 && e.resamples < e.resamples_asked)
    text += fmt::format(" of {}: the others give no valid crack", e.resamples_asked);
  if (e.resamples > 0) text += ")";
  text += e.specimens == 1 ? std::string(", packing scatter not evaluated (1 specimen)")
                           : fmt::format(", packing {:.1f} % ({} specimens)", 100 * m.packing, e.specimens);
  return text + fmt::format(", window {:.1f} %", 100 * m.window);
}

/// Difference of the identified critical rate to the reference.
struct Distance {
  double mean = 0, largest = 0;  // of |found / truth - 1|
  double within = 0;  // share of the points whose band of two standard uncertainties holds the truth
};

Distance distance_from_truth(const ExperimentReport& report, bool corrected) {
  const experiment::Experiment& e = report.experiment;
  Distance d;
  for (const experiment::CriticalPoint& p : e.along) {
    const double truth = fracture::critical_rate(report.truth, p.over_cr, e.rayleigh_speed, p.position);
    const double off = std::abs((corrected ? p.corrected : p.as_paper) - truth);
    d.mean += off / truth, d.largest = std::max(d.largest, off / truth);
    d.within += off <= 2.0 * (corrected ? p.corrected_uncertainty : p.uncertainty) ? 1.0 : 0.0;
  }
  d.mean /= static_cast<double>(e.along.size()), d.within /= static_cast<double>(e.along.size());
  return d;
}

std::string truth_text(const ExperimentReport& report, bool corrected) {
  const Distance d = distance_from_truth(report, corrected);
  return fmt::format(
      "difference {:.1f} % on average, {:.1f} % at most; within the band at {:.0f} % of the points",
      100 * d.mean, 100 * d.largest, 100 * d.within);
}

std::string application_text(const experiment::Experiment& e) {
  constexpr double hardly = 0.1;  // that the law rises over its velocities
  const experiment::Application& a = e.application;
  if (a.along.empty()) return "the predicted crack arrested before the first point";
  std::string text = fmt::format(
      "predicted velocity differs by {:.1f} % rms ({:.1f} % expected from the uncertainty), tip position by "
      "at most {:.2f} mm, energy released by {:.1f} %",
      100 * a.velocity_error, 100 * a.velocity_expected, 1e3 * a.worst_lag, 100 * a.rate_error);
  if (std::isfinite(a.arrested_m)) text += fmt::format("; arrested at {:.4g} mm", 1e3 * a.arrested_m);
  const double rises = e.law.back()[1] / e.law.front()[1] - 1.0;
  if (rises < hardly)
    text += fmt::format("; G_c rises by {:.0f} % only, so the velocity is poorly determined", 100 * rises);
  return text;
}

/// What was found, a label and a text a row.
Table conclusions(const ExperimentReport& report) {
  const experiment::Experiment& e = report.experiment;
  const Means m = means_of(e);
  Table table{
      {"", ""},
      {{"smoothed history", fmt::format("{}; the measured rows scatter around it by {:.3g} mm",
                                        report.smoothing, 1e3 * e.course.scatter)},
       {"standard uncertainty",
        uncertainty_text(e, m) + "; each ± in the table is two standard uncertainties"},
       {"quasi-static reading",
        fmt::format(
            "G_I0 is on average {:.3f} times G_IDc as in the paper and {:.3f} times the corrected G_IDc",
            m.over_static, m.corrected_over_static)}}};
  if (!report.truth.row.empty()) {
    table.rows.push_back({report.truth_name + ", as in the paper", truth_text(report, false)});
    table.rows.push_back({report.truth_name + ", corrected", truth_text(report, true)});
  }
  if (!e.application.along.empty() || std::isfinite(e.application.arrested_m))
    table.rows.push_back({"forward check", application_text(e)});
  table.rows.push_back({"balance error", fmt::format("{:.1e} of the largest energy", e.worst_residual)});
  return table;
}

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

/// A dozen of the points.
Table experiment_table(const ExperimentReport& report) {
  Table table{{"tip [mm]", "time [µs]", "v [c_R]", "G_I0 [kJ/m²]", "G_IDc ± 2u, paper", "corrected ± 2u",
               "efficiency", "G_IDc/G_I0"},
              {}};
  const std::vector<experiment::CriticalPoint>& along = report.experiment.along;
  const std::size_t apart = std::max<std::size_t>(1, along.size() / 12);
  for (std::size_t k = 0; k < along.size(); k += apart) {
    const experiment::CriticalPoint& p = along[k];
    table.rows.push_back(
        {fmt::format("{:.1f}", 1e3 * p.position), fmt::format("{:.1f}", 1e6 * p.time),
         fmt::format("{:.3f}", p.over_cr), fmt::format("{:.3f}", 1e-3 * p.quasi_static),
         with_band(p.as_paper, p.uncertainty), with_band(p.corrected, p.corrected_uncertainty),
         fmt::format("{:.3f}", p.efficiency), fmt::format("{:.3f}", p.as_paper / p.quasi_static)});
  }
  return table;
}

}  // namespace

std::string experiment_text(const ExperimentReport& report, bool color) {
  std::string text = plain_table(experiment_table(report), color) + "\n";
  for (const auto& row : conclusions(report).rows) text += label_line(row[0], row[1]);
  return text;
}

Json experiment_json(const ExperimentReport& report) {
  const experiment::Experiment& e = report.experiment;
  const Means m = means_of(e);
  Json along = Json::array();
  for (const experiment::CriticalPoint& p : e.along)
    along.push_back({{"position_m", p.position},
                     {"time_s", p.time},
                     {"crack_velocity_over_cr", p.over_cr},
                     {"g_i0_quasi_static_j_m2", p.quasi_static},
                     {"g_idc_j_m2", p.as_paper},
                     {"u_j_m2", p.uncertainty},
                     {"efficiency", p.efficiency},
                     {"g_idc_corrected_j_m2", p.corrected},
                     {"u_corrected_j_m2", p.corrected_uncertainty}});
  Json json{{"preset", report.preset},
            {"version", report.build.version},
            {"smoothing", report.smoothing},
            {"scatter_m", e.course.scatter},
            {"window_m", e.width},
            {"resamples", e.resamples},
            {"specimens", e.specimens},
            {"u_noise", m.noise},
            {"u_packing", m.packing},
            {"u_window", m.window},
            {"quasi_static_over_g_idc", m.over_static},
            {"quasi_static_over_g_idc_corrected", m.corrected_over_static},
            {"ledger_residual", e.worst_residual},
            {"outcome", simulation::name_of(e.outcome)},
            {"wall_s", report.wall_s},
            {"along", along}};
  if (!e.application.along.empty())
    json["application"] = {{"velocity_error", e.application.velocity_error},
                           {"velocity_error_expected", e.application.velocity_expected},
                           {"worst_lag_m", e.application.worst_lag},
                           {"rate_error", e.application.rate_error},
                           {"arrest_m", e.application.arrested_m}};
  if (!report.truth.row.empty())
    for (const bool corrected : {false, true}) {
      const Distance d = distance_from_truth(report, corrected);
      json[corrected ? "truth_corrected" : "truth"] = {
          {"mean_error", d.mean}, {"largest_error", d.largest}, {"within_band", d.within}};
    }
  return json;
}

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
    add("", Style::band, 0, paper, [](const Point& p) { return p.uncertainty; });
    add("", Style::band, 1, corrected, [](const Point& p) { return p.corrected_uncertainty; });
  }
  add("G_{IDc}, as in the paper", style, 0, paper);
  add("G_{IDc}, corrected", style, 1, corrected);
  add("quasi-static G_{I0}", lines ? Style::dashed : style, 2, [](const Point& p) { return p.quasi_static; });
  if (!lines)
    all.push_back(series_of("monotone fit (isotonic regression)", Style::line, 0, e.law, [](const auto& at) {
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
      std::string("Energy dissipated in the damage zone (as in the paper), the same divided by the lattice "
                  "efficiency at that velocity, and the quasi-static release rate under the same grips.") +
          (style == Style::line ? " Bands: two standard uncertainties of noise, packing and window." : ""),
      Chart{.title = title,
            .x_label = x_label,
            .y_label = "release rate [kJ/m²]",
            .x_range = around(report.experiment.along, x),
            .y_range = {.min = 0.0},
            .series = readings(report, x, style)}};
}

NamedChart efficiency_chart(const experiment::Experiment& e) {
  return {"efficiency",
          "Fraction of the energy flux into the tip that the damage zone dissipates, from a steady crack in "
          "a strip of the same lattice, where all the energy stored ahead arrives at the tip (Nilsson 1972).",
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
                .scenes = {report.scene},
                .files = {{"summary.json", base::json_text(experiment_json(report), 2) + "\n"},
                          {"table.csv", csv_of(report.experiment)},
                          {"toughness_position.csv", toughness_csv(report, true)},
                          {"toughness_velocity.csv", toughness_csv(report, false)}},
                .sections = {{"Results", conclusions(report)},
                             {"Charts", experiment_charts(report)},
                             {"Along the crack", experiment_table(report)}}},
               folder);
}

}  // namespace rift::studio
