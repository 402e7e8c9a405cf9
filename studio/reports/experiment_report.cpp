#include "studio/reports/experiment_report.hpp"

#include "engine/base/csv.hpp"
#include "engine/base/text.hpp"
#include "engine/fracture/equation_of_motion.hpp"
#include "studio/reports/experiment_charts.hpp"
#include "studio/reports/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
  Table table{{"", ""},
              {{"smoothed history", fmt::format("{}; the measured rows scatter around it by {:.3g} mm",
                                                report.smoothing, 1e3 * e.course.scatter)},
               {"standard uncertainty",
                uncertainty_text(e, m) + "; each ± in the table is two standard uncertainties"},
               {"quasi-static reading",
                fmt::format("G_I0 is on average {:.3f} times G_IDc as in the paper and {:.3f} times the "
                            "corrected G_IDc; it is of "
                            "one packing, whose {} elements scatter, and has no band",
                            m.over_static, m.corrected_over_static, report.scene.specimen.elements)}}};
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
  std::string csv = fmt::format(
      "# G_IDc of {}, as in the paper{}: for crack.toughness\n{};release_rate [J/m2]\n",
      base::escaped(report.preset),
      by_position ? "" : ", monotone fit, continued by its mean slope beyond the measured velocities",
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
