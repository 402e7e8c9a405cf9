#include "engine/accuracy/cases.hpp"
#include "engine/base/files.hpp"
#include "engine/base/text.hpp"
#include "engine/results/archive.hpp"
#include "engine/results/json_input.hpp"
#include "engine/results/run_folder.hpp"
#include "engine/scene/text_differences.hpp"
#include "engine/study/store.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/session.hpp"
#include "studio/commands/step_error.hpp"
#include "studio/reports/accuracy_report.hpp"
#include "studio/reports/study_report.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

namespace rift::studio {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

constexpr double long_s = 600.0;

struct AccuracyCommand : SceneOptions {
  std::string out, budget;
  std::vector<int> elements;
  int seeds = 3;
  double goal = 0.01;
  bool quick = false, yes = false;
};

void check_one_scene(const scene::Preset& preset) {
  if (preset.study.empty() && preset.lanes.empty()) return;
  refuse(preset.name,
         fmt::format(
             "holds {}: 'rift accuracy' varies one scene and takes a preset without [study] and [[lanes]]",
             preset.study.empty() ? "lanes" : "a study"));
}

/// A text of a mark; empty where it has none.
std::string text_of(const Json& mark, const char* name) {
  return mark.is_object() && mark.contains(name) && mark.at(name).is_string()
             ? mark.at(name).get<std::string>()
             : std::string();
}

/// Refuses the folder of another scene. A damaged mark is written again: each scenario says what it is of.
void check_mark(const fs::path& folder, const Json& there, const Json& mark) {
  const std::string scene = text_of(there, "scene"), before = text_of(there, "preset_text");
  if (scene.empty() || scene == mark.at("scene")) return;
  throw results::FolderExists(
      fmt::format("{} holds the results of 'rift accuracy' for another scene (of {}){}; nothing was changed: "
                  "choose another folder with --out",
                  folder.string(), text_of(there, "accuracy_of"),
                  before.empty() ? "" : scene::differences_text(before, mark.at("preset_text"))));
}

/// Makes the folder, or goes on in one of the same scene; anything else is left alone.
void open_folder(const fs::path& folder, const scene::Preset& preset) {
  std::error_code ignored;
  const fs::path file = folder / "accuracy.json";
  const Json mark = accuracy_mark(preset);
  if (fs::exists(file))
    check_mark(folder, results::json_or_discarded(base::read_whole_file(file)), mark);
  else if (fs::exists(folder, ignored) && !fs::is_empty(folder, ignored))
    throw results::FolderExists(fmt::format(
        "{} is not empty and holds no results of 'rift accuracy': choose another folder with --out",
        folder.string()));
  base::make_folder(folder);
  base::write_whole_file(file, base::json_text(mark, 2) + "\n");
}

/// The user's cache. With --no-cache one within the folder, gone at the end: cases share their packings.
struct PackingCache {
  PackingCache(const SessionOptions& options, const fs::path& folder)
      : own(options.no_cache ? base::temporary_name(folder / "cache") : fs::path()),
        cache(options.no_cache ? base::Cache{own, {}} : base::user_cache()) {}
  ~PackingCache() {
    std::error_code ignored;
    if (!own.empty()) fs::remove_all(own, ignored);
  }
  PackingCache(const PackingCache&) = delete;
  PackingCache& operator=(const PackingCache&) = delete;
  fs::path own;
  base::Cache cache;
};

void show_finished(Session& session, const accuracy::Case& variant, const study::SummaryRow& row, int done,
                   int of) {
  session.line.clear();
  if (session.options.quiet) return;
  if (session.options.json) {
    const Json json{
        {"finished", variant.label}, {"knob", accuracy::name_of(variant.factor)}, {"done", done}, {"of", of}};
    base::message("{}\n", base::json_text(json));
    return;
  }
  base::message("[{}/{}] {}: {}: ratio {:.5f}  {:.2f} s\n", done, of, accuracy::name_of(variant.factor),
                variant.label, row.ratio, row.wall_fracture_s);
}

std::string command_text(const AccuracyCommand& command) {
  std::string text = command_with_preset("rift accuracy", command);
  if (!command.elements.empty()) text += fmt::format(" --elements {}", fmt::join(command.elements, ","));
  if (command.quick) text += " --quick";
  return text + fmt::format(" --seeds {} --goal {:g}", command.seeds, command.goal);
}

ExitCode compute(const AccuracyCommand& command, const scene::Preset& preset,
                 const accuracy::AccuracyPlan& plan, const fs::path& folder, std::optional<double> budget) {
  Session session("rift accuracy", command, budget);
  PackingCache packings(command, folder);
  study::StudyOptions options;
  options.folder = folder;
  options.threads = command.threads;
  study::StudyObserver observer;
  observer.progress = [&](std::string_view stage, double done) {
    return session.progress("accuracy", done, stage);
  };
  observer.finished = [&](const study::SummaryRow& row, int done, int of) {
    show_finished(session, plan.cases[static_cast<std::size_t>(done) - 1], row, done, of);
  };
  accuracy::AccuracyRun run = accuracy::run_cases(plan, options, packings.cache, build_info(), observer);
  if (run.outcome == simulation::Outcome::stopped) {
    session.message(
        fmt::format("{}; {} of {} variants are stored in {}: the same command continues from there",
                    session.ran_out_of_budget() ? "the budget ran out" : "stopped", run.computed + run.found,
                    run.results.size(), folder.string()));
    return session.stopped();
  }
  AccuracyReport report{.preset = preset.name,
                        .command = command_text(command),
                        .build = build_info(),
                        .notes = plan.notes,
                        .results = run.results,
                        .accuracy = accuracy::judge_accuracy(run.results, command.goal),
                        .goal = command.goal,
                        .lanes = {},
                        .wall_s = 0};
  if (const int chosen = report.accuracy.recommended; chosen >= 0) {
    const accuracy::AccuracyLine& best = report.accuracy.lines[static_cast<std::size_t>(chosen)];
    const scene::Scene& scene = run.results[static_cast<std::size_t>(best.results.front())].setup.scene;
    observer.finished = {};
    report.lanes = accuracy::fill_lanes(plan, scene, options, packings.cache, build_info(), observer);
  }
  session.line.clear();
  print_notes(packings.cache);
  report.wall_s = session.seconds();
  base::write_whole_file(folder / "table.csv", study_csv(accuracy_rows(report)));
  base::write_whole_file(folder / results::summary_name, base::json_text(accuracy_json(report), 2) + "\n");
  const ExitCode files = session.write_or_say([&] { write_accuracy_report(report, folder); });
  session.print_result(accuracy_json(report), [&] {
    base::print_text(accuracy_text(report, session.color()));
    base::print("{} computed, {} reused, {} in total; {}/  summary.json, table.csv, report.html, charts\n",
                run.computed, run.found, duration_text(report.wall_s), folder.string());
  });
  return files != ExitCode::done ? files : session.ended(run.outcome);
}

ExitCode accuracy(const AccuracyCommand& command) {
  const std::optional<double> budget = read_budget("rift accuracy", command.budget);
  const scene::Preset preset = read_scene(command);
  check_one_scene(preset);
  if (prints_config(command, preset)) return ExitCode::done;
  const accuracy::AccuracyPlan plan = accuracy::plan_accuracy(
      preset, {.quick = command.quick, .elements = command.elements, .seeds = command.seeds});
  const double seconds = accuracy::estimated_seconds(plan);
  if (seconds > long_s && !command.yes && !budget)
    refuse("rift accuracy",
           fmt::format("this takes about {} with an empty cache (at 100 M beam-steps/s): --yes starts it, "
                       "--budget TIME computes what fits, --quick or smaller --elements take less",
                       duration_text(seconds)));
  const fs::path folder = command.out.empty() ? accuracy_folder(command.preset) : fs::path(command.out);
  open_folder(folder, preset);
  return compute(command, preset, plan, folder, budget);
}

}  // namespace

