#include "engine/experiment/experiment.hpp"

#include "engine/base/console.hpp"
#include "engine/base/interrupted.hpp"
#include "engine/base/text.hpp"
#include "engine/base/world_error.hpp"
#include "engine/experiment/kept_parts.hpp"
#include "engine/scene/issue.hpp"
#include "engine/scene/parameters.hpp"
#include "engine/scene/rows_file.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/common.hpp"
#include "studio/commands/film_of_run.hpp"
#include "studio/commands/run_ending.hpp"
#include "studio/commands/scene_options.hpp"
#include "studio/commands/stop_signal.hpp"
#include "studio/reports/experiment_report.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;

struct ExperimentCommand {
  SceneOptions scene;
  experiment::ExperimentOptions wishes;
  std::string out, truth, budget;
  bool force = false, no_application = false;
  std::unique_ptr<FilmOfRun> film;
};

void check_one_history(const scene::Preset& preset) {
  if (!preset.study.empty() || !preset.lanes.empty())
    refuse(preset.name, "holds lanes or a study: 'rift experiment' is of one measured crack");
  if (preset.scene.crack.history.empty())
    refuse(preset.name,
           "has no crack.history: 'rift experiment' needs a measured one, such as "
           "--set crack.history=measured.csv");
  if (preset.scene.crack.tips != 1) refuse(preset.name, "has two tips: 'rift experiment' reads one");
}

/// The critical rate to lay over the charts, read as crack.toughness is.
fracture::CriticalRate read_truth(const std::string& file) {
  if (file.empty()) return {};
  scene::Preset preset = scene::read_preset_text("", file, {"crack.toughness=" + file});
  for (scene::Issue& issue : preset.issues)
    if (issue.file == "--set")
      issue.file = "rift experiment --against", issue.key.clear(), issue.value.clear();
  if (!preset.issues.empty()) throw scene::InputError(preset.issues);
  return preset.scene.crack.toughness;
}

std::string smoothing_text(const scene::Scene& scene, const history::SmoothedHistory& course) {
  if (scene.crack.smoothing == history::Smoothing::none) return "straight lines from row to row";
  return fmt::format("monotone penalised spline, {:.0f} degrees of freedom for {} rows",
                     course.degrees_of_freedom, scene.crack.history.size());
}

std::string command_text(const ExperimentCommand& command) {
  std::string text = "rift experiment " + command.scene.preset;
  for (const std::string& set : command.scene.overrides) text += fmt::format(" --set '{}'", set);
  if (!command.truth.empty()) text += " --against " + command.truth;
  return text +
         fmt::format(" --resamples {} --specimens {}", command.wishes.resamples, command.wishes.specimens);
}

/// Stopped before its report: what was computed stays for the next call, and where that is nothing, no folder
/// does.
ExitCode stopped(const std::string& what, const fs::path& folder, const StopSignal& stop) {
  const bool anything = experiment::holds_parts(folder);
  if (!anything) {
    experiment::forget_parts(folder);
    std::error_code ignored;
    for (const fs::path& empty : {folder / "run", folder})
      if (fs::is_empty(empty, ignored)) fs::remove(empty, ignored);
  }
  base::message(
      "rift experiment: {}; {}\n", what,
      anything ? fmt::format("what was computed is kept in {}: the same command goes on", folder.string())
               : "nothing was kept: the same command starts anew");
  return stopped_by(stop);
}

ExitCode finish(const ExperimentCommand& command, const ExperimentReport& report, const fs::path& folder,
                ProgressLine& line) {
  ExitCode code =
      report.experiment.outcome == simulation::Outcome::diverged ? ExitCode::diverged : ExitCode::done;
  try {
    line.tell("report", 0.0);
    write_experiment_report(report, folder);
    experiment::forget_parts(folder);
  } catch (const base::WorldError& error) {
    base::message("rift experiment: {}\n", error.what());
    code = ExitCode::world_failed;
  }
  line.clear();
  if (command.scene.json) {
    base::print_text(base::json_text(experiment_json(report), 2) + "\n");
  } else {
    base::print_text(experiment_text(report, wants_color(command.scene.color, stdout)));
    base::print("{}/  report.html, table.csv, toughness_*.csv, charts, run/\n", folder.string());
  }
  return code;
}

