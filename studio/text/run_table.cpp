#include "studio/text/run_table.hpp"

#include "engine/scene/issue.hpp"
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

std::string by_itself(const LaneSummary& s) {
  return !std::isnan(s.arrest_m) ? fmt::format("by itself, arrested at {:.4g} mm", 1e3 * s.arrest_m)
                                 : "by itself";
}

std::string title(const LaneSummary& s) {
  const bool progressive = s.technique == "progressive";
  const std::string how =
      progressive ? fmt::format("progressive release, {}, r_l = {:g}", s.relaxation_name, s.damage_zone_ratio)
                  : "simple release";
  const std::string damping =
      s.damping_region == "none" ? "" : fmt::format(", damping {:g} ({})", s.damping_alpha, s.damping_region);
  const std::string faces = !std::isnan(s.friction) ? fmt::format(", friction {:g}", s.friction) : "";
  const std::string speed = !std::isnan(s.crack_velocity_over_cr)
                                ? fmt::format("{:g} c_r", s.crack_velocity_over_cr)
                            : s.crack_course == "measured"  ? "measured history"
                            : s.crack_course == "by itself" ? by_itself(s)
                                                            : "piecewise velocity";
  const char* tips = s.tips == 2 ? ", two tips" : "";
  return fmt::format("{}{}, {}{}{}, {} stiffness", speed, tips, how, damping, faces, s.stiffness);
}

std::string ratios(const LaneSummary& s) {
  const char* position = s.tips == 2 ? "half length" : "tip at";
  std::string out = label_line("G_ID / G_I0", fmt::format("{} ± {}   {} {:.4g} to {:.4g} of the length",
                                                          number_cell(s.ratio_with_damping, "{:.3f}"),
                                                          number_cell(s.ratio_scatter, "{:.3f}"), position,
                                                          s.window_over_length[0], s.window_over_length[1]));
  if (s.damping_region != "none") out += label_line("  without damping", number_cell(s.ratio, "{:.3f}"));
  out += label_line("  released by beams", number_cell(s.ratio_release, "{:.3f}"));
  out += label_line("  no rotation in K", number_cell(s.ratio_translation_only, "{:.3f}"));
  out += label_line(
      "theory", fmt::format("Broberg {}   Freund {}   strip {}   first echo back at {} of the length",
                            number_cell(s.broberg, "{:.3f}"), number_cell(s.freund, "{:.3f}"),
                            number_cell(s.strip, "{:g}"), number_cell(s.echo_free_over_length, "{:.3f}")));
  const char* reference = s.g_i0_reference == "griffith" ? " (griffith, mean)" : "";
  out += label_line("G_I0", fmt::format("{:.5g} kJ/m²{}   G_ID {} J/m²", 1e-3 * s.g_i0_j_m2, reference,
                                        number_cell(s.g_id_j_m2, "{:.5g}")));
  return out;
}

std::string energy_balance(const LaneSummary& s, bool color) {
  const bool closes = s.ledger_closes;
  const char *red = color && !closes ? "\x1b[31m" : "", *plain = color && !closes ? "\x1b[0m" : "";
  std::string out = label_line(
      "energy [J]",
      fmt::format("{:.2f} stored, now {:.2f} elastic + {:.2f} kinetic; {:.2f} fracture, {:.2f} damping",
                  s.energy_initial_j, s.energy_elastic_j,
                  s.energy_kinetic_translation_j + s.energy_kinetic_rotation_j, s.energy_fracture_j,
                  s.energy_damping_j + s.energy_numerical_damping_j) +
          (!std::isnan(s.friction) ? fmt::format(", {:.2f} between the faces", s.energy_contact_j) : ""));
  out +=
      label_line("books", fmt::format("{}{} to {} of the energy{}", red, closes ? "close" : "DO NOT CLOSE:",
                                      number_cell(s.ledger_residual, "{:.1e}"), plain));
  if (s.prestress_method == "ramp")
    out += label_line("ramp", fmt::format("stored energy {:.4f} of static, kinetic {:.1e} of it",
                                          s.prestress_energy_over_static, s.prestress_kinetic_fraction));
  return out;
}

std::string lattice(const LaneSummary& s) {
  std::string out = label_line(
      "lattice",
      fmt::format("{:.0f} elements, {:.0f} beams ({:.0f} crossed), {:.0f} rattlers, coordination {}",
                  s.elements, s.beams, s.beams_crossed, s.rattlers, number_cell(s.coordination, "{:.3f}")));
  out += label_line(
      "", fmt::format("mean radius {:.4f} mm, micro modulus {:.1f} GPa, {} kg/m³", 1e3 * s.mean_radius_m,
                      1e-9 * s.micro_young_modulus_pa, number_cell(s.density_kg_m3, "{:.1f}")));
  out += label_line(
      "step", fmt::format("{:.3e} s, {:.3g} of critical; {:.0f} steps{}", s.dt_s, s.dt_fraction, s.steps,
                          !std::isnan(s.steps_per_beam)
                              ? fmt::format(", {:.1f} for a beam to soften", s.steps_per_beam)
                              : std::string()));
  return out;
}

std::string costs(const LaneSummary& s) {
  const auto cached = [](bool from_cache) { return from_cache ? " (cached)" : ""; };
  return label_line("time",
                    fmt::format("packing {}{}, pre-stress {}{}, crack {}; {} in all, {:.0f} MB",  //
                                duration_text(s.wall_packing_s), cached(s.packing_from_cache),
                                duration_text(s.wall_prestress_s), cached(s.prestress_from_cache),
                                duration_text(s.wall_fracture_s), duration_text(s.wall_total_s),
                                1e-6 * s.memory_peak_bytes)) +
         label_line("",
                    fmt::format("{} element-steps/s, {} beam-steps/s", magnitude_text(s.element_steps_per_s),
                                magnitude_text(s.beam_steps_per_s)));
}

/// What the scenario leaves out; and how many times as long a step would take with it where that is measured,
/// with one scenario in double to eight in single precision.
std::string left_out(const LaneSummary& s) {
  std::vector<std::string> names, factors;
  for (const std::string& name : s.left_out) {
    std::string& words = names.emplace_back(name);
    std::replace(words.begin(), words.end(), '_', ' ');
    const scene::OptionalPart* part = scene::find_optional_part(name);
    if (part != nullptr && std::isfinite(part->step_factor[1]))
      factors.push_back(fmt::format("{:g} to {:g} ({})", part->step_factor[0], part->step_factor[1], words));
  }
  if (names.empty()) return {};
  std::string out = label_line("left out", fmt::format("{}", fmt::join(names, ", ")));
  if (!factors.empty())
    out += label_line(
        "", fmt::format("a step would take {} times as long with it", scene::listed(factors, "or")));
  return out;
}

}  // namespace

std::string run_table(const LaneSummary& s, bool color) {
  std::string out = heading(title(s), color) + "\n";
  if (!s.outcome_where.empty()) out += label_line(s.outcome, s.outcome_where);
  return out + ratios(s) + energy_balance(s, color) + lattice(s) + costs(s) + left_out(s);
}

}  // namespace rift::studio