void add_accuracy(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command =
      *app.add_subcommand("accuracy",
                          "Error and run time of a scene against time step, precision, number of elements, "
                          "...; recommends the cheapest setting within a tolerance");
  const auto options = std::make_shared<AccuracyCommand>();
  add_scene_options(command, *options);
  command
      .add_option("-o,--out", options->out,
                  "Folder of the results (default: NAME_accuracy); one of the same scene is continued")
      ->type_name("FOLDER");
  command
      .add_option("--goal", options->goal, "Largest error of G_ID/G_I0 that the recommended variant may have")
      ->check(CLI::Range(1e-6, 1.0))
      ->capture_default_str();
  command
      .add_option(
          "--elements", options->elements,
          "Numbers of elements to compare, such as 1250,5000,20000,80000 (default: chosen by their cost)")
      ->delimiter(',')
      ->check(CLI::Range(100, 5'000'000));
  command.add_option("--seeds", options->seeds, "Specimens for each number of elements")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  command.add_flag("--quick", options->quick, "The same scene with a fourth of the elements, and no ramp");
  command
      .add_option("--budget", options->budget,
                  "Stop after this time (\"10 min\"); the same command continues")
      ->type_name("TIME");
  command.add_flag("--yes", options->yes, "Start even where it takes more than 10 minutes");
  command.callback([options, &exit_code] { exit_code = accuracy(*options); });
}

}  // namespace rift::studio
