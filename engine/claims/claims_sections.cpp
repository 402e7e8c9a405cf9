#include "engine/base/numbers.hpp"
#include "engine/claims/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rift::claims {
namespace {

constexpr double paper_step_s = 2.35e-8;
/// "About 100 steps": claims.md gives the word no margin; a tenth is ours.
constexpr double about_margin = 0.1;
/// "Linearly": what a straight line leaves unexplained, the margin of "quasi-constant".
constexpr double least_r_squared = 1.0 - constant_margin;

/// Fracture energy against tip position over the row's window.
Line line_over_window(const SeriesTable& series, const SummaryRow& row) {
  const double length = row.length_m, slack = 0.005 * length;
  const double from = row.window_over_length[0] * length - slack,
               to = row.window_over_length[1] * length + slack;
  std::vector<double> x, y;
  for (std::size_t k = 0; k < series.phase.size(); ++k) {
    const double tip = series.at("tip_m")[k];
    if (series.phase[k] != "fracture" || tip < from || tip > to) continue;
    x.push_back(tip);
    y.push_back(series.at("energy_fracture_j")[k]);
  }
  return line_through(x, y);
}

Judgement linear_growth(const Evidence& evidence, const Selection& selection) {
  double least = 1.0, at = 0.0, slope = 0.0;
  int lines = 0;
  for (const SummaryRow& row : rows_in(evidence, selection)) {
    if (!evidence.series) continue;
    const SeriesTable series = evidence.series(row);
    const Line line = series.empty() ? Line{0.0, NAN} : line_over_window(series, row);
    if (std::isnan(line.r_squared)) continue;
    ++lines;
    if (lines > 1 && line.r_squared >= least) continue;
    least = line.r_squared, at = row.crack_velocity_over_cr, slope = line.slope;
  }
  if (lines == 0) return {Verdict::not_decidable, "no series"};
  return {yes_or_no(least >= least_r_squared),
          fmt::format("R^2 at least {:.4f} over {} lines (the worst at {:g}, slope {:.3g} J/m)", least, lines,
                      at, slope)};
}

/// Share of its energy that a mode of damping ratio zeta loses in a time.
double lost(double zeta, double omega, double time) { return 1.0 - std::exp(-2.0 * zeta * omega * time); }

Judgement sec2_linear(const Evidence& evidence) {
  return all_of(
      {{"simple", linear_growth(evidence, simple_release())}, {"progressive", linear_growth(evidence, {})}});
}

Judgement sec3_specimens(const Evidence& evidence) {
  std::vector<Part> parts;
  for (const Selection& s : {simple_release(), Selection{}}) {
    const Curve curve = curve_in(evidence, s);
    const bool several =
        std::any_of(curve.begin(), curve.end(), [](const CurvePoint& p) { return p.ratio.size() > 2; });
    const double scatter = specimen_scatter(curve);
    parts.push_back(
        {s.technique,
         {several ? yes_or_no(scatter <= influence_margin) : Verdict::not_decidable,
          fmt::format("standard deviation {:.3f}, mean over {} velocities", scatter, curve.size())}});
  }
  return all_of(parts);
}

Judgement sec3_damping(const Evidence& evidence) {
  for (const SummaryRow& row : rows_in(evidence, simple_release("all"))) {
    if (std::abs(row.crack_velocity_over_cr - 0.1) > 1e-9) continue;
    const double dt = row.dt_critical_s, damped = row.dt_critical_damped_s;
    const double zeta_top = 0.5 * (dt / damped - damped / dt);  // damped = dt (sqrt(1 + zeta^2) - zeta)
    const double omega_top = 2.0 / dt;
    const double shear_speed =
        std::sqrt(row.young_modulus_pa / (2.0 * (1.0 + row.poisson_ratio)) / row.density_kg_m3);
    const double omega_first = std::numbers::pi * shear_speed / row.height_m;
    const double zeta_first = zeta_top * omega_first / omega_top;
    const double time = row.steps * row.dt_s;
    const double top = lost(zeta_top, omega_top, time), first = lost(zeta_first, omega_first, time);
    return {yes_or_no(first <= influence_margin && top > influence_margin),
            fmt::format("at 0.1 c_R, in {:.2f} ms: the highest mode loses {:.1f} % of its energy (damping "
                        "ratio {:.2g}, from the damped critical step), the plate's first shear mode {:.2g} % "
                        "(in proportion to the frequencies, {:.3g} and {:.3g} rad/s)",
                        1e3 * time, 100.0 * top, zeta_top, 100.0 * first, omega_top, omega_first)};
  }
  return {Verdict::not_decidable, "no result"};
}

Judgement sec4_time_step(const Evidence& evidence) {
  Selection paper, half;
  paper.dt_fraction = "0.17", half.dt_fraction = "0.085";
  const std::vector<SummaryRow> rows = rows_in(evidence, paper);
  if (rows.empty()) return {Verdict::not_decidable, "no result"};
  const SummaryRow& row = rows.front();
  const double zone = row.mean_radius_m, over_length = zone / row.length_m;
  const double steps = zone / (row.rayleigh_speed_m_s * paper_step_s);  // for a beam at 1.0 c_r
  const bool about = std::abs(steps / 10.0 - 1.0) <= about_margin;
  const auto of_paper = [&](bool yes) {  // lengths are those of 20,000 elements
    return evidence.elements == paper_elements ? yes_or_no(yes) : Verdict::not_decidable;
  };
  return all_of(
      {{"L_CZM",
        {of_paper(std::abs(1e3 * zone - 0.49) <= 0.005 && std::abs(over_length - 0.0024) <= 0.00005 * 1.001),
         fmt::format("{:.4f} mm, {:.5f} L", 1e3 * zone, over_length)}},
       {"about 100 steps at 0.1, 10 at 1.0",
        {of_paper(about), fmt::format("{:.0f} and {:.1f} with the paper's 2.35e-8 s", 10.0 * steps, steps)}},
       {"half the paper's step", has_no_influence(curve_in(evidence, half), curve_in(evidence, paper), {})},
       {"the paper's step against the default",
        has_no_influence(curve_in(evidence, paper), curve_in(evidence, {}), {})}});
}

Judgement sec4_longer(const Evidence& evidence) {
  Selection selection;
  selection.length_m = 0.4;
  selection.elements = 2 * evidence.elements;
  const Curve all = curve_in(evidence, {}), longer = curve_of(evidence.rows, selection);
  Curve shorter;
  for (const CurvePoint& p : longer)
    for (const CurvePoint& same : within(all, p.v, p.v)) shorter.push_back(same);
  if (longer.empty() || shorter.size() != longer.size()) return {Verdict::not_decidable, "no result"};
  const double near = mean_distance(shorter), far = mean_distance(longer), scatter = specimen_scatter(longer);
  const Verdict verdict =
      scatter > influence_margin ? Verdict::not_decidable : yes_or_no(far >= near - influence_margin);
  return {verdict,
          fmt::format("mean |delta| {:.3f} at 400 mm against {:.3f} at 200 mm, {} velocities, scatter {:.3f}",
                      far, near, longer.size(), scatter)};
}

Judgement sec5_paths(const Evidence& evidence) {
  const Curve middle = curve_in(evidence, {});
  std::vector<Part> parts;
  for (const std::string path : {"0.4 H", "0.6 H"}) {
    Selection selection;
    selection.path = path;
    const Curve curve = curve_in(evidence, selection);
    std::vector<double> distances;
    double scatter = specimen_scatter(curve);
    for (const CurvePoint& p : curve)
      for (const CurvePoint& same : within(middle, p.v, p.v))
        distances.push_back(std::abs(base::mean_of(p.ratio) - base::mean_of(same.ratio)));
    if (distances.empty()) return {Verdict::not_decidable, "no result"};
    const double distance = base::mean_of(distances), allowed = std::max(scatter, influence_margin);
    parts.push_back({path,
                     {yes_or_no(distance <= allowed),
                      fmt::format("mean |difference| {:.3f} over {} velocities, scatter {:.3f}", distance,
                                  distances.size(), scatter)}});
  }
  return all_of(parts);
}

Judgement sec5_residual(const Evidence& evidence) {
  std::vector<Part> parts;
  for (const Selection& s : {simple_release(), Selection{}}) {
    std::string list;
    std::vector<double> at_one;
    for (double v : {0.1, 0.5, 1.0}) {
      std::vector<double> energies;  // per released beam [J]
      for (const SummaryRow& row : rows_in(evidence, s))
        if (std::abs(row.crack_velocity_over_cr - v) <= 1e-9)
          energies.push_back(release_energy_per_beam(row));
      if (energies.empty()) return {Verdict::not_decidable, fmt::format("no result at {:g} c_R", v)};
      list +=
          fmt::format("{}{:.3g} mJ at {:.1f}", list.empty() ? "" : ", ", 1e3 * base::mean_of(energies), v);
      at_one = energies;
    }
    const double least = base::mean_of(at_one), scatter = scatter_of(at_one);
    parts.push_back(
        {s.technique,
         {scatter > std::abs(least) ? Verdict::not_decidable : yes_or_no(least > 0.0),
          fmt::format("the release of a beam dissipates {}, scatter {:.2g} mJ", list, 1e3 * scatter)}});
  }
  return all_of(parts);
}

Judgement sec5_bending(const Evidence& evidence) {
  constexpr double slight = 0.05;  // of the thickness
  std::vector<double> slow, fast;
  for (const SummaryRow& row : rows_in(evidence, {})) {
    const double moved = row.out_of_plane_m / row.thickness_m, v = row.crack_velocity_over_cr;
    if (std::isnan(moved)) continue;
    if (v < 0.1 + 1e-9) slow.push_back(moved);
    if (v > 0.5 - 1e-9) fast.push_back(moved);
  }
  if (slow.empty() || fast.empty()) return {Verdict::not_decidable, "no result"};
  const double low = base::mean_of(slow), high = base::mean_of(fast), scatter = scatter_of(slow);
  const std::string text = fmt::format(
      "largest motion along z of a region 8 radii wide: {:.2f} % of the thickness at 0.1 c_R and below "
      "(scatter {:.2f} %), {:.2f} % at 0.5 c_R and above",
      100.0 * low, 100.0 * scatter, 100.0 * high);
  if (scatter > std::abs(low - high)) return {Verdict::not_decidable, text};
  return {yes_or_no(low <= slight && low > high), text};
}

}  // namespace