ExitCode experiment(ExperimentCommand& command) {
  const std::optional<double> budget = read_budget("rift experiment", command.budget);
  const scene::Preset preset = read_scene(command.scene);
  check_one_history(preset);
  const fracture::CriticalRate truth = read_truth(command.truth);
  if (command.scene.print_config) {
    base::print_text(scene::preset_text(preset));
    return ExitCode::done;
  }
  const fs::path folder = command.out.empty()
                              ? fs::path(fs::path(command.scene.preset).stem().string() + "_experiment")
                              : fs::path(command.out);
  const bool going_on =
      experiment::is_under_way(folder, experiment::experiment_identity(preset, command.wishes, build_info()));
  if (const std::string trouble = command.film->trouble_with(preset, true); !trouble.empty())
    refuse("rift experiment", trouble);
  ReportFolder owned(folder, command.force || going_on, {.own = "toughness_velocity.csv", .has_run = true});
  const auto start = Clock::now();
  const StopSignal stop(budget);
  ProgressLine line(progress_style(command.scene.quiet, command.scene.json));
  base::Cache cache = cache_for(command.scene);
  command.wishes.threads = command.scene.threads;
  command.wishes.application = !command.no_application;
  ExperimentReport report{.preset = preset.name,
                          .command = command_text(command),
                          .build = build_info(),
                          .experiment = {},
                          .rows = preset.scene.crack.history,
                          .smoothing = {},
                          .truth = truth,
                          .truth_name = "laid over",
                          .wall_s = 0};
  command.film->begin(folder / "run", false);
  try {
    report.experiment = experiment::run_experiment(preset, command.wishes, folder, cache, report.build,
                                                   [&](std::string_view stage, double done) {
                                                     line.tell(stage, done);
                                                     return stop.received() == 0;
                                                   });
  } catch (const base::Interrupted& interrupted) {
    (void)command.film->finish(line, [] { return false; });
    line.clear();
    return stopped(interrupted.what(), folder, stop);
  }
  const FilmOfRun::Result film = command.film->finish(line, [&] { return stop.received() == 0; });
  line.clear();
  print_notes(cache);
  report.smoothing = smoothing_text(preset.scene, report.experiment.course);
  report.wall_s = std::chrono::duration<double>(Clock::now() - start).count();
  const ExitCode code = finish(command, report, owned.keep(), line);
  if (!film.trouble.empty()) base::message("rift experiment: no film: {}\n", film.trouble);
  return code == ExitCode::done && !film.trouble.empty() ? ExitCode::world_failed : code;
}

}  // namespace

void add_experiment(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "experiment", "From a measured crack history to the critical release rate that the material showed");
  const auto options = std::make_shared<ExperimentCommand>();
  add_scene_options(command, options->scene);
  options->film = std::make_unique<FilmOfRun>(command);
  command.add_option("--out", options->out, "Folder of the results (default: NAME_experiment)");
  command.add_flag("--force", options->force, "Replace the results that are in the folder");
  command
      .add_option("--resamples", options->wishes.resamples,
                  "Histories drawn anew from their noise, for the band")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  command.add_option("--specimens", options->wishes.specimens, "Packings, for the band")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  command.add_option("--against", options->truth,
                     "A critical release rate to compare with: a CSV file as crack.toughness takes it");
  command.add_option("--budget", options->budget,
                     "Stop after this time (\"2 h\") with exit code 4; the same command goes on");
  command.add_flag("--no-application", options->no_application,
                   "Leave out the crack that runs by itself with what was found");
  command.callback([options, &exit_code] { exit_code = experiment(*options); });
}

}  // namespace rift::studio
