#include "engine/fracture/release.hpp"
#include "studio/charts/chart_layout.hpp"
#include "studio/reports/claim_curves.hpp"
#include "studio/reports/reproduction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace rift::studio {
namespace {

using Style = ChartSeries::Style;

struct NamedSelection {
  std::string label;
  claims::Selection selection;
};

claims::Selection progressive(double relaxation, double zone) {
  return {.relaxation = relaxation, .damage_zone_ratio = zone};
}

claims::Selection with_elements(int elements, double length_m = 0.2) {
  return {.elements = elements, .length_m = length_m};
}

/// The curves of a chart against velocity, by claim.
std::vector<NamedSelection> curves_for(const std::string& claim, int elements) {
  const NamedSelection simple{"simple release", claims::simple_release()},
      surface{"simple, damped at the surface", claims::simple_release("surface")},
      total{"simple, damped everywhere", claims::simple_release("all")},
      linear{"progressive, linear, r_l = 1", {}};
  const std::map<std::string, std::vector<NamedSelection>> table{
      {"fig07", {simple}},
      {"fig08", {simple, surface, total}},
      {"fig11",
       {{"linear", progressive(1.0, 1.0)},
        {"square root", progressive(0.5, 1.0)},
        {"quadratic", progressive(2.0, 1.0)}}},
      {"fig12",
       {{"r_l = 0.5", progressive(1.0, 0.5)},
        {"r_l = 1", progressive(1.0, 1.0)},
        {"r_l = 1.5", progressive(1.0, 1.5)}}},
      {"fig14",
       {{fmt::format("{} elements", elements / 4), with_elements(elements / 4)},
        {fmt::format("{} elements", elements), with_elements(elements)},
        {fmt::format("{} elements", 4 * elements), with_elements(4 * elements)}}},
      {"fig15", {simple, surface, total, linear}},
      {"sec3_specimens", {simple, linear}},
      {"sec4_time_step",
       {{"default step", {}},
        {"0.17 of critical", {.dt_fraction = "0.17"}},
        {"0.085 of critical", {.dt_fraction = "0.085"}}}},
      {"sec4_longer", {{"200 mm", {}}, {"400 mm", with_elements(2 * elements, 0.4)}}},
      {"sec5_paths", {{"0.4 H", {.path = "0.4 H"}}, {"0.5 H", {}}, {"0.6 H", {.path = "0.6 H"}}}},
  };
  const auto found = table.find(claim);
  return found == table.end() ? std::vector<NamedSelection>{} : found->second;
}

/// Simple release, and the paper's progressive one.
std::vector<NamedSelection> both_techniques() {
  return {{"simple release", claims::simple_release()}, {"progressive, linear, r_l = 1", {}}};
}

ChartSeries ratios_of(const std::string& label, const claims::Curve& curve, int colour) {
  return series_of(label, Style::line_points, colour, curve,
                   [](const claims::CurvePoint& p) { return mean_point(p.v, p.ratio); });
}

constexpr std::size_t theories = 3;  // series of chart_of_references()

/// Sequential colours for what stands behind the theories, in its order.
void shade_from(std::vector<ChartSeries>& series, std::size_t first) {
  std::vector<ChartSeries> ordered(series.begin() + static_cast<std::ptrdiff_t>(first), series.end());
  shade_in_order(ordered);
  std::copy(ordered.begin(), ordered.end(), series.begin() + static_cast<std::ptrdiff_t>(first));
}

bool against_velocity(Chart& chart, const claims::Claim& claim, const claims::Evidence& evidence) {
  int colour = 0;
  for (const NamedSelection& named : curves_for(claim.name, evidence.elements)) {
    const claims::Curve curve = claims::curve_in(evidence, named.selection);
    if (!curve.empty()) chart.series.push_back(ratios_of(named.label, curve, colour));
    ++colour;
  }
  if (claim.name == "fig12" || claim.name == "fig14") shade_from(chart.series, theories);
  return colour > 0 && chart.series.size() > theories;
}

/// Rows of a selection and of the first specimen there is, velocities ascending.
std::vector<study::SummaryRow> first_specimen(const claims::Evidence& evidence, claims::Selection selection) {
  std::map<double, study::SummaryRow> rows;
  for (const study::SummaryRow& row : claims::rows_in(evidence, std::move(selection))) {
    const auto [known, fresh] = rows.emplace(row.crack_velocity_over_cr, row);
    if (!fresh && row.seed < known->second.seed) known->second = row;
  }
  std::vector<study::SummaryRow> list;
  for (const auto& [v, row] : rows) list.push_back(row);
  return list;
}

bool energies(Chart& chart, const claims::Evidence& evidence) {
  for (const study::SummaryRow& row : evidence.rows) {
    if (row.prestress_method != "ramp") continue;
    const study::SeriesTable table = evidence.series(row);
    if (table.empty()) continue;
    chart.x_label = "time [ms]";
    chart.y_label = "energy [J]";
    for (const char* label : {"elastic", "kinetic", "fracture", "work of the grips"})
      chart.series.push_back({.label = label, .colour = static_cast<int>(chart.series.size())});
    for (std::size_t k = 0; k < table.phase.size(); ++k) {
      const double t = 1e3 * table.at("time_s")[k];
      chart.series[0].add(t, table.at("energy_elastic_j")[k]);
      chart.series[1].add(
          t, table.at("energy_kinetic_translation_j")[k] + table.at("energy_kinetic_rotation_j")[k]);
      chart.series[2].add(t, table.at("energy_fracture_j")[k]);
      chart.series[3].add(t, table.at("work_external_j")[k]);
    }
    return true;
  }
  return false;
}

bool release_energies(Chart& chart, const claims::Evidence& evidence) {
  chart.x_label = "crack velocity v / c_R, nominal c_R [-]";
  chart.y_label = "energy at release, per beam [mJ]";
  chart.y_range = {.min = 0.0};
  int colour = 0;
  for (const NamedSelection& named : both_techniques()) {
    ChartSeries series =
        series_of(named.label, Style::line_points, colour++, first_specimen(evidence, named.selection),
                  [](const study::SummaryRow& row) {
                    return ChartPoint{row.crack_velocity_over_cr, 1e3 * claims::release_energy_per_beam(row)};
                  });
    if (!series.x.empty()) chart.series.push_back(std::move(series));
  }
  return !chart.series.empty();
}

/// Stiffness left of a beam by its distance to the tip (Fig. 9), or by its own damage (Fig. 10), one curve a
/// scheme.
bool release_laws(Chart& chart, bool over_distance) {
  chart.x_label = over_distance ? "distance ahead of the tip (s_b - a) / L_{CZM} [-]" : "damage b / l [-]";
  chart.y_label = "remaining stiffness Y_1 / Y_2 [-]";
  chart.y_range = {0.0, 1.1};
  int colour = 0;
  for (const auto& [name, power] : {std::pair{"linear", 1.0}, {"square root", 0.5}, {"quadratic", 2.0}}) {
    ChartSeries curve{.label = name, .colour = colour++};
    const fracture::ReleaseLaw law{fracture::Technique::progressive, power, 1.0};
    for (int k = over_distance ? -50 : 0; k <= (over_distance ? 150 : 100); ++k) {
      const double x = 0.01 * k;
      curve.add(
          x, over_distance ? fracture::stiffness_left(law, 0.0, x) : fracture::stiffness_left(law, x, 1.0));
    }
    chart.series.push_back(std::move(curve));
  }
  if (over_distance) chart.marks = {{0.0, 1.0, "damage zone"}};
  return true;
}

/// Fills the chart which the claim asks for; false where there is none, or nothing in it.
bool fill(Chart& chart, const claims::Claim& claim, const claims::Evidence& evidence) {
  if (claim.name == "fig09" || claim.name == "fig10") return release_laws(chart, claim.name == "fig09");
  if (claim.name == "fig05") return energies(chart, evidence);
  if (claim.name == "sec5_residual") return release_energies(chart, evidence);
  if (claim.name == "fig06") return draw_ratio_against_position(chart, evidence, claims::simple_release());
  if (claim.name == "fig13") return draw_ratio_against_position(chart, evidence, {});
  if (claim.name == "sec2_linear") return draw_fracture_against_position(chart, evidence, {});
  const std::string title = chart.title;
  chart = chart_of_references(title);
  return claim.name == "fig01" || against_velocity(chart, claim, evidence);
}

/// What a claim's chart shows, for somebody without the paper.
std::string title_of_chart(const std::string& claim) {
  static const std::map<std::string, std::string> titles{
      {"fig01", "Release rate against crack velocity by three theories"},
      {"fig05", "Energies of the whole test: tension, rest, fracture"},
      {"fig06", "Simple release: release rate against tip position"},
      {"fig07", "Simple release: release rate against crack velocity"},
      {"fig08", "Simple release, undamped and damped, against crack velocity"},
      {"fig09", "Stiffness of a beam against its distance from the tip"},
      {"fig10", "Stiffness of a beam against its damage"},
      {"fig11", "Three relaxations of progressive release against crack velocity"},
      {"fig12", "Three lengths of the damage zone against crack velocity"},
      {"fig13", "Progressive release: release rate against tip position"},
      {"fig14", "Progressive release with three numbers of elements"},
      {"fig15", "Simple, damped and progressive release against crack velocity"},
      {"sec2_linear", "Progressive release: fracture energy against tip position"},
      {"sec3_specimens", "Simple and progressive release, three specimens"},
      {"sec4_time_step", "Progressive release with three time steps"},
      {"sec4_longer", "Progressive release in plates of two lengths"},
      {"sec5_paths", "Progressive release along three crack paths"},
      {"sec5_residual", "Energy of a beam at its release against crack velocity"}};
  const auto found = titles.find(claim);
  return found == titles.end() ? claim : found->second;
}

std::string listed_numbers(const std::set<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += fmt::format("{}{:g}", text.empty() ? "" : ", ", number);
  return text;
}

/// gnuplot's svg takes no hyphen in a name.
std::string name_with(const std::string& name, const std::string& stiffness) {
  return name + (stiffness == "in-situ" ? "_in_situ" : "_" + stiffness);
}

}  // namespace

