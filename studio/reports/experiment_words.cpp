#include "engine/base/text.hpp"
#include "engine/fracture/equation_of_motion.hpp"
#include "engine/scene/validation.hpp"
#include "studio/reports/experiment_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rift::studio {

using Json = nlohmann::ordered_json;

namespace {

std::string with_band(double rate, double uncertainty) {
  return fmt::format("{:.3f} ± {:.3f}", 1e-3 * rate, 2e-3 * uncertainty);
}

/// With two digits of the band of two standard uncertainties: "8.06 ± 0.45".
std::string mean_with_band(double rate, double uncertainty) {
  const double band = 2e-3 * uncertainty;
  const int digits = band > 0.0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(band))), 0, 9) : 4;
  return fmt::format("{:.{}f} ± {:.{}f}", 1e-3 * rate, digits, band, digits);
}

/// Over the points: of what the uncertainty is made, and how wrong a quasi-static reading is.
struct Means {
  double noise = 0, packing = 0, window = 0, over_static = 0, corrected_over_static = 0, of_static = 0;
};

Means means_of(const experiment::Experiment& e) {
  Means m;
  for (const experiment::CriticalPoint& p : e.along) {
    m.noise += p.of_noise / p.as_paper, m.packing += p.of_packing / p.as_paper,
        m.window += p.of_window / p.as_paper;
    m.of_static += p.quasi_static_uncertainty / p.quasi_static;
    m.over_static += p.quasi_static / p.as_paper, m.corrected_over_static += p.quasi_static / p.corrected;
  }
  const auto count = static_cast<double>(e.along.size());
  for (double* part :
       {&m.noise, &m.packing, &m.window, &m.over_static, &m.corrected_over_static, &m.of_static})
    *part /= count;
  return m;
}

/// What the band is made of, what was not evaluated being no zero: over the points, or of the mean.
std::string uncertainty_text(const ExperimentReport& report, double noise, double packing, double window) {
  const experiment::Experiment& e = report.experiment;
  std::string text;
  if (scene::follows_every_row(report.scene, e.course))
    text = "noise not evaluated (the smoothed history follows every row: they have no uncertainty)";
  else if (e.resamples < 2)
    text = fmt::format("noise not evaluated ({})", base::counted(e.resamples, "resample"));
  else
    text = fmt::format("noise {:.1f} % ({} resamples{})", 100 * noise, e.resamples,
                       e.resamples < e.resamples_asked
                           ? fmt::format(" of {}: the others give no valid crack", e.resamples_asked)
                           : "");
  text += e.specimens == 1 ? std::string(", packing scatter not evaluated (1 specimen)")
                           : fmt::format(", packing {:.1f} % ({} specimens)", 100 * packing, e.specimens);
  return text + fmt::format(", window {:.1f} %", 100 * window);
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

/// Whether the crack that was given G_IDc ran as the measured one did.
std::string verdict_of(const experiment::Application& a) {
  if (a.along.empty()) return "does not agree: the predicted crack arrested before the first point";
  if (std::isfinite(a.arrested_m))
    return fmt::format("does not agree: the predicted crack arrested at {:.4g} mm", 1e3 * a.arrested_m);
  if (a.velocity_error <= a.velocity_expected)
    return "agrees with the measured crack within the uncertainty of G_IDc";
  if (a.velocity_error <= 2.0 * a.velocity_expected)
    return "agrees with the measured crack within twice the uncertainty of G_IDc";
  return "does not agree with the measured crack within twice the uncertainty of G_IDc";
}

std::string application_text(const experiment::Experiment& e) {
  constexpr double hardly = 0.1;  // that the law rises over its velocities
  const experiment::Application& a = e.application;
  std::string text = verdict_of(a);
  if (a.along.empty()) return text;
  text += fmt::format(
      ": the predicted velocity differs by {:.1f} % rms, of which the uncertainty explains {:.1f} %, the tip "
      "position by at most {:.2f} mm, the energy released by {:.1f} %",
      100 * a.velocity_error, 100 * a.velocity_expected, 1e3 * a.worst_lag, 100 * a.rate_error);
  const double rises = e.law.back()[1] / e.law.front()[1] - 1.0;
  if (rises < hardly)
    text += fmt::format("; G_c rises by {:.0f} % only, so the velocity is poorly determined", 100 * rises);
  return text;
}

/// The length over which beams are released belongs to the scheme.
std::string zone_text(const scene::Scene& scene) {
  constexpr double long_enough = 4.0;  // mean radii   [docs/limits.md]
  const bool progressive = scene.crack.technique == fracture::Technique::progressive;
  const std::string zone = progressive ? fmt::format("r_l = {:g} mean radii", scene.crack.damage_zone_ratio)
                                       : std::string("none (simple release)");
  const bool is_short = !progressive || scene.crack.damage_zone_ratio < long_enough;
  return zone + ", a parameter of the release scheme and no property of the material" +
         (is_short ? fmt::format("; below {:g} the result depends on the lattice", long_enough)
                   : std::string());
}

/// Which Rayleigh speed the velocities are over, and the specimen's own.
std::string own_speed_text(const experiment::Experiment& e) {
  std::string text = fmt::format("over the nominal c_R, {:.0f} m/s", e.rayleigh_speed);
  if (std::isnan(e.own_rayleigh_speed)) return text + "; the specimen's own was not measured";
  return text + fmt::format(
                    "; the specimen's own is {:.0f} m/s (E {:.2f} GPa, ν {:.3f}): over it they are {:.3f} "
                    "times as large",
                    e.own_rayleigh_speed, 1e-9 * e.own_young_modulus, e.own_poisson_ratio,
                    e.rayleigh_speed / e.own_rayleigh_speed);
}

}  // namespace