std::vector<Claim> claims_of_sections() {
  return {
      {"sec2_linear",
       "Section 2.4",
       "The fracture energy grows linearly with the crack over the window.",
       {"sec2_linear"},
       sec2_linear},
      {"sec3_specimens",
       "Section 3",
       "Three specimens differ negligibly.",
       {"sec3_specimens"},
       sec3_specimens},
      {"sec3_damping",
       "Section 3.2",
       "Such a small damping hardly changes the behaviour of the structure: only frequencies near the "
       "highest are damped.",
       {"sec3_damping"},
       sec3_damping},
      {"sec4_time_step",
       "Section 4.2",
       "L_CZM = 0.49 mm = 0.0024 L; a beam takes about 100 steps to degrade at 0.1 c_R and 10 at 1.0 c_R; a "
       "smaller time step changes nothing.",
       {"sec4_time_step", "fig13_pnrt_position"},
       sec4_time_step},
      {"sec4_longer",
       "Section 4.2",
       "A longer plate will not offer better results.",
       {"sec4_longer", "fig13_pnrt_position"},
       sec4_longer},
      {"sec5_paths",
       "Section 5",
       "One specimen serves many paths: at 0.4, 0.5, 0.6 H the ratio is the same within scatter.",
       {"sec5_paths"},
       sec5_paths},
      {"sec5_residual",
       "Section 5",
       "Broken beams keep a minimum of energy.",
       {"sec5_residual"},
       sec5_residual},
      {"sec5_bending",
       "Section 5",
       "Slight out-of-plane bending at low velocity: at most 5 % of the thickness, and more at 0.1 c_R and "
       "below than at 0.5 c_R and above.",
       {"sec5_bending", "fig13_pnrt_position"},
       sec5_bending},
  };
}

}  // namespace rift::claims
