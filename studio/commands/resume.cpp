#include "studio/commands/resume.hpp"

#include "engine/base/console.hpp"
#include "engine/base/interrupted.hpp"
#include "engine/base/ownership.hpp"
#include "engine/base/world_error.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/simulation/record.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/run_ending.hpp"
#include "studio/commands/run_panel.hpp"
#include "studio/commands/stop_signal.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

namespace rift::studio {
namespace {

std::optional<simulation::Recorded> go_on_plainly(const ResumeOptions& options, const scene::Preset& preset,
                                                  base::Cache& cache, const StopSignal& stop,
                                                  ProgressLine& line) try {
  const auto start = std::chrono::steady_clock::now();
  const simulation::Prepared prepared =
      simulation::prepare(preset, scenes_of_run(preset), cache, [&](std::string_view stage, double done) {
        line.tell(stage, done);
        return stop.received() == 0;
      });
  const double preparation = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::string note;
  auto ran = simulation::resume_run(prepared, options.run, build_info(),
                                    {.go_on = telling(line, stop, prepared.lattice.centre.size()),
                                     .stage = [&](const char* stage) { line.tell(stage, 0.0); }},
                                    note, {.threads = options.threads}, preparation);
  line.clear();
  if (!note.empty()) base::message("rift resume: {}\n", note);
  return ran;
} catch (const base::Interrupted& interrupted) {
  line.clear();
  base::message("rift resume: {}\n", nothing_kept_text(interrupted.what(), stop,
                                                       "the run is as it was, and the same command goes on"));
  return std::nullopt;
}

std::optional<simulation::Recorded> go_on_live(const ResumeOptions& options, const scene::Preset& preset,
                                               const base::Cache& cache, const StopSignal& stop) {
  RunRequest wish{.preset = preset, .folder = options.run};
  wish.resume = true;
  wish.threads = options.threads;
  wish.cache = cache;
  wish.build = build_info();
  return run_in_panel(std::move(wish), wants_color(options.color, stdout), stop);
}

}  // namespace

ExitCode resume(const ResumeOptions& options) {
  const std::optional<double> budget = read_budget("rift resume", options.budget);
  if (results::is_folder_being_written(options.run))
    throw base::WorldError("resume", options.run, "another process is writing it");
  if (simulation::complete_end(options.run)) {
    base::message("rift resume: {} had come to its end; the files of its end are made from its journal\n",
                  options.run);
    return ExitCode::done;
  }
  if (simulation::has_ended(options.run)) {
    base::message("rift resume: {} has come to its end: nothing is left of it\n", options.run);
    return ExitCode::done;
  }
  const scene::Preset preset = simulation::preset_of_run(options.run);
  const StopSignal stop(budget);
  ProgressLine line(progress_style(options.quiet, options.json));
  base::Cache cache = options.no_cache ? base::Cache{} : base::user_cache();
  const bool panel = !options.plain && !options.quiet && !options.json && panel_there();
  std::optional<simulation::Recorded> ran;
  try {
    ran =
        panel ? go_on_live(options, preset, cache, stop) : go_on_plainly(options, preset, cache, stop, line);
  } catch (const std::invalid_argument& error) {
    throw base::WorldError("resume", options.run, error.what());
  }
  if (!ran) return stopped_by(stop);
  print_notes(cache);
  print_run(ran->summary, options.run, options.json, wants_color(options.color, stdout));
  return exit_code_of(ran->result.outcome, stop);
}

void add_resume(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command =
      *app.add_subcommand("resume", "Go on with a run that was stopped or killed, to the same bits");
  const auto options = std::make_shared<ResumeOptions>();
  command.add_option("run", options->run, "Folder of the run")->required();
  command
      .add_option("--threads", options->threads,
                  "Threads (default: one per CPU that this process may use); the results do not depend on it")
      ->check(CLI::Range(1, 1024));
  command.add_option(
      "--budget", options->budget,
      "Stop after this time (\"2 h\") with a checkpoint and exit code 4; the same command goes on");
  command.add_flag("--plain", options->plain, "Lines of progress in place of the live panel");
  command.add_flag("--quiet", options->quiet, "No progress on stderr");
  command.add_flag("--json", options->json, "Progress as JSON lines on stderr, the result as JSON on stdout");
  command.add_flag("--no-cache", options->no_cache,
                   "Neither read nor write the cache of packings and pre-stresses");
  add_color_option(command, options->color);
  command.callback([options, &exit_code] { exit_code = resume(*options); });
}

}  // namespace rift::studio