Table conclusions(const ExperimentReport& report) {
  const experiment::Experiment& e = report.experiment;
  const Means m = means_of(e);
  Table table{
      {"", ""},
      {{"smoothed history", fmt::format("{}; the measured rows scatter around it by {:.3g} mm",
                                        report.smoothing, 1e3 * e.course.scatter)},
       {"standard uncertainty", uncertainty_text(report, m.noise, m.packing, m.window) +
                                    "; each ± in the table is two standard uncertainties"},
       {"damage zone", zone_text(report.scene)},
       {"quasi-static reading",
        fmt::format(
            "the quasi-static G_I0 of this lattice is on average {:.3f} times the corrected G_IDc and "
            "{:.3f} times the uncorrected one; its standard uncertainty, of packing and window, is {:.1f} %",
            m.corrected_over_static, m.over_static, 100 * m.of_static)},
       {"velocities", own_speed_text(e)}}};
  if (!report.truth.row.empty()) {
    table.rows.push_back({report.truth_name + ", corrected", truth_text(report, true)});
    table.rows.push_back({report.truth_name + ", uncorrected", truth_text(report, false)});
  }
  if (!e.application.along.empty() || std::isfinite(e.application.arrested_m))
    table.rows.push_back({"forward check", application_text(e)});
  table.rows.push_back({"balance error", fmt::format("{:.1e} of the largest energy", e.worst_residual)});
  return table;
}

Table experiment_table(const ExperimentReport& report) {
  Table table{{"tip [mm]", "time [µs]", "v [c_R]", "G_IDc ± 2u, corrected", "uncorrected ± 2u",
               "efficiency η", "quasi-static G_I0 ± 2u", "uncorrected / quasi-static"},
              {}};
  const std::vector<experiment::CriticalPoint>& along = report.experiment.along;
  const std::size_t apart = std::max<std::size_t>(1, along.size() / 12);
  for (std::size_t k = 0; k < along.size(); k += apart) {
    const experiment::CriticalPoint& p = along[k];
    table.rows.push_back({fmt::format("{:.1f}", 1e3 * p.position), fmt::format("{:.1f}", 1e6 * p.time),
                          fmt::format("{:.3f}", p.over_cr), with_band(p.corrected, p.corrected_uncertainty),
                          with_band(p.as_paper, p.uncertainty), fmt::format("{:.3f}", p.efficiency),
                          with_band(p.quasi_static, p.quasi_static_uncertainty),
                          fmt::format("{:.3f}", p.as_paper / p.quasi_static)});
  }
  return table;
}

std::string publish_text(const ExperimentReport& report) {
  const experiment::Experiment& e = report.experiment;
  const experiment::CriticalMean& m = e.mean;
  return fmt::format(
      "Publish: G_IDc = {} kJ/m² (mean over the tip from {:.1f} to {:.1f} mm at {:.3f} to {:.3f} c_R, along "
      "which it varies by {:.2g} kJ/m²; ± is two standard uncertainties: {}, lattice efficiency {:.1f} %; "
      "corrected for the lattice efficiency η = {:.3f}, uncorrected {})",
      mean_with_band(m.corrected, m.corrected_uncertainty), 1e3 * m.from, 1e3 * m.to, m.slowest, m.fastest,
      1e-3 * m.deviation_along,
      uncertainty_text(report, m.of_noise / m.as_paper, m.of_packing / m.as_paper, m.of_window / m.as_paper),
      100.0 * m.of_efficiency / m.corrected, m.efficiency, mean_with_band(m.as_paper, m.uncertainty));
}

std::string experiment_text(const ExperimentReport& report, bool color) {
  std::string text = plain_table(experiment_table(report), color) + experiment_table_note + "\n\n";
  for (const auto& row : conclusions(report).rows) text += label_line(row[0], row[1]);
  return text;
}

namespace {

Json json_of(const experiment::CriticalMean& m) {
  return {{"g_idc_corrected_j_m2", m.corrected},
          {"u_corrected_j_m2", m.corrected_uncertainty},
          {"g_idc_j_m2", m.as_paper},
          {"u_j_m2", m.uncertainty},
          {"u_noise_j_m2", m.of_noise},
          {"u_packing_j_m2", m.of_packing},
          {"u_window_j_m2", m.of_window},
          {"u_efficiency_j_m2", m.of_efficiency},
          {"efficiency", m.efficiency},
          {"deviation_along_j_m2", m.deviation_along},
          {"position_m", {m.from, m.to}},
          {"crack_velocity_over_cr", {m.slowest, m.fastest}}};
}

}  // namespace

Json experiment_json(const ExperimentReport& report) {
  const experiment::Experiment& e = report.experiment;
  const Means m = means_of(e);
  Json along = Json::array();
  for (const experiment::CriticalPoint& p : e.along)
    along.push_back({{"position_m", p.position},
                     {"time_s", p.time},
                     {"crack_velocity_over_cr", p.over_cr},
                     {"g_i0_quasi_static_j_m2", p.quasi_static},
                     {"u_quasi_static_j_m2", p.quasi_static_uncertainty},
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
            {"rayleigh_speed_m_s", e.rayleigh_speed},
            {"own_young_modulus_pa", e.own_young_modulus},
            {"own_poisson_ratio", e.own_poisson_ratio},
            {"own_rayleigh_speed_m_s", e.own_rayleigh_speed},
            {"ledger_residual", e.worst_residual},
            {"outcome", simulation::name_of(e.outcome)},
            {"wall_s", report.wall_s},
            {"publish", json_of(e.mean)},
            {"publish_text", publish_text(report)},
            {"along", along}};
  if (!e.application.along.empty())
    json["application"] = {{"verdict", verdict_of(e.application)},
                           {"velocity_error", e.application.velocity_error},
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

}  // namespace rift::studio
