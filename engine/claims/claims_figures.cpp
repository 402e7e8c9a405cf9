#include "engine/base/numbers.hpp"
#include "engine/claims/claims.hpp"
#include "engine/claims/cylinders.hpp"
#include "engine/fracture/release.hpp"
#include "engine/theory/references.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rift::claims {
namespace {

Selection scheme(double relaxation) {
  Selection s;
  s.relaxation = relaxation;
  return s;
}

Selection zone(double ratio) {
  Selection s;
  s.damage_zone_ratio = ratio;
  return s;
}

constexpr Span all_velocities{};

/// "Less than 6 % of the beams are damped", which is said of the paper's plate: in one of fewer elements the
/// path crosses a larger share of the beams, as one over the square root of their number. Such a plate has
/// its share scaled to the paper's.
Judgement few_beams_damped(const Evidence& evidence) {
  std::vector<double> shares;
  const double smaller = std::min(1.0, evidence.elements / static_cast<double>(paper_elements));
  for (const SummaryRow& row : rows_in(evidence, simple_release("surface")))
    shares.push_back(row.beams_damped / row.beams * std::sqrt(smaller));
  if (shares.empty() || std::isnan(base::mean_of(shares))) return {Verdict::not_decidable, "no result"};
  const double most = *std::max_element(shares.begin(), shares.end());
  return {yes_or_no(most < 0.06),
          fmt::format("{:.1f} %{}", 100.0 * most,
                      smaller < 1 ? fmt::format(", scaled to {} elements", paper_elements) : "")};
}

Judgement fig01(const Evidence&) {
  double farthest = 0.0, at = 0.0;
  for (int k = 0; k <= 100; ++k) {
    const double v = 0.01 * k, away = std::abs(theory::broberg(v, 0.3, theory::Plane::stress).g - (1.0 - v));
    if (away > farthest) farthest = away, at = v;
  }
  return {Verdict::not_decidable,
          fmt::format("Broberg's factor departs from 1 - v/c_R by at most {:.3f} (at {:g} c_R); the paper's "
                      "finite-element points are not in the text",
                      farthest, at)};
}

struct Times {
  double loading = 0, hold = 0, end = 0;  // [s]
  double stored = 0, change_elastic = 0, change_other = 0, most_kinetic = 0;
};

Times times_of(const SeriesTable& s) {
  Times t;
  std::size_t start = 0;
  for (std::size_t k = 0; k < s.phase.size(); ++k) {
    const double kinetic = s.at("energy_kinetic_translation_j")[k] + s.at("energy_kinetic_rotation_j")[k];
    const double time = s.at("time_s")[k];
    if (s.phase[k] != "fracture") t.most_kinetic = std::max(t.most_kinetic, kinetic), start = k;
    (s.phase[k] == "loading" ? t.loading : s.phase[k] == "hold" ? t.hold : t.end) = time;
  }
  const auto other = [&](std::size_t k) {
    return s.at("energy_kinetic_translation_j")[k] + s.at("energy_kinetic_rotation_j")[k] +
           s.at("energy_fracture_j")[k];
  };
  const std::size_t last = s.phase.size() - 1;
  t.stored = s.at("energy_elastic_j")[start];
  t.change_elastic = s.at("energy_elastic_j")[last] - t.stored;
  t.change_other = other(last) - other(start);
  return t;
}

Judgement fig05(const Evidence& evidence) {
  for (const SummaryRow& row : evidence.rows) {
    if (row.prestress_method != "ramp" || !evidence.series) continue;
    const SeriesTable series = evidence.series(row);
    if (series.empty()) continue;
    const Times t = times_of(series);
    const auto near_ms = [](double s, double ms) { return std::abs(1e3 * s - ms) < 0.0101; };
    const double inertia = t.most_kinetic / t.stored;
    return all_of({{"times",
                    {yes_or_no(near_ms(t.loading, 0.47) && near_ms(t.hold, 0.71) && near_ms(t.end, 1.16)),
                     fmt::format("tension to {:.3f} ms, stabilisation to {:.3f} ms, fracture to {:.3f} ms",
                                 1e3 * t.loading, 1e3 * t.hold, 1e3 * t.end)}},
                   {"kinetic and fracture energy rise as elastic falls",
                    {yes_or_no(t.change_elastic < 0.0 && t.change_other > 0.0),
                     fmt::format("{:+.2f} J against {:+.2f} J", t.change_other, t.change_elastic)}},
                   {"inertia of the loading below 1 %",
                    {yes_or_no(inertia < 0.01),
                     fmt::format("at most {:.2f} % of the stored energy, {:.3g} % when the crack starts",
                                 100.0 * inertia, 100.0 * row.prestress_kinetic_fraction)}}});
  }
  return {Verdict::not_decidable, "no series"};
}

Judgement fig06(const Evidence& evidence) {
  const Curve simple = curve_in(evidence, simple_release());
  return all_of({{"quasi-constant for most", is_mostly_constant(simple, all_velocities)},
                 {"tends to 0 at 1.0", is_near_value(simple, 1.0, 0.0)}});
}

Judgement fig07(const Evidence& evidence) {
  const Curve simple = curve_in(evidence, simple_release());
  return all_of({{"agrees only in 0.6-1.0", agrees_only_in(simple, {0.6, 1.0})},
                 {"below 0.4 at 0.01", is_below(simple, 0.01, 0.4)}});
}

Judgement fig08(const Evidence& evidence) {
  const Curve bare = curve_in(evidence, simple_release()),
              surface = curve_in(evidence, simple_release("surface")),
              total = curve_in(evidence, simple_release("all"));
  return all_of({{"surface closer than undamped", is_better(surface, bare, all_velocities)},
                 {"total closer than undamped", is_better(total, bare, all_velocities)},
                 {"surface too low", is_too_low(surface, {0.01, 0.4})},
                 {"total too low", is_too_low(total, {0.01, 0.4})},
                 {"surface too high", is_too_high(surface, {0.4, 0.8})},
                 {"total too high", is_too_high(total, {0.4, 0.8})},
                 {"total better than surface", is_better(total, surface, {0.01, 0.4})},
                 {"less than 6 % of beams damped at the surface", few_beams_damped(evidence)}});
}

Judgement fig09(const Evidence&) {
  const fracture::ReleaseLaw law{fracture::Technique::progressive, 1.0, 1.0};
  const double ahead = fracture::stiffness_left(law, 0.0, 1.0),
               middle = fracture::stiffness_left(law, 0.0, 0.5),
               at_tip = fracture::stiffness_left(law, 0.0, 0.0);
  return {yes_or_no(ahead == 1.0 && middle > 0.0 && middle < 1.0 && at_tip == 0.0),
          fmt::format("remaining stiffness {:g} at L_CZM ahead of the tip, {:g} half way, {:g} at the tip",
                      ahead, middle, at_tip)};
}

Judgement fig10(const Evidence&) {
  std::string text = "remaining stiffness at b/l = 0, 1/2, 1:";
  std::vector<double> half;
  bool ends = true;
  for (const auto& [name, power] : {std::pair{"linear", 1.0}, {"square root", 0.5}, {"quadratic", 2.0}}) {
    const fracture::ReleaseLaw law{fracture::Technique::progressive, power, 1.0};
    const auto left = [&](double b) { return fracture::stiffness_left(law, b, 1.0); };  // b = a + l - s_b
    text += fmt::format(" {} {:g}, {:.3f}, {:g};", name, left(0.0), left(0.5), left(1.0));
    half.push_back(left(0.5));
    ends = ends && left(0.0) == 1.0 && left(1.0) == 0.0;
  }
  return {yes_or_no(ends && half[1] > half[0] && half[0] > half[2]), text.substr(0, text.size() - 1)};
}

Judgement fig11(const Evidence& evidence) {
  return all_of({{"linear near", is_near(curve_in(evidence, scheme(1.0)), all_velocities)},
                 {"quadratic near", is_near(curve_in(evidence, scheme(2.0)), all_velocities)},
                 {"square root too low", is_too_low(curve_in(evidence, scheme(0.5)), {0.05, 0.4})}});
}

Judgement fig12(const Evidence& evidence) {
  const Curve one = curve_in(evidence, zone(1.0)), longer = curve_in(evidence, zone(1.5)),
              shorter = curve_in(evidence, zone(0.5));
  return all_of({{"1 better than 1.5", is_better(one, longer, all_velocities)},
                 {"1 better than 0.5", is_better(one, shorter, all_velocities)},
                 {"1.5 too high", is_too_high(longer, {0.2, 0.8})},
                 {"0.5 too low", is_too_low(shorter, {0.01, 0.6})}});
}

Judgement fig13(const Evidence& evidence) {
  const Curve progressive = curve_in(evidence, {});
  std::vector<Part> parts{
      {"tends to 1 at 0.01", is_near_value(progressive, 0.01, 1.0)},
      {"constant from 20 % of the length for most", is_mostly_constant(progressive, {0.01, 0.8})}};
  for (double v : {0.9, 1.0}) {
    const Curve at = within(progressive, v, v);
    parts.push_back(
        {fmt::format("constant from 40 % at {:.1f}", v),
         at.empty() ? Judgement{Verdict::not_decidable, "no result"} : is_quasi_constant(at.front())});
  }
  return all_of(parts);
}

Judgement fig14(const Evidence& evidence) {
  const Curve few = curve_of_elements(evidence, 0.25), paper = curve_of_elements(evidence, 1.0),
              many = curve_of_elements(evidence, 4.0);
  const Span span{0.05, 1.0};
  return all_of({{"a quarter of the elements", has_no_influence(few, paper, span)},
                 {"four times the elements", has_no_influence(many, paper, span)},
                 {"four times, at 0.05 (paper 0.002)", differs_by(many, paper, 0.05, 0.002)},
                 {"four times, at 1.0 (paper 0.018)", differs_by(many, paper, 1.0, 0.018)}});
}

/// "Above 0, and tending to it with more elements", at 1.0 c_r.
Judgement tends_to_zero(const Evidence& evidence) {
  std::vector<double> ratio, scatter;
  std::string list;
  for (double factor : {0.25, 1.0, 4.0}) {
    const Curve at = within(curve_of_elements(evidence, factor), 1.0, 1.0);
    if (at.empty())
      return {Verdict::not_decidable, fmt::format("no result at {:g} times the elements", factor)};
    ratio.push_back(base::mean_of(at.front().ratio));
    scatter.push_back(specimen_scatter(at));
    list += fmt::format("{}{:.3f} at {:.0f} elements", list.empty() ? "" : ", ", ratio.back(),
                        factor * evidence.elements);
  }
  const double noise = base::mean_of(scatter);
  const bool falls = ratio[0] > ratio[1] && ratio[1] > ratio[2] && ratio[2] > 0.0;
  const Verdict verdict = noise > std::abs(ratio[0] - ratio[2]) ? Verdict::not_decidable
                          : falls                               ? Verdict::holds
                                                                : Verdict::does_not_hold;
  return {verdict, fmt::format("{}, scatter {:.3f}", list, noise)};
}

Judgement fig15(const Evidence& evidence) {
  const Curve progressive = curve_in(evidence, {});
  std::vector<Part> parts;
  for (const std::string region : {"none", "surface", "all"})
    parts.push_back({fmt::format("better than simple release, damping {}", region),
                     is_better(progressive, curve_in(evidence, simple_release(region)), all_velocities)});
  parts.push_back({"too low below 0.4", is_too_low(progressive, {0.01, 0.3})});
  if (!evidence.one_size) parts.push_back({"at 1.0 above 0 and tending to it", tends_to_zero(evidence)});
  return all_of(parts);
}

Judgement table1(const Evidence& evidence) {
  constexpr double rounding = 1e-10;
  for (const SummaryRow& row : evidence.rows) {
    const double residual = row.ledger_residual;
    if (row.precision != "double" || std::isnan(residual)) continue;
    return {yes_or_no(residual <= rounding),
            fmt::format("balance error {:.1e} over {:.0f} steps", residual, row.steps)};
  }
  return {Verdict::not_decidable, "no result"};
}

/// A claim that is a picture of its one preset.
Claim picture(std::string name, std::string artefact, std::string text, std::string preset,
              std::vector<double> at) {
  return {.name = std::move(name),
          .artefact = std::move(artefact),
          .text = std::move(text),
          .needs = {std::move(preset)},
          .standing = "a picture",
          .pictures_at = std::move(at)};
}

/// The claim about cylinders instead of plates.
Claim of_cylinders(Claim claim) {
  claim.calibration = true;
  return claim;
}

}  // namespace

