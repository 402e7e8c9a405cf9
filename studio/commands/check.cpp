#include "engine/base/console.hpp"
#include "engine/measurement/specimen_properties.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/session.hpp"
#include "studio/text/dry_run.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <memory>

namespace rift::studio {
namespace {

using Json = nlohmann::ordered_json;

void print_table(const Json& j, const std::string& title, bool color) {
  base::print_text(heading(title, color) + "\n");
  for (const auto& [label, text] : dry_run_rows(j)) base::print("  {:<16}{}\n", label, text);
}

/// What the specimen shows of itself, under the dry run's table.
void print_measured(const Json& j, bool color) {
  const auto number = [&](const char* name) {
    return j.at(name).is_number() ? j.at(name).get<double>() : std::numeric_limits<double>::quiet_NaN();
  };
  base::print_text("\n" + heading("Measured on this specimen", color) + "\n");
  for (const char* way : {"along", "across"})
    base::print("  {:<16}E {:.2f} GPa, ν {:.3f}\n", fmt::format("pulled {}", way),
                number(fmt::format("measured_young_modulus_{}_pa", way).c_str()) / 1e9,
                number(fmt::format("measured_poisson_ratio_{}", way).c_str()));
  for (const char* kind : {"dilatational", "shear", "rayleigh"}) {
    const double measured = number(fmt::format("measured_{}_speed_m_s", kind).c_str()),
                 nominal = number(fmt::format("nominal_{}_speed_m_s", kind).c_str());
    base::print("  {:<16}{:.0f} m/s; the material has {:.0f} m/s, ratio {:.3f}\n", kind, measured, nominal,
                measured / nominal);
  }
  base::print("  {:<16}G/G_I0 = {:.4f} over the window, for infinitely slow progressive release\n",
              "quasi-static", number("ratio_quasi_static"));
  base::print_text(
      "\n" +
      heading("Dispersion: wavelength over mean radius, wave speed over that of the longest wave", color) +
      "\n");
  for (const Json& wave : j.at("waves")) {
    const auto kind = wave.at("kind").get<std::string>();
    base::print(
        "  {:<16}{:6.1f}   {:.3f}\n", kind, wave.at("wavelength_over_radius").get<double>(),
        wave.at("speed_m_s").get<double>() / number(fmt::format("measured_{}_speed_m_s", kind).c_str()));
  }
}

struct CheckOptions : SceneOptions {
  bool measure = false;
};

ExitCode check(const CheckOptions& options) {
  const scene::Preset preset = read_scene(options);
  if (prints_config(options, preset)) return ExitCode::done;
  const std::vector<scene::Scene> lanes = scenes_of_run(preset);
  Session session("rift check", options);
  return session.until_stopped([&] {
    const auto progress = session.progress_of_stages();
    const simulation::Prepared prepared = simulation::prepare(preset, lanes, session.cache, progress);
    Json j = dry_run(prepared, options.threads);
    if (options.measure) {
      j["measured"] = measurement::json_of(
          measurement::measure_specimen(prepared, session.cache, progress, options.threads),
          prepared.lattice.mean_radius);
      j["measured"]["ratio_quasi_static"] = measurement::quasi_static_ratio(
          prepared, prepared.lane.front().window, session.progress_of("quasi-static"));
    }
    session.line.clear();
    session.print_notes();
    session.print_result(j, [&] {
      print_table(j, prepared.preset.name, session.color());
      if (options.measure) print_measured(j["measured"], session.color());
    });
    return ExitCode::done;
  });
}

}  // namespace

void add_check(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "check", "Dry run: derived quantities, time step, cost, and what the scene leaves out");
  const auto options = std::make_shared<CheckOptions>();
  add_scene_options(command, *options);
  command.add_flag("--measure", options->measure,
                   "Also measure E, ν and the wave speeds of this specimen, by static pulls and by waves, "
                   "and the release rate of an infinitely slow crack");
  command.callback([options, &exit_code] { exit_code = check(*options); });
}

}  // namespace rift::studio
