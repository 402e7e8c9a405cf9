#include "engine/base/console.hpp"
#include "engine/base/interrupted.hpp"
#include "engine/base/process_limits.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/scene/issue.hpp"
#include "engine/scene/units.hpp"
#include "engine/simulation/record.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/film_of_run.hpp"
#include "studio/commands/resume.hpp"
#include "studio/commands/run_ending.hpp"
#include "studio/commands/run_panel.hpp"
#include "studio/commands/scene_options.hpp"
#include "studio/commands/stop_signal.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* nothing_written = "nothing was written, and the same command starts anew";

struct RunOptions {
  SceneOptions scene;
  std::string out, replay, budget, checkpoint = "30 s";
  bool force = false, plain = false;
  std::unique_ptr<FilmOfRun> film;
};

/// Whether the folder holds a run that the same command has begun under a budget: a command with one goes on
/// with it.
bool goes_on(const RunOptions& options, const scene::Preset& preset, const fs::path& folder) {
  return !options.budget.empty() && !options.film->wanted() &&
         simulation::is_unfinished_run_of(folder, preset, build_info());
}

/// Where the user said, else the first of runs/NAME, runs/NAME-2, ... that does not exist yet, or that this
/// command goes on with.
fs::path folder_for(const RunOptions& options, const scene::Preset& preset) {
  if (!options.out.empty()) return options.out;
  const std::string name = options.replay.empty() ? fs::path(options.scene.preset).stem().string() : "replay";
  fs::path folder = fs::path("runs") / name;
  for (int k = 2; fs::exists(folder) && !goes_on(options, preset, folder); ++k)
    folder = fs::path("runs") / fmt::format("{}-{}", name, k);
  return folder;
}

/// What both ways to run have in common.
struct Way {
  const RunOptions& options;
  const scene::Preset& preset;
  const StopSignal& stop;
  ProgressLine& line;
  double checkpoint_s;
  Clock::time_point start = Clock::now();

  void begin_film(const fs::path& folder) const {
    options.film->begin(folder, options.scene.threads > 0 && options.scene.threads < base::available_cpus());
  }
};

/// With lines of progress. Nothing where the user stopped it before its first step.
std::optional<simulation::Recorded> run_plainly(const Way& way, const fs::path& path,
                                                base::Cache& cache) try {
  results::ClaimedFolder folder(path, way.options.force);
  if (!folder.has_locks()) base::message("rift run: {}\n", simulation::no_locks_note(path));
  const simulation::Prepared prepared = simulation::prepare(way.preset, scenes_of_run(way.preset), cache,
                                                            [&](std::string_view stage, double done) {
                                                              way.line.tell(stage, done);
                                                              return way.stop.received() == 0;
                                                            });
  simulation::check_grip(prepared);
  way.begin_film(folder.keep());
  const double preparation = std::chrono::duration<double>(Clock::now() - way.start).count();
  return simulation::record_run(prepared, path, build_info(),
                                {.go_on = telling(way.line, way.stop, prepared.lattice.centre.size()),
                                 .stage = [&](const char* stage) { way.line.tell(stage, 0.0); }},
                                {.threads = way.options.scene.threads, .checkpoint_s = way.checkpoint_s},
                                preparation);
} catch (const base::Interrupted& interrupted) {
  way.line.clear();
  base::message("rift run: {}\n", nothing_kept_text(interrupted.what(), way.stop, nothing_written));
  return std::nullopt;
}

/// In the live panel.
std::optional<simulation::Recorded> run_live(const Way& way, const fs::path& path, const base::Cache& cache) {
  RunRequest wish{.preset = way.preset, .folder = path, .force = way.options.force};
  wish.threads = way.options.scene.threads;
  wish.checkpoint_s = way.checkpoint_s;
  wish.cache = cache;
  wish.build = build_info();
  wish.began = [&](const fs::path& folder) { way.begin_film(folder); };
  auto ran = run_in_panel(std::move(wish), wants_color(way.options.scene.color, stdout), way.stop);
  if (!ran)
    base::message("rift run: {}\n",
                  nothing_kept_text("stopped before the first step", way.stop, nothing_written));
  return ran;
}

bool wants_panel(const RunOptions& options) {
  return !options.plain && !options.scene.quiet && !options.scene.json && panel_there();
}

