#include "studio/text/run_table.hpp"

#include "studio/text/progress.hpp"
#include "studio/text/table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rift::studio {
namespace {

using Json = nlohmann::ordered_json;

/// A number with a format, or a dash where it is undefined.
std::string shown(const Json& j, const char* key, const char* format = "{:.3f}") {
  return j.at(key).is_number() ? number_cell(j.at(key).get<double>(), format) : "-";
}

double value(const Json& j, const char* key) { return j.at(key).get<double>(); }

std::string text(const Json& j, const char* key) { return j.at(key).get<std::string>(); }

std::string by_itself(const Json& s) {
  return s.at("arrest_m").is_number()
             ? fmt::format("by itself, arrested at {:.4g} mm", 1e3 * value(s, "arrest_m"))
             : "by itself";
}

std::string title(const Json& s) {
  const bool progressive = text(s, "technique") == "progressive";
  const std::string how = progressive ? fmt::format("progressive release, {}, r_l = {:g}",
                                                    text(s, "relaxation_name"), value(s, "damage_zone_ratio"))
                                      : "simple release";
  const std::string damping =
      text(s, "damping_region") == "none"
          ? ""
          : fmt::format(", damping {:g} ({})", value(s, "damping_alpha"), text(s, "damping_region"));
  const std::string faces =
      s.contains("friction") ? fmt::format(", friction {:g}", value(s, "friction")) : "";
  const std::string speed = s.at("crack_velocity_over_cr").is_number()
                                ? fmt::format("{:g} c_r", value(s, "crack_velocity_over_cr"))
                            : text(s, "crack_course") == "measured"  ? "measured history"
                            : text(s, "crack_course") == "by itself" ? by_itself(s)
                                                                     : "piecewise velocity";
  const char* tips = value(s, "tips") == 2 ? ", two tips" : "";
  return fmt::format("{}{}, {}{}{}, {} stiffness", speed, tips, how, damping, faces, text(s, "stiffness"));
}

std::string ratios(const Json& s) {
  const auto& window = s.at("window_over_length");
  const char* position = value(s, "tips") == 2 ? "half length" : "tip at";
  std::string out =
      label_line("G_ID / G_I0", fmt::format("{} ± {}   {} {:.4g} to {:.4g} of the length",
                                            shown(s, "ratio_with_damping"), shown(s, "ratio_scatter"),
                                            position, window[0].get<double>(), window[1].get<double>()));
  if (text(s, "damping_region") != "none") out += label_line("  without damping", shown(s, "ratio"));
  out += label_line("  released by beams", shown(s, "ratio_release"));
  out += label_line("  no rotation in K", shown(s, "ratio_translation_only"));
  out += label_line("theory",
                    fmt::format("Broberg {}   Freund {}   strip {}   first echo back at {} of the length",
                                shown(s, "broberg"), shown(s, "freund"), shown(s, "strip", "{:g}"),
                                shown(s, "echo_free_over_length")));
  const char* reference = text(s, "g_i0_reference") == "griffith" ? " (griffith, mean)" : "";
  out += label_line("G_I0", fmt::format("{:.5g} kJ/m²{}   G_ID {} J/m²", 1e-3 * value(s, "g_i0_j_m2"),
                                        reference, shown(s, "g_id_j_m2", "{:.5g}")));
  return out;
}

std::string books(const Json& s, bool color) {
  const bool closes = s.at("ledger_closes").get<bool>();
  const char *red = color && !closes ? "\x1b[31m" : "", *plain = color && !closes ? "\x1b[0m" : "";
  std::string out = label_line(
      "energy [J]",
      fmt::format("{:.2f} stored, now {:.2f} elastic + {:.2f} kinetic; {:.2f} fracture, {:.2f} damping",
                  value(s, "energy_initial_j"), value(s, "energy_elastic_j"),
                  value(s, "energy_kinetic_translation_j") + value(s, "energy_kinetic_rotation_j"),
                  value(s, "energy_fracture_j"),
                  value(s, "energy_damping_j") + value(s, "energy_numerical_damping_j")) +
          (s.contains("friction") ? fmt::format(", {:.2f} between the faces", value(s, "energy_contact_j"))
                                  : ""));
  out += label_line(
      "books", fmt::format("{}{} to {} of the energy{}", red,
                           closes ? "close" : "DO NOT CLOSE:", shown(s, "ledger_residual", "{:.1e}"), plain));
  if (text(s, "prestress_method") == "ramp")
    out += label_line("ramp", fmt::format("stored energy {:.4f} of static, kinetic {:.1e} of it",
                                          value(s, "prestress_energy_over_static"),
                                          value(s, "prestress_kinetic_fraction")));
  return out;
}

std::string lattice(const Json& s) {
  std::string out =
      label_line("lattice", fmt::format("{} elements, {} beams ({} crossed), {} rattlers, coordination {}",
                                        s.at("elements").get<int>(), s.at("beams").get<long>(),
                                        s.at("beams_crossed").get<long>(), s.at("rattlers").get<int>(),
                                        shown(s, "coordination")));
  out +=
      label_line("", fmt::format("mean radius {:.4f} mm, micro modulus {:.1f} GPa, {} kg/m³",
                                 1e3 * value(s, "mean_radius_m"), 1e-9 * value(s, "micro_young_modulus_pa"),
                                 shown(s, "density_kg_m3", "{:.1f}")));
  out += label_line("step",
                    fmt::format("{:.3e} s, {:.3g} of critical; {} steps{}", value(s, "dt_s"),
                                value(s, "dt_fraction"), s.at("steps").get<long>(),
                                s.at("steps_per_beam").is_number()
                                    ? fmt::format(", {:.1f} for a beam to soften", value(s, "steps_per_beam"))
                                    : std::string()));
  return out;
}

std::string costs(const Json& s) {
  const auto cached = [&](const char* key) { return s.at(key).get<bool>() ? " (cached)" : ""; };
  return label_line(
             "time",
             fmt::format("packing {}{}, pre-stress {}{}, crack {}; {} in all, {:.0f} MB",  //
                         duration_text(value(s, "wall_packing_s")), cached("packing_from_cache"),
                         duration_text(value(s, "wall_prestress_s")), cached("prestress_from_cache"),
                         duration_text(value(s, "wall_fracture_s")), duration_text(value(s, "wall_total_s")),
                         1e-6 * value(s, "memory_peak_bytes"))) +
         label_line("", fmt::format("{} element-steps/s, {} beam-steps/s",
                                    magnitude_text(value(s, "element_steps_per_s")),
                                    magnitude_text(value(s, "beam_steps_per_s"))));
}

}  // namespace

std::string run_table(const Json& scenario, bool color) {
  std::string out = heading(title(scenario), color) + "\n";
  if (const auto& where = scenario.at("outcome_where"); where.is_string())
    out += label_line(text(scenario, "outcome"), where.get<std::string>());
  return out + ratios(scenario) + books(scenario, color) + lattice(scenario) + costs(scenario);
}

}  // namespace rift::studio
