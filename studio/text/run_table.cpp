#include "studio/text/run_table.hpp"

#include "engine/base/text.hpp"
#include "engine/scene/needs.hpp"
#include "studio/text/progress.hpp"
#include "studio/text/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace rift::studio {
namespace {

using results::LaneSummary;

std::string predicted(const LaneSummary& s) {
  return !std::isnan(s.arrest_m) ? fmt::format("predicted velocity, arrested at {:.4g} mm", 1e3 * s.arrest_m)
                                 : "predicted velocity";
}

bool breaks_freely(const LaneSummary& s) { return s.crack_course == "free"; }

std::string title(const LaneSummary& s) {
  if (breaks_freely(s)) return fmt::format("free crack, {} beams, {} stiffness", s.technique, s.stiffness);
  const bool progressive = s.technique == "progressive";
  const std::string how =
      progressive ? fmt::format("progressive release, {}, r_l = {:g}", s.relaxation_name, s.damage_zone_ratio)
                  : "simple release";
  const std::string damping =
      s.damping_region == "none" ? "" : fmt::format(", damping {:g} ({})", s.damping_alpha, s.damping_region);
  const std::string faces = !std::isnan(s.friction) ? fmt::format(", friction {:g}", s.friction) : "";
  const std::string speed = !std::isnan(s.crack_velocity_over_cr)
                                ? fmt::format("{:g} c_R", s.crack_velocity_over_cr)
                            : s.crack_course == "measured"  ? "measured history"
                            : s.crack_course == "by itself" ? predicted(s)
                                                            : "piecewise velocity";
  const char* tips = s.tips == 2 ? ", two tips" : "";
  return fmt::format("{}{}, {}{}{}, {} stiffness", speed, tips, how, damping, faces, s.stiffness);
}

/// Why the ratio is not defined.
std::string why_undefined(const LaneSummary& s) {
  if (s.outcome == "stopped") return "the run was stopped before the tip had crossed the measuring window";
  if (s.outcome == "diverged") return "the run diverged before the tip had crossed the measuring window";
  if (!s.steering.empty()) return "the run was steered while the tip crossed the measuring window";
  return "the tip did not cross the measuring window";
}

std::string ratios(const LaneSummary& s) {
  const std::string window =
      fmt::format("{:.4g} to {:.4g} of the length", s.window_over_length[0], s.window_over_length[1]);
  if (std::isnan(s.ratio))
    return label_line("G_ID / G_I0", fmt::format("not defined: {}, {}", why_undefined(s), window));
  std::string out =
      label_line("G_ID / G_I0", fmt::format("{:.3f} ± {:.3f} along the window, {} {}", s.ratio,
                                            s.ratio_scatter, s.tips == 2 ? "half length" : "tip at", window));
  out += label_line("  of released beams", number_cell(s.ratio_fracture, "{:.3f}"));
  return out + label_line("  paper, eq. (7)",
                          fmt::format("{:.3f} with the kinetic energy of translation alone", s.ratio_paper));
}

std::string theory(const LaneSummary& s) {
  const std::string factors =
      std::isnan(s.broberg) ? std::string("not defined: it needs a constant velocity up to c_R")
                            : fmt::format("Broberg {:.3f}   Freund {:.3f}   strip {}", s.broberg, s.freund,
                                          std::isnan(s.strip) ? "not defined" : number_cell(s.strip, "{:g}"));
  std::string out = label_line("theory", factors);
  if (!std::isnan(s.echo_free_over_length))
    out += label_line("", fmt::format("first boundary reflection reaches the tip at {:.3f} of the length",
                                      s.echo_free_over_length));
  const char* reference = s.g_i0_reference == "griffith" ? "(griffith, mean)" : "of the strip";
  const std::string g_id =
      std::isnan(s.g_id_j_m2) ? std::string() : fmt::format("   G_ID {:.5g} kJ/m²", 1e-3 * s.g_id_j_m2);
  return out + label_line("G_I0", fmt::format("{:.5g} kJ/m² {}{}", 1e-3 * s.g_i0_j_m2, reference, g_id));
}

/// What became of beams that break by themselves.
std::string broken_beams(const LaneSummary& s) {
  std::string out = label_line(
      "beams", s.beams_broken > 0 ? fmt::format("{:.0f} broken, the first at {:.4g} µs; {:.0f} softened",
                                                s.beams_broken, 1e6 * s.first_broken_s, s.beams_softened)
                                  : fmt::format("none broken; {:.0f} softened", s.beams_softened));
  if (!std::isnan(s.crack_leading_m))
    out += label_line("  leading position", fmt::format("{:.4g} mm", 1e3 * s.crack_leading_m));
  if (!std::isnan(s.fracture_energy_over_gc))
    out += label_line(
        "  fracture energy",
        fmt::format("{:.3f} of G_c times the advance of the leading position, all branches counted in",
                    s.fracture_energy_over_gc));
  out += label_line("G_c", fmt::format("{:.5g} J/m², kappa {:g}", s.release_rate_j_m2, s.kappa));
  if (std::isnan(s.strength_pa)) return out;
  const std::string lowered = s.strength_pa < s.strength_wished_pa
                                  ? fmt::format(", lowered from {:.4g} MPa: this lattice resolves no more",
                                                1e-6 * s.strength_wished_pa)
                                  : "";
  return out + label_line("strength", fmt::format("{:.4g} MPa{}", 1e-6 * s.strength_pa, lowered));
}

/// Joule to two decimals, and no "-0.00"; in the unit in which the largest of the balance has them.
struct EnergyUnit {
  const char* label;
  double joule;
  double operator()(double energy) const { return std::round(1e2 * energy / joule) / 1e2 + 0.0; }
};

EnergyUnit energy_unit(const LaneSummary& s) {
  double largest = s.energy_initial_j;
  for (const double energy : {s.energy_elastic_j, s.energy_fracture_j, s.work_external_j,
                              s.energy_kinetic_translation_j + s.energy_kinetic_rotation_j})
    largest = std::max(largest, std::abs(energy));
  return largest < 0.1 ? EnergyUnit{"energy [mJ]", 1e-3} : EnergyUnit{"energy [J]", 1.0};
}

std::string energy_balance(const LaneSummary& s, bool color) {
  const bool closes = s.ledger_closes;
  const char *red = color && !closes ? "\x1b[31m" : "", *plain = color && !closes ? "\x1b[0m" : "";
  const EnergyUnit hundredths = energy_unit(s);
  const std::string contact =
      std::isnan(s.friction) ? ""
                             : fmt::format(", {:.2f} contact of the faces", hundredths(s.energy_contact_j));
  std::string out = label_line(
      hundredths.label,
      fmt::format(
          "{:.2f} stored{}; at the end {:.2f} elastic, {:.2f} kinetic, {:.2f} fracture, {:.2f} damping{}",
          hundredths(s.energy_initial_j),
          breaks_freely(s) ? fmt::format(", {:.2f} work of the load", hundredths(s.work_external_j)) : "",
          hundredths(s.energy_elastic_j),
          hundredths(s.energy_kinetic_translation_j + s.energy_kinetic_rotation_j),
          hundredths(s.energy_fracture_j), hundredths(s.energy_damping_j + s.energy_numerical_damping_j),
          contact));
  const std::string limit =
      std::isnan(s.ledger_limit) ? std::string() : fmt::format(", limit {:.0e}", s.ledger_limit);
  out += label_line("balance error", fmt::format("{}{} of the largest energy{}{}{}", red,
                                                 number_cell(s.ledger_residual, "{:.1e}"), limit,
                                                 closes ? "" : ": THE ENERGY BALANCE DOES NOT CLOSE", plain));
  if (s.prestress_method == "ramp")
    out += label_line(
        "ramp", fmt::format("stored energy {:.4f} of the static solve, kinetic {:.1e} of the stored energy",
                            s.prestress_energy_over_static, s.prestress_kinetic_fraction));
  return out;
}

std::string lattice(const LaneSummary& s) {
  std::string out =
      label_line("lattice", fmt::format("{:.0f} elements, {:.0f} beams ({:.0f} crossed), {}, coordination {}",
                                        s.elements, s.beams, s.beams_crossed,
                                        base::counted(std::llround(s.rattlers), "rattler"),
                                        number_cell(s.coordination, "{:.3f}")));
  out += label_line(
      "", fmt::format("mean radius {:.4f} mm, beam modulus {:.1f} GPa, {} kg/m³", 1e3 * s.mean_radius_m,
                      1e-9 * s.micro_young_modulus_pa, number_cell(s.density_kg_m3, "{:.1f}")));
  out += label_line("step", fmt::format("{:.3e} s, {:.3g} of the critical step; {:.0f} steps{}", s.dt_s,
                                        s.dt_fraction, s.steps,
                                        !std::isnan(s.steps_per_beam)
                                            ? fmt::format(", {:.1f} steps per beam release", s.steps_per_beam)
                                            : std::string()));
  return out;
}

std::string clock(const LaneSummary& s) {
  return std::isnan(s.history_clock_s) ? std::string()
                                       : label_line("clock", history_clock_text(s.history_clock_s));
}

std::string costs(const LaneSummary& s) {
  const auto cached = [](bool from_cache) { return from_cache ? " (cached)" : ""; };
  return label_line("time",
                    fmt::format("packing {}{}, pre-stress {}{}, crack {}; {} in total, {:.0f} MB",  //
                                duration_text(s.wall_packing_s), cached(s.packing_from_cache),
                                duration_text(s.wall_prestress_s), cached(s.prestress_from_cache),
                                duration_text(s.wall_fracture_s), duration_text(s.wall_total_s),
                                1e-6 * s.memory_peak_bytes)) +
         label_line("",
                    fmt::format("{} element-steps/s, {} beam-steps/s", magnitude_text(s.element_steps_per_s),
                                magnitude_text(s.beam_steps_per_s)));
}

/// What the scenario leaves out; and how many times as long a step would take with each part of which that is
/// measured, with one scenario in double to eight in single precision.
std::string left_out(const LaneSummary& s) {
  std::vector<std::string> names, with;
  for (const std::string& name : s.left_out) {
    std::string& words = names.emplace_back(name);
    std::replace(words.begin(), words.end(), '_', ' ');
    const scene::OptionalPart* part = scene::find_optional_part(name);
    if (part != nullptr && std::isfinite(part->step_factor[1]))
      with.push_back(fmt::format("with {} a step would take {:g} to {:g} times as long", words,
                                 part->step_factor[0], part->step_factor[1]));
  }
  if (names.empty()) return {};
  std::string out = label_line("left out", fmt::format("{}", fmt::join(names, ", ")));
  for (const std::string& line : with) out += label_line("", line);
  return out;
}

}  // namespace

std::string history_clock_text(double clock_s) {
  return fmt::format("time of the measured history = time of the run {} {:.8g} µs",
                     clock_s < 0 ? "\u2212" : "+", 1e6 * std::abs(clock_s));
}

std::string run_table(const LaneSummary& s, bool color) {
  std::string out = heading(title(s), color) + "\n";
  if (!s.outcome_where.empty()) out += label_line(s.outcome, s.outcome_where);
  out += breaks_freely(s) ? broken_beams(s) : ratios(s) + theory(s);
  return out + energy_balance(s, color) + lattice(s) + clock(s) + costs(s) + left_out(s);
}

}  // namespace rift::studio