/// A preset, or with --replay the one that a steered run has left.
scene::Preset read_wish(const RunOptions& options) {
  const scene::Preset preset = read_scene(options.scene);
  if (!options.replay.empty() && preset.steering.empty())
    throw scene::InputError(
        {scene::Issue{.file = options.replay,
                      .key = {},
                      .text = fmt::format("holds no [[steering]]: a run that was steered leaves a {}",
                                          results::steering_name)}});
  return preset;
}

double checkpoint_seconds(const RunOptions& options) {
  const scene::Parsed<double> time = scene::read_quantity(options.checkpoint, scene::Dimension::time);
  if (time.value && *time.value > 0) return *time.value;
  throw scene::InputError(
      {scene::Issue{.file = "rift run",
                    .key = {},
                    .text = fmt::format("--checkpoint {}: {}", options.checkpoint,
                                        time.value ? "must be above 0 s" : time.problem)}});
}

ExitCode run(const RunOptions& options) {
  const scene::Preset preset = read_wish(options);
  const double checkpoint_s = checkpoint_seconds(options);
  const std::optional<double> budget = read_budget("rift run", options.budget);
  if (options.scene.print_config) {
    base::print_text(scene::preset_text(preset));
    return ExitCode::done;
  }
  (void)scenes_of_run(preset);  // a study is refused before a folder is claimed
  if (const std::string trouble = options.film->trouble_with(preset, options.force); !trouble.empty()) {
    base::message("rift run: {}\n", trouble);
    return ExitCode::bad_input;
  }
  const fs::path path = folder_for(options, preset);
  if (goes_on(options, preset, path))
    return resume({.run = path.string(),
                   .color = options.scene.color,
                   .budget = options.budget,
                   .threads = options.scene.threads,
                   .quiet = options.scene.quiet,
                   .json = options.scene.json,
                   .plain = options.plain,
                   .no_cache = options.scene.no_cache});
  const StopSignal stop(budget);
  ProgressLine line(progress_style(options.scene.quiet, options.scene.json));
  base::Cache cache = cache_for(options.scene);
  const Way way{options, preset, stop, line, checkpoint_s};
  const std::optional<simulation::Recorded> ran =
      wants_panel(options) ? run_live(way, path, cache) : run_plainly(way, path, cache);
  if (!ran) return stopped_by(stop);
  const FilmOfRun::Result film = options.film->finish(line, [&] { return stop.received() == 0; });
  line.clear();
  print_notes(cache);
  print_run(ran->summary, path, options.scene.json, wants_color(options.scene.color, stdout), film.path);
  if (!film.trouble.empty()) base::message("rift run: no film: {}\n", film.trouble);
  const ExitCode code = exit_code_of(ran->result.outcome, stop);
  return code == ExitCode::done && !film.trouble.empty() ? ExitCode::world_failed : code;
}

}  // namespace

void add_run(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command =
      *app.add_subcommand("run", "One scene: a plate, a crack, its dynamic energy release rate");
  const auto options = std::make_shared<RunOptions>();
  add_scene_options(command, options->scene);
  options->film = std::make_unique<FilmOfRun>(command);
  command.add_option("--out", options->out, "Folder of the run (default: runs/NAME, numbered if it exists)");
  command
      .add_option("--checkpoint", options->checkpoint,
                  "Time between two checkpoints, for 'rift resume' after a kill or a power cut")
      ->capture_default_str();
  command.add_option(
      "--budget", options->budget,
      "Stop after this time (\"2 h\") with exit code 4: the same command, or 'rift resume', goes on from its "
      "checkpoint; before the first step nothing is written");
  command.add_flag("--plain", options->plain, "Lines of progress in place of the live panel");
  command.add_flag("--force", options->force, "Replace the run that is in the folder");
  CLI::Option* preset = command.get_option("preset");
  CLI::Option* replay = command.add_option(
      "--replay", options->replay,
      fmt::format("Repeat a run that was steered, to the bit: its {}", results::steering_name));
  preset->required(false)->excludes(replay);
  command.callback([options, preset, &exit_code] {
    if (options->scene.preset.empty() && options->replay.empty())
      throw CLI::RequiredError(preset->get_name());
    if (!options->replay.empty()) options->scene.preset = options->replay;
    exit_code = run(*options);
  });
}

}  // namespace rift::studio
