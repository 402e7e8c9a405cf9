#include "engine/experiment/experiment.hpp"

#include "engine/base/interrupted.hpp"
#include "engine/experiment/kept_parts.hpp"
#include "engine/scene/issue.hpp"
#include "engine/scene/rows_file.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/film_of_run.hpp"
#include "studio/commands/planned.hpp"
#include "studio/commands/session.hpp"
#include "studio/reports/experiment_report.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

struct ExperimentOptions : SceneOptions {
  experiment::ExperimentOptions parts;
  std::string out, truth, budget;
  bool force = false, no_application = false;
  std::unique_ptr<FilmOfRun> film;
};

/// The critical rate to lay over the charts, read as crack.toughness is.
fracture::CriticalRate read_truth(const std::string& file) {
  if (file.empty()) return {};
  scene::Preset preset = scene::read_preset_text("", file, {"crack.toughness=" + file});
  for (scene::Issue& issue : preset.issues)
    if (issue.file == "--set")
      issue.file = "rift experiment --against", issue.key.clear(), issue.value.clear();
  return without_mistakes(std::move(preset)).scene.crack.toughness;
}

std::string smoothing_text(const scene::Scene& scene, const history::SmoothedHistory& course) {
  if (scene.crack.smoothing == history::Smoothing::none) return "straight lines between the rows";
  return fmt::format("monotone penalised spline, {:.0f} degrees of freedom for {} rows",
                     course.degrees_of_freedom, scene.crack.history.size());
}

std::string command_text(const ExperimentOptions& options) {
  return command_with_preset("rift experiment", options) +
         (options.truth.empty() ? "" : " --against " + options.truth) +
         fmt::format(" --resamples {} --specimens {}", options.parts.resamples, options.parts.specimens);
}

/// Stopped before its report: what was computed stays for the next call, and where that is nothing, no folder
/// does. @return what is left
std::string keep_parts(const fs::path& folder) {
  if (experiment::holds_parts(folder))
    return fmt::format("; the finished parts are stored in {}: the same command continues from there",
                       folder.string());
  experiment::forget_parts(folder);
  std::error_code ignored;
  for (const fs::path& empty : {folder / "run", folder})
    if (fs::is_empty(empty, ignored)) fs::remove(empty, ignored);
  return "; nothing was stored: the same command starts from the beginning";
}

/// Of an interrupted experiment that this command cannot continue it says why.
void refuse_other_options(const fs::path& folder, const std::string& identity) {
  const std::vector<std::string> differences = experiment::differences_from(folder, identity);
  if (differences.empty()) return;
  refuse(folder.string(),
         fmt::format("holds an interrupted experiment with other options: {}; with the options it had it is "
                     "continued, --force starts it again with these",
                     fmt::join(differences, "; ")));
}

ExitCode experiment(ExperimentOptions& options) {
  const std::optional<double> budget = read_budget("rift experiment", options.budget);
  const scene::Preset preset = read_scene(options);
  check_one_history(preset);
  const fracture::CriticalRate truth = read_truth(options.truth);
  if (prints_config(options, preset)) return ExitCode::done;
  const fs::path folder = options.out.empty()
                              ? fs::path(fs::path(options.preset).stem().string() + "_experiment")
                              : fs::path(options.out);
  const std::string identity = experiment::experiment_identity(preset, options.parts, build_info());
  const bool going_on = experiment::is_under_way(folder, identity);
  if (!options.force && !going_on) refuse_other_options(folder, identity);
  if (const std::string trouble = options.film->trouble_with(preset, true); !trouble.empty())
    refuse("rift experiment", trouble);
  ReportFolder owned(folder, options.force || going_on, {.own = "toughness_velocity.csv", .has_run = true});
  Session session("rift experiment", options, budget);
  options.parts.threads = options.threads;
  options.parts.application = !options.no_application;
  ExperimentReport report{.preset = preset.name,
                          .command = command_text(options),
                          .scene = preset.scene,
                          .build = build_info(),
                          .experiment = {},
                          .rows = preset.scene.crack.history,
                          .smoothing = {},
                          .truth = truth,
                          .truth_name = "reference",
                          .wall_s = 0};
  options.film->begin(folder / "run", false);
  try {
    report.experiment = experiment::run_experiment(preset, options.parts, folder, session.cache, report.build,
                                                   session.progress_of_stages());
  } catch (const base::Interrupted& interrupted) {
    (void)options.film->finish(session);
    session.message(interrupted.what() + keep_parts(folder));
    return session.stopped();
  }
  const FilmOfRun::Result film = options.film->finish(session);
  session.line.clear();
  session.print_notes();
  report.smoothing = smoothing_text(preset.scene, report.experiment.course);
  report.wall_s = session.seconds();
  const fs::path& kept = owned.keep();
  ExitCode code = session.write_or_say([&] {
    write_experiment_report(report, kept);
    experiment::forget_parts(kept);
  });
  session.print_result(experiment_json(report), [&] {
    base::print_text(experiment_text(report, session.color()));
    base::print("{}/  report.html, table.csv, toughness_*.csv, charts, run/\n{}\n", folder.string(),
                publish_text(report));
  });
  if (!film.trouble.empty()) session.message("no film: " + film.trouble);
  if (code == ExitCode::done && report.experiment.outcome == simulation::Outcome::diverged)
    code = ExitCode::diverged;
  return code == ExitCode::done && !film.trouble.empty() ? ExitCode::world_failed : code;
}

}  // namespace

void add_experiment(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "experiment", "Critical dynamic energy release rate G_IDc along a measured crack history");
  const auto options = std::make_shared<ExperimentOptions>();
  add_scene_options(command, *options);
  options->film = std::make_unique<FilmOfRun>(command);
  command.add_option("-o,--out", options->out, "Folder of the results (default: NAME_experiment)")
      ->type_name("FOLDER");
  command.add_flag("-f,--force", options->force, "Replace the results that are in the folder");
  add_experiment_parts(command, options->parts);
  command
      .add_option("--against", options->truth,
                  "Reference curve of the critical release rate, a CSV file in the form of crack.toughness")
      ->type_name("FILE");
  command
      .add_option("--budget", options->budget,
                  "Stop after this time (\"2 h\") with exit code 4; the same command continues")
      ->type_name("TIME");
  command.add_flag("--no-application", options->no_application,
                   "Skip the forward check, a predicted crack driven by the identified G_IDc");
  command.callback([options, &exit_code] { exit_code = experiment(*options); });
}

}  // namespace rift::studio