std::string scheme_text(const std::vector<study::SummaryRow>& rows) {
  std::set<std::string> techniques, relaxations;
  std::set<double> zones, alphas;
  for (const study::SummaryRow& row : rows) {
    if (!row.technique.empty()) techniques.insert(row.technique);
    if (std::isfinite(row.damping_alpha)) alphas.insert(row.damping_alpha);
    if (row.technique != "progressive") continue;
    relaxations.insert(row.relaxation_name);
    zones.insert(row.damage_zone_ratio);
  }
  if (techniques.empty()) return {};
  std::string text = fmt::format(": {} release", fmt::join(techniques, " and "));
  if (!relaxations.empty())
    text += fmt::format(", {} relaxation, r_l = {}", fmt::join(relaxations, ", "), listed_numbers(zones));
  return text + (alphas.empty() ? "" : ", α = " + listed_numbers(alphas));
}

std::vector<NamedChart> claim_charts(const claims::Claim& claim, const claims::Evidence& evidence,
                                     const std::string& stiffness) {
  const bool of_theory = claim.name == "fig01" || claim.name == "fig09" || claim.name == "fig10";
  if (of_theory && stiffness != "bulk") return {};
  Chart chart{.title = title_of_chart(claim.name)};
  if (!claim.judge || !fill(chart, claim, evidence)) return {};
  if (of_theory) return {{claim.name, claim.artefact + " of the paper.", std::move(chart)}};
  const bool bars = std::any_of(chart.series.begin(), chart.series.end(), has_error);
  const std::string caption =
      fmt::format("{} of the paper, {} beams{}{}.", claim.artefact, stiffness, scheme_text(evidence.rows),
                  bars ? "; means, bars: standard deviation between specimens" : "");
  return {{name_with(claim.name, stiffness), caption, std::move(chart)}};
}

std::vector<NamedChart> charts_over_own_speed(const claims::Evidence& evidence, const std::string& stiffness,
                                              double nominal_over_own) {
  Chart chart =
      chart_of_references("Simple and progressive release over the plate's measured Rayleigh speed");
  chart.x_label = "crack velocity over the measured Rayleigh speed v / c_R [-]";
  chart.x_range = {0.0, std::max(1.05, 1.02 * nominal_over_own)};
  int colour = 0;
  for (const NamedSelection& named : both_techniques()) {
    ChartSeries series = ratios_of(named.label, claims::curve_in(evidence, named.selection), colour++);
    for (double& x : series.x) x *= nominal_over_own;
    if (!series.x.empty()) chart.series.push_back(std::move(series));
  }
  if (chart.series.size() == theories) return {};
  return {
      {name_with("fig15_own_speed", stiffness),
       fmt::format("Fig. 15 of the paper, {} beams, against the velocity over the Rayleigh speed that this "
                   "plate shows along its edge: 1.0 c_R of the other charts is {:.3f} of it{}.",
                   stiffness, nominal_over_own, scheme_text(evidence.rows)),
       std::move(chart)}};
}

}  // namespace rift::studio
