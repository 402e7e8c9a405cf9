#include "studio/reports/experiment_report.hpp"

#include "engine/base/files.hpp"
#include "engine/base/text.hpp"
#include "engine/base/world_error.hpp"
#include "engine/fracture/equation_of_motion.hpp"
#include "studio/reports/experiment_charts.hpp"
#include "studio/text/html.hpp"
#include "studio/text/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rift::studio {
namespace {

using Json = nlohmann::ordered_json;

std::string with_band(double rate, double uncertainty) {
  return fmt::format("{:.3f} ± {:.3f}", 1e-3 * rate, 2e-3 * uncertainty);
}

std::string row_text(const std::string& label, const std::string& content) {
  return fmt::format("  {:<22}{}\n", label, content);
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
                         ? std::string("noise not asked for")
                         : fmt::format("noise {:.1f} % ({} histories", 100 * m.noise, e.resamples);
  if (e.resamples > 0 && e.resamples < e.resamples_asked)
    text += fmt::format(" of {}: the others are no crack's", e.resamples_asked);
  if (e.resamples > 0) text += ")";
  text += e.specimens == 1 ? std::string(", packing not asked for")
                           : fmt::format(", packing {:.1f} % ({} specimens)", 100 * m.packing, e.specimens);
  return text + fmt::format(", window {:.1f} %", 100 * m.window);
}

std::string truth_text(const ExperimentReport& report, bool corrected) {
  const Distance d = distance_from_truth(report, corrected);
  return fmt::format("{:.1f} % off on average, {:.1f} % at most; within the band at {:.0f} % of the points",
                     100 * d.mean, 100 * d.largest, 100 * d.within);
}

std::string application_text(const experiment::Experiment& e) {
  constexpr double hardly = 0.1;  // that the law rises over its velocities
  const experiment::Application& a = e.application;
  if (a.along.empty()) return "arrested before its first point";
  std::string text = fmt::format(
      "velocity off by {:.1f} % (rms; {:.1f} % by the band), tip by at most {:.2f} mm, what it releases by "
      "{:.1f} %",
      100 * a.velocity_error, 100 * a.velocity_expected, 1e3 * a.worst_lag, 100 * a.rate_error);
  if (std::isfinite(a.arrested_m)) text += fmt::format("; arrested at {:.4g} mm", 1e3 * a.arrested_m);
  const double rises = e.law.back()[1] / e.law.front()[1] - 1.0;
  if (rises < hardly)
    text += fmt::format("; its G_c rises by {:.0f} % only, which leaves the velocity nearly undecided",
                        100 * rises);
  return text;
}

std::vector<std::pair<std::string, std::string>> conclusions(const ExperimentReport& report) {
  const experiment::Experiment& e = report.experiment;
  const Means m = means_of(e);
  std::vector<std::pair<std::string, std::string>> rows{
      {"course", fmt::format("{}; rows scatter by {:.3g} mm", report.smoothing, 1e3 * e.course.scatter)},
      {"standard uncertainty", uncertainty_text(e, m) + "; the ± above is twice all of it"},
      {"read quasi-statically",
       fmt::format("G_I0 is {:.3f} times the G_IDc of the paper's reading, {:.3f} times the "
                   "corrected one, on average",
                   m.over_static, m.corrected_over_static)}};
  if (!report.truth.row.empty()) {
    rows.emplace_back(report.truth_name + ", as paper", truth_text(report, false));
    rows.emplace_back(report.truth_name + ", corrected", truth_text(report, true));
  }
  if (!e.application.along.empty() || std::isfinite(e.application.arrested_m))
    rows.emplace_back("given back", application_text(e));
  rows.emplace_back("books", fmt::format("close to {:.1e} of the energy", e.worst_residual));
  return rows;
}

std::string csv_of(const experiment::Experiment& e) {
  std::string csv =
      "position_m,time_s,crack_velocity_over_cr,g_i0_quasi_static_j_m2,g_idc_j_m2,u_noise_j_m2,u_packing_j_"
      "m2,"
      "u_window_j_m2,u_j_m2,efficiency,g_idc_corrected_j_m2,u_corrected_j_m2,correction_factor\n";
  for (const experiment::CriticalPoint& p : e.along)
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", p.position, p.time, p.over_cr,
                       p.quasi_static, p.as_paper, p.of_noise, p.of_packing, p.of_window, p.uncertainty,
                       p.efficiency, p.corrected, p.corrected_uncertainty, p.as_paper / p.quasi_static);
  return csv;
}

