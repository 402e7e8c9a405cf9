#include "engine/base/console.hpp"
#include "engine/experiment/plan.hpp"
#include "engine/measurement/specimen_properties.hpp"
#include "engine/theory/wave_speeds.hpp"
#include "studio/commands/chosen_claims.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/planned.hpp"
#include "studio/commands/session.hpp"
#include "studio/commands/step_error.hpp"
#include "studio/text/catalogue.hpp"
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
    const double own = number(fmt::format("own_{}_speed_m_s", kind).c_str()),
                 measured = number(fmt::format("measured_{}_speed_m_s", kind).c_str()),
                 nominal = number(fmt::format("nominal_{}_speed_m_s", kind).c_str());
    base::print(
        "  {:<16}{:.0f} m/s by its E and ν, {:.0f} by its longest wave; the material has {:.0f}, ratio "
        "{:.3f}\n",
        kind, own, measured, nominal, own / nominal);
  }
  base::print("  {:<16}{:.3f} mm between the grips' elements: what of the height is strained\n", "height",
              1e3 * number("between_grips_m"));
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

/// What the specimen shows of itself where it has been pulled before: check itself stays fast.
Json known_constants_of(const simulation::Prepared& p, base::Cache& cache) {
  const auto own = measurement::known_constants(p, p.lane.front(), cache);
  if (!own) return nullptr;
  const theory::WaveSpeeds speeds =
      theory::wave_speeds(own->young_modulus(), own->poisson_ratio(), p.density, theory::Plane::stress);
  return {{"young_modulus_pa", own->young_modulus()},
          {"poisson_ratio", own->poisson_ratio()},
          {"between_grips_m", own->between_grips},
          {"rayleigh_speed_m_s", speeds.rayleigh}};
}

struct CheckOptions : SceneOptions {
  bool measure = false, reproduce = false, quick = false;
  experiment::ExperimentOptions parts;
};

void print_plan(const Json& plan, bool color) {
  base::print_text(heading(plan.at("command").get<std::string>(), color) + "\n");
  for (const auto& [label, text] : planned_rows(plan))
    if (label != "command") base::print("  {:<16}{}\n", label, text);
}

/// Of the experiment under the dry run of its measured crack, which says what both leave out.
void print_experiment(Json plan, bool color) {
  plan.erase("left_out");
  print_plan(plan, color);
}

/// A study, a calibration or a reproduction: what is known of it without a lattice.
ExitCode say_plan(const CheckOptions& options, const PlannedWork& work, const scene::Preset& preset) {
  const Session session("rift check", options);
  const Json plan = planned_json(work, preset);
  session.print_result(plan, [&] { print_plan(plan, session.color()); });
  return ExitCode::done;
}

/// One scene or its lanes, prepared and marched for a moment; of a measured crack the experiment too.
ExitCode check_run(const CheckOptions& options, const scene::Preset& preset, bool is_experiment) {
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
    j["own"] = known_constants_of(prepared, session.cache);
    if (const std::string error = step_error_text(options, preset); !error.empty()) j["step_error"] = error;
    if (is_experiment && experiment::planned_points(preset.scene).empty())
      base::message(
          "note: the history is shorter than crack.toughness_window, over which the release rate is "
          "averaged: 'rift experiment' needs a shorter window, or smaller elements\n");
    if (is_experiment)
      j["experiment"] = planned_json(
          planned_experiment(
              preset, command_with_preset("rift experiment", options), options.parts,
              {.steps = j.at("steps").get<double>(), .seconds = j.at("wall_estimate_s").get<double>()}),
          preset);
    session.line.clear();
    session.print_notes();
    session.print_result(j, [&] {
      print_table(j, prepared.preset.name, session.color());
      if (options.measure) print_measured(j["measured"], session.color());
      if (is_experiment) base::print("\n"), print_experiment(j["experiment"], session.color());
    });
    return ExitCode::done;
  });
}

/// Of a claim's name that is no preset's too.
bool is_reproduction(const CheckOptions& options) {
  return options.reproduce || (!find_preset(options.preset) && is_claim_name(options.preset));
}

ExitCode check(const CheckOptions& options) {
  if (is_reproduction(options)) {
    const claims::Effort effort = options.quick ? claims::Effort::quick : claims::Effort::full;
    return say_plan(options, planned_reproduction({options.preset}, effort, options.threads), {});
  }
  const scene::Preset preset = read_scene(options);
  if (prints_config(options, preset)) return ExitCode::done;
  const std::string taker = command_for(preset);
  if (taker == "study")
    return say_plan(
        options,
        planned_study(preset, command_with_preset("rift study", options), study_folder(options.preset)),
        preset);
  if (taker == "calibrate")
    return say_plan(
        options,
        planned_calibration(preset.scene, command_with_preset("rift calibrate", options), options.threads),
        preset);
  return check_run(options, preset, taker == "experiment");
}

}  // namespace

void add_check(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "check",
      "Dry run of a preset of any command, or of a claim: derived quantities, time step, cost, memory, disk, "
      "and what is left out");
  const auto options = std::make_shared<CheckOptions>();
  add_scene_options(command, *options);
  command.add_flag("--measure", options->measure,
                   "Also measure E, ν and the wave speeds of this specimen, by static pulls and by waves, "
                   "and the release rate of an infinitely slow crack");
  add_experiment_parts(command, options->parts);
  command.add_flag("--reproduce", options->reproduce,
                   "The name is that of a claim, as 'rift reproduce' takes it, where a preset has it too");
  command.add_flag("--quick", options->quick, "Of a claim: the quick reproduction");
  command.callback([options, &exit_code] { exit_code = check(*options); });
}

}  // namespace rift::studio
