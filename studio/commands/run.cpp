#include "engine/base/interrupted.hpp"
#include "engine/base/process_limits.hpp"
#include "engine/base/world_error.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/scene/units.hpp"
#include "engine/simulation/record.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/film_of_run.hpp"
#include "studio/commands/run_panel.hpp"
#include "studio/commands/session.hpp"
#include "studio/commands/step_error.hpp"
#include "studio/text/run_table.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

/// `rift run` and `rift resume`, which goes on with what the first has left.
namespace rift::studio {
namespace fs = std::filesystem;
namespace {

struct RunOptions : SceneOptions {
  std::string out, replay, budget, checkpoint = "30 s";
  bool force = false;
  std::unique_ptr<FilmOfRun> film;
};

struct ResumeOptions : SessionOptions {
  std::string run, budget;
};

/// Shows the march a few times a second; Ctrl-C is heard here.
simulation::Observer observer_of(Session& session, std::size_t elements) {
  simulation::Observer observer;
  observer.go_on = [&session, elements](const simulation::Progress& p) {
    const double speed = static_cast<double>(p.step) * static_cast<double>(elements) / p.seconds;
    const char* stage = p.phase == results::Phase::loading ? "loading"
                        : p.phase == results::Phase::hold  ? "stabilising"
                                                           : "crack";
    return session.progress(stage, static_cast<double>(p.step) / static_cast<double>(p.total),
                            magnitude_text(speed) + " element-steps/s");
  };
  observer.stage = [&session](const char* stage) { session.progress(stage, 0.0); };
  return observer;
}

/// The table of every scenario and where the files are, or with --json the summary.
void print_run(const Session& session, const nlohmann::ordered_json& summary, const fs::path& folder,
               const std::string& film = {}, const std::string& step_error = {}) {
  session.print_result(summary, [&] {
    bool any_stopped = false;
    for (const results::LaneSummary& lane : results::lane_summaries_of(summary.at("scenarios"))) {
      base::print_text(run_table(lane, session.color()));
      any_stopped = any_stopped || lane.outcome == simulation::name_of(simulation::Outcome::stopped);
    }
    if (!step_error.empty()) base::print("  {:<22}{}\n", "accuracy", step_error);
    base::print("  {:<22}{}/  summary.json, series.csv, run.vtkhdf (ParaView 5.12 or later)\n", "files",
                folder.string());
    if (!film.empty()) base::print("  {:<22}{}\n", "film", film);
    if (any_stopped) base::print("  {:<22}rift resume {}\n", "resume with", folder.string());
  });
}

/// That a run was stopped before its first step, where nothing can be kept, and what the same command does
/// then.
/// @param what  "stopped while packing";  @param then  what the folder is like now
void say_nothing_kept(Session& session, const std::string& what, const char* then) {
  session.message(
      fmt::format("{}{}: {}", what, session.ran_out_of_budget() ? " because the budget ran out" : "", then));
}

bool wants_panel(const SessionOptions& options) {
  return !options.plain && !options.quiet && !options.json && panel_there();
}

// rift resume

std::optional<simulation::Recorded> resume_plainly(const ResumeOptions& options, const scene::Preset& preset,
                                                   Session& session) try {
  const base::Clock::time_point start = base::Clock::now();
  const simulation::Prepared prepared =
      simulation::prepare(preset, scenes_of_run(preset), session.cache, session.progress_of_stages());
  const double preparation_s = base::seconds_since(start);
  std::string note;
  auto ran = simulation::resume_run(prepared, options.run, build_info(),
                                    observer_of(session, prepared.lattice.centre.size()), note,
                                    {.threads = options.threads}, preparation_s);
  session.line.clear();
  if (!note.empty()) session.message(note);
  return ran;
} catch (const base::Interrupted& interrupted) {
  say_nothing_kept(session, interrupted.what(), "the run is unchanged, and the same command continues it");
  return std::nullopt;
}

std::optional<simulation::Recorded> resume_live(const ResumeOptions& options, const scene::Preset& preset,
                                                const Session& session) {
  RunRequest request{.preset = preset,
                     .folder = options.run,
                     .resume = true,
                     .threads = options.threads,
                     .cache = session.cache,
                     .build = build_info()};
  return run_in_panel(std::move(request), session.color(), session.stop);
}

ExitCode resume(const ResumeOptions& options) {
  const std::optional<double> budget = read_budget("rift resume", options.budget);
  check_is_run(options.run);
  if (results::is_folder_being_written(options.run))
    throw base::WorldError("resume", options.run, "another process is writing it");
  if (simulation::complete_end(options.run)) {
    base::message("rift resume: {} is already finished; its missing files were rebuilt from the journal\n",
                  options.run);
    return ExitCode::done;
  }
  if (simulation::has_ended(options.run)) {
    base::message("rift resume: {} is already finished; there is nothing to resume\n", options.run);
    return ExitCode::done;
  }
  const scene::Preset preset = simulation::preset_of_run(options.run);
  Session session("rift resume", options, budget);
  std::optional<simulation::Recorded> ran;
  try {
    ran = wants_panel(options) ? resume_live(options, preset, session)
                               : resume_plainly(options, preset, session);
  } catch (const std::invalid_argument& error) {
    throw base::WorldError("resume", options.run, error.what());
  }
  if (!ran) return session.stopped();
  session.print_notes();
  print_run(session, ran->summary, options.run);
  return session.ended(ran->result.outcome);
}

// rift run

constexpr const char* nothing_written = "nothing was written; the same command starts from the beginning";

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
  const std::string name = options.replay.empty() ? fs::path(options.preset).stem().string() : "replay";
  fs::path folder = fs::path("runs") / name;
  for (int k = 2; fs::exists(folder) && !goes_on(options, preset, folder); ++k)
    folder = fs::path("runs") / fmt::format("{}-{}", name, k);
  return folder;
}

void begin_film(const RunOptions& options, const fs::path& folder) {
  options.film->begin(folder, options.threads > 0 && options.threads < base::available_cpus());
}

/// With lines of progress. Nothing where the user stopped it before its first step.
std::optional<simulation::Recorded> run_plainly(const RunOptions& options, const scene::Preset& preset,
                                                const fs::path& path, double checkpoint_s,
                                                Session& session) try {
  results::ClaimedFolder folder(path, options.force);
  if (!folder.has_locks()) session.message(simulation::no_locks_note(path));
  const simulation::Prepared prepared =
      simulation::prepare(preset, scenes_of_run(preset), session.cache, session.progress_of_stages());
  simulation::check_grip(prepared);
  begin_film(options, folder.keep());
  return simulation::record_run(
      prepared, path, build_info(), observer_of(session, prepared.lattice.centre.size()),
      {.threads = options.threads, .checkpoint_s = checkpoint_s}, session.seconds());
} catch (const base::Interrupted& interrupted) {
  say_nothing_kept(session, interrupted.what(), nothing_written);
  return std::nullopt;
}

/// In the live panel.
std::optional<simulation::Recorded> run_live(const RunOptions& options, const scene::Preset& preset,
                                             const fs::path& path, double checkpoint_s, Session& session) {
  RunRequest request{.preset = preset,
                     .folder = path,
                     .force = options.force,
                     .threads = options.threads,
                     .checkpoint_s = checkpoint_s,
                     .cache = session.cache,
                     .build = build_info(),
                     .began = [&](const fs::path& folder) { begin_film(options, folder); }};
  auto ran = run_in_panel(std::move(request), session.color(), session.stop);
  if (!ran) say_nothing_kept(session, "stopped before the first step", nothing_written);
  return ran;
}

/// A preset, or with --replay the one that a steered run has left.
scene::Preset read_run(const RunOptions& options) {
  scene::Preset preset = read_scene(options);
  if (!options.replay.empty() && preset.steering.empty())
    refuse(options.replay, fmt::format("holds no [[steering]] table; a steered run writes one into its {}",
                                       results::steering_name));
  return preset;
}

double checkpoint_seconds(const RunOptions& options) {
  const scene::Parsed<double> time = scene::read_quantity(options.checkpoint, scene::Dimension::time);
  if (time.value && *time.value > 0) return *time.value;
  refuse("rift run", fmt::format("--checkpoint {}: {}", options.checkpoint,
                                 time.value ? "must be above 0 s" : time.problem));
}

ExitCode run(const RunOptions& options) {
  const scene::Preset preset = read_run(options);
  const double checkpoint_s = checkpoint_seconds(options);
  const std::optional<double> budget = read_budget("rift run", options.budget);
  if (prints_config(options, preset)) return ExitCode::done;
  (void)scenes_of_run(preset);  // a study is refused before a folder is claimed
  if (const std::string trouble = options.film->trouble_with(preset, options.force); !trouble.empty()) {
    base::message("rift run: {}\n", trouble);
    return ExitCode::bad_input;
  }
  const fs::path path = folder_for(options, preset);
  if (goes_on(options, preset, path)) {
    const ResumeOptions going_on{options, path.string(), options.budget};
    return resume(going_on);
  }
  Session session("rift run", options, budget);
  const std::optional<simulation::Recorded> ran =
      wants_panel(options) ? run_live(options, preset, path, checkpoint_s, session)
                           : run_plainly(options, preset, path, checkpoint_s, session);
  if (!ran) return session.stopped();
  const FilmOfRun::Result film = options.film->finish(session);
  session.line.clear();
  session.print_notes();
  print_run(session, ran->summary, path, film.path,
            options.replay.empty() ? step_error_text(options, preset) : "");
  if (!film.trouble.empty()) session.message("no film: " + film.trouble);
  const ExitCode code = session.ended(ran->result.outcome);
  return code == ExitCode::done && !film.trouble.empty() ? ExitCode::world_failed : code;
}

}  // namespace