std::vector<Claim> claims_of_figures() {
  return {
      {"fig01",
       "Fig. 1",
       "The analytic correction factor falls quasi-linearly from 1 at 0 to 0 at c_R (Broberg).",
       {},
       fig01},
      picture("fig02", "Fig. 2", "A discrete lattice: elements and their beams, drawn.", "fig02_lattice",
              {0}),
      picture("fig03", "Fig. 3", "The plate's geometry with its boundary conditions, drawn.",
              "fig03_geometry", {0}),
      picture("fig04", "Fig. 4",
              "Frames of the running crack, coloured by vertical displacement, the tip marked.",
              "fig04_frames", {0.25, 0.6, 0.95}),
      {"fig05",
       "Fig. 5",
       "Energy balance at 0.2 c_R: tension to 0.47 ms, stabilisation to 0.71 ms, fracture to 1.16 ms; "
       "kinetic and fracture energy rise as elastic energy falls; inertia of the loading below 1 % of the "
       "total.",
       {"fig05_energy_balance"},
       fig05},
      {"fig06",
       "Fig. 6",
       "S-NRT: the ratio is quasi-constant after 20 % of the length for most velocities and tends to 0 at "
       "1.0 c_R.",
       {"fig06_snrt_position"},
       fig06},
      {"fig07",
       "Fig. 7",
       "S-NRT agrees with the analytic curve only in 0.6-1.0 c_R; below 0.4 at 0.01 c_R.",
       {"fig07_snrt_velocity"},
       fig07},
      {"fig08",
       "Fig. 8",
       "S-NRT damped at the crack surface (< 6 % of beams) or everywhere: closer than undamped; too low in "
       "0.01-0.4 c_R, too high in 0.4-0.8 c_R; total damping better than surface damping in 0.01-0.4 c_R.",
       {"fig07_snrt_velocity", "fig08_snrt_damping", "fig08_snrt_surface"},
       fig08},
      {"fig09",
       "Fig. 9",
       "The damage zone: beams are intact from L_CZM ahead of the tip on, lose stiffness within it, and are "
       "released at the tip.",
       {},
       fig09},
      {"fig10",
       "Fig. 10",
       "The three relaxation schemes (eqs. 9-11): from 1 to 0 over the zone, square root above linear above "
       "quadratic.",
       {},
       fig10},
      {"fig11",
       "Fig. 11",
       "P-NRT at r_l = 1: linear and quadratic are near the analytic curve; square root is too low in "
       "0.05-0.4 c_R.",
       {"fig11_relaxation"},
       fig11},
      {"fig12",
       "Fig. 12",
       "Linear scheme: r_l = 1 is best; 1.5 too high in 0.2-0.8 c_R; 0.5 too low in 0.01-0.6 c_R.",
       {"fig12_damage_zone"},
       fig12},
      {"fig13",
       "Fig. 13",
       "P-NRT (linear, r_l = 1): tends to 1 at 0.01 c_R; constant from 10-20 % of the length, above 0.8 c_R "
       "from about 40 %.",
       {"fig13_pnrt_position"},
       fig13},
      {"fig14",
       "Fig. 14",
       "5,000, 20,000 and 80,000 elements: almost no influence; between the last two 0.002 at 0.05 c_R and "
       "0.018 at 1.0 c_R.",
       {"fig14_elements"},
       fig14},
      {"fig15",
       "Fig. 15",
       "P-NRT is best of all; too low below 0.4 c_R; at 1.0 c_R above 0 and tending to it with more "
       "elements.",
       {"fig15_all", "fig08_snrt_damping", "fig08_snrt_surface", "fig14_elements"},
       fig15},
      of_cylinders(picture("fig16", "Fig. 16", "Cylinders of 750, 5,500 and 35,000 elements, drawn.",
                           "fig16_cylinders", {0})),
      of_cylinders({"fig17",
                    "Fig. 17",
                    "E and ν of compressed cylinders, five packings each, converge: within 2.5 % above "
                    "15,000 elements; micro parameters are scanned, interpolated and selected.",
                    {"fig17_calibration"},
                    cylinders_converge}),
      {"table1",
       "Table 1",
       "The velocity Verlet scheme, which conserves K + U - C: with it the balance error of the whole test "
       "of Fig. 5 stays below 1e-10 (the tests check its second order).",
       {"fig05_energy_balance"},
       table1},
      of_cylinders({"table2",
                    "Table 2",
                    "E_M = 10.3 GPa, ν_M = 0.3 from E_µ = 356 GPa, ν_µ = 0.3, r_µ = 0.3.",
                    {"table2_elastic_parameters"},
                    cylinders_meet_table2}),
  };
}

}  // namespace rift::claims