std::string toughness_csv(const ExperimentReport& report, bool by_position) {
  std::string csv =
      fmt::format("# G_IDc of {}, as the paper reads it{}: for crack.toughness\n{};release_rate [J/m2]\n",
                  base::escaped(report.preset), by_position ? "" : ", made to rise",
                  by_position ? "position [m]" : "velocity [c_r]");
  if (by_position)
    for (const experiment::CriticalPoint& p : report.experiment.along)
      csv += fmt::format("{};{}\n", p.position, p.as_paper);
  else
    for (const auto& [v, rate, u] : report.experiment.law) csv += fmt::format("{};{}\n", v, rate);
  return csv;
}

}  // namespace

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

Table experiment_table(const ExperimentReport& report) {
  Table table{{"tip [mm]", "time [us]", "v [c_R]", "G_I0 [kJ/m²]", "G_IDc, as paper", "corrected",
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

std::string experiment_text(const ExperimentReport& report, bool color) {
  std::string text = plain_table(experiment_table(report), color) + "\n";
  for (const auto& [label, content] : conclusions(report)) text += row_text(label, content);
  return text;
}

Json experiment_json(const ExperimentReport& report) {
  const experiment::Experiment& e = report.experiment;
  const Means m = means_of(e);
  const auto number = [](double v) { return std::isfinite(v) ? Json(v) : Json(nullptr); };
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
                           {"arrest_m", number(e.application.arrested_m)}};
  if (!report.truth.row.empty())
    for (const bool corrected : {false, true}) {
      const Distance d = distance_from_truth(report, corrected);
      json[corrected ? "truth_corrected" : "truth"] = {
          {"mean_error", d.mean}, {"largest_error", d.largest}, {"within_band", d.within}};
    }
  return json;
}

void write_experiment_report(const ExperimentReport& report, const std::filesystem::path& folder) {
  base::write_whole_file(folder / "summary.json", base::json_text(experiment_json(report), 2) + "\n");
  base::write_whole_file(folder / "table.csv", csv_of(report.experiment));
  base::write_whole_file(folder / "toughness_position.csv", toughness_csv(report, true));
  base::write_whole_file(folder / "toughness_velocity.csv", toughness_csv(report, false));
  std::string figures;
  std::optional<base::WorldError> failure;
  for (const NamedChart& named : experiment_charts(report)) {
    try {
      figures += html_figure(draw_chart(named.chart, folder / "charts", named.name).svg_text, named.caption);
    } catch (const base::WorldError& error) {
      failure = error;
      figures += html_paragraph(error.what());
    }
  }
  Table said{{"", ""}, {}};
  for (const auto& [label, content] : conclusions(report)) said.rows.push_back({label, content});
  std::string body =
      html_paragraph(fmt::format("Made by `{}`, rift {} ({}), in {}.", report.command, report.build.version,
                                 report.build.compiler, duration_text(report.wall_s)));
  body += html_section("What was found", html_table(said)) + html_section("Charts", figures) +
          html_section("Along the crack", html_table(experiment_table(report)));
  base::write_whole_file(folder / "report.html",
                         html_page("From the experiment to G_IDc: " + report.preset, body));
  if (failure) throw base::WorldError(*failure);
}

}  // namespace rift::studio
