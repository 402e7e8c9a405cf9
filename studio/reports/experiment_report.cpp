#include "studio/reports/experiment_report.hpp"

#include "engine/base/csv.hpp"
#include "engine/base/text.hpp"
#include "studio/reports/experiment_charts.hpp"
#include "studio/reports/report.hpp"

#include <fmt/format.h>

namespace rift::studio {
namespace {

std::string csv_of(const experiment::Experiment& e) {
  std::string csv =
      "position_m,time_s,crack_velocity_over_cr,g_i0_quasi_static_j_m2,g_idc_j_m2,u_noise_j_m2,u_packing_j_"
      "m2,u_window_j_m2,u_j_m2,efficiency,g_idc_corrected_j_m2,u_corrected_j_m2,correction_factor,"
      "u_quasi_static_j_m2\n";
  for (const experiment::CriticalPoint& p : e.along)
    csv += base::csv_row(p.position, p.time, p.over_cr, p.quasi_static, p.as_paper, p.of_noise, p.of_packing,
                         p.of_window, p.uncertainty, p.efficiency, p.corrected, p.corrected_uncertainty,
                         p.as_paper / p.quasi_static, p.quasi_static_uncertainty);
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