void add_run(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "run", "Compute one scene: a crack through a plate and its dynamic energy release rate");
  const auto options = std::make_shared<RunOptions>();
  add_scene_options(command, *options);
  options->film = std::make_unique<FilmOfRun>(command);
  command
      .add_option("-o,--out", options->out, "Folder of the run (default: runs/NAME, numbered if it exists)")
      ->type_name("FOLDER");
  command
      .add_option("--checkpoint", options->checkpoint,
                  "Time between two checkpoints, for 'rift resume' after a kill or a power cut")
      ->type_name("TIME")
      ->capture_default_str();
  command
      .add_option("--budget", options->budget,
                  "Stop after this time (\"2 h\") with exit code 4: the same command, or 'rift resume', "
                  "continues from the checkpoint; before the first step nothing is written")
      ->type_name("TIME");
  command.add_flag("-f,--force", options->force, "Replace the run that is in the folder");
  CLI::Option* preset = command.get_option("preset");
  CLI::Option* replay =
      command
          .add_option("--replay", options->replay,
                      fmt::format("Repeat a steered run bit for bit from its {}", results::steering_name))
          ->type_name("FILE");
  preset->required(false)->excludes(replay);
  command.callback([options, preset, &exit_code] {
    if (options->preset.empty() && options->replay.empty()) throw CLI::RequiredError(preset->get_name());
    if (!options->replay.empty()) options->preset = options->replay;
    exit_code = run(*options);
  });
}

void add_resume(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "resume", "Resume a run that was stopped or killed; the results are the same to the bit");
  const auto options = std::make_shared<ResumeOptions>();
  command.add_option("run", options->run, "Folder of the run")->type_name("FOLDER")->required();
  add_threads(command, *options);
  command
      .add_option(
          "--budget", options->budget,
          "Stop after this time (\"2 h\") with a checkpoint and exit code 4; the same command continues")
      ->type_name("TIME");
  add_plain(command, *options);
  add_quiet(command, *options);
  add_json(command, *options);
  add_no_cache(command, *options);
  add_color_option(command, options->color);
  command.callback([options, &exit_code] { exit_code = resume(*options); });
}

}  // namespace rift::studio
