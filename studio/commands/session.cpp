#include "studio/commands/session.hpp"

#include "engine/base/interrupted.hpp"
#include "engine/base/text.hpp"
#include "engine/base/world_error.hpp"
#include "studio/commands/help.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <csignal>

namespace rift::studio {

void add_threads(CLI::App& command, SessionOptions& options) {
  command
      .add_option("--threads", options.threads,
                  "Threads (default: one per CPU that this process may use); the results do not depend on it")
      ->check(CLI::Range(1, 1024));
}

void add_quiet(CLI::App& command, SessionOptions& options) {
  command.add_flag("-q,--quiet", options.quiet, "No progress on stderr");
}

void add_plain(CLI::App& command, SessionOptions& options) {
  command.add_flag("--plain", options.plain,
                   "Progress line by line, with no panel and no line that is redrawn");
}

void add_json(CLI::App& command, SessionOptions& options) {
  command.add_flag("-j,--json", options.json,
                   "Progress as JSON lines on stderr, the result as JSON on stdout");
}

void add_no_cache(CLI::App& command, SessionOptions& options) {
  command.add_flag("--no-cache", options.no_cache,
                   "Neither read nor write the cache of packings and pre-stresses");
}

void add_scene_options(CLI::App& command, SceneOptions& options) {
  options.command = &command;
  command.add_option("preset", options.preset, "A preset file, or the name of one that 'rift list' shows")
      ->type_name("NAME|FILE")
      ->required();
  command
      .add_option("--set", options.overrides,
                  "key=value: any parameter of docs/parameters.md; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  add_threads(command, options);
  add_quiet(command, options);
  add_plain(command, options);
  add_json(command, options);
  add_no_cache(command, options);
  command.add_flag("--print-config", options.print_config, "Print the effective preset and stop");
  add_color_option(command, options.color);
}

void add_report_options(CLI::App& command, ReportOptions& options, const std::string& holds) {
  add_scene_options(command, options);
  command.get_option("preset")->required(false);
  command.add_option("-o,--out", options.out, "Folder of a report: " + holds)->type_name("FOLDER");
  command.add_flag("-f,--force", options.force, "Replace the results of an earlier run in the folder");
}

scene::Preset without_mistakes(scene::Preset preset) {
  if (!preset.issues.empty()) throw scene::InputError(preset.issues);
  return preset;
}

namespace {

/// A --set of a key that no parameter is near to may mean an option.
void suggest_options(const CLI::App& command, std::vector<scene::Issue>& issues) {
  for (scene::Issue& issue : issues) {
    if (issue.file != "--set" || !scene::nearest_key(issue.key).empty()) continue;
    const std::string option = nearest_option(command, issue.key);
    if (!option.empty()) issue.text += fmt::format("; '{}' is an option of {}", option, command.get_name());
  }
}

}  // namespace

scene::Preset read_scene(const SceneOptions& options) {
  scene::Preset preset = scene::read_preset(resolve_preset(options.preset), options.overrides);
  suggest_options(*options.command, preset.issues);
  preset = without_mistakes(std::move(preset));
  for (const std::string& note : preset.notes) base::message("note: {}\n", note);
  return preset;
}

bool prints_config(const SceneOptions& options, const scene::Preset& preset) {
  if (options.print_config) base::print_text(scene::preset_text(preset));
  return options.print_config;
}

std::vector<scene::Scene> scenes_of_run(const scene::Preset& preset) {
  if (!preset.study.empty())
    refuse(preset.name, fmt::format("holds a study of {} scenarios: 'rift study {}' computes it",
                                    preset.study.size(), preset.name));
  return preset.lanes.empty() ? std::vector<scene::Scene>{preset.scene} : preset.lanes;
}

base::Cache cache_for(const SessionOptions& options) {
  return options.no_cache ? base::Cache{} : base::user_cache();
}

void print_notes(const base::Cache& cache) {
  for (const std::string& note : cache.notes) base::message("cache: {}\n", note);
}

std::string command_with_preset(const std::string& name, const SceneOptions& options) {
  std::string text = options.preset.empty() ? name : name + " " + options.preset;
  for (const std::string& set : options.overrides) text += fmt::format(" --set '{}'", set);
  return text;
}

Session::Session(std::string name, const SessionOptions& how, std::optional<double> budget)
    : options(how),
      stop(budget),
      line(progress_style(how.quiet, how.json, how.plain)),
      cache(cache_for(how)),
      name_(std::move(name)) {}

bool Session::progress(std::string_view stage, double done, std::string_view rate) {
  line.show(stage, done, rate);
  return goes_on();
}

std::function<bool(double)> Session::progress_of(std::string stage) {
  return [this, stage = std::move(stage)](double done) { return progress(stage, done); };
}

std::function<bool(std::string_view, double)> Session::progress_of_stages() {
  return [this](std::string_view stage, double done) { return progress(stage, done); };
}

void Session::message(std::string_view text) {
  line.clear();
  base::message("{}: {}\n", name_, text);
}

void Session::print_result(const nlohmann::ordered_json& json, const std::function<void()>& print) const {
  if (options.json)
    base::print_text(base::json_text(json, 2) + "\n");
  else
    print();
}

void Session::write(const std::function<void()>& report) {
  line.show("report", 0.0);
  report();
  line.clear();
}

ExitCode Session::write_or_say(const std::function<void()>& report) try {
  write(report);
  return ExitCode::done;
} catch (const base::WorldError& error) {
  message(error.what());
  return ExitCode::world_failed;
}

ExitCode Session::until_stopped(const std::function<ExitCode()>& work, std::string_view what_is_left) try {
  return work();
} catch (const base::Interrupted& interrupted) {
  message(fmt::format("{}{}", interrupted.what(), what_is_left));
  return stopped();
}

ExitCode Session::stopped() const {
  if (ran_out_of_budget()) return ExitCode::budget_ran_out;
  return static_cast<ExitCode>(128 + (stop.received() != 0 ? stop.received() : SIGINT));
}

ExitCode Session::ended(simulation::Outcome outcome) const {
  if (outcome == simulation::Outcome::diverged) return ExitCode::diverged;
  return outcome == simulation::Outcome::stopped ? stopped() : ExitCode::done;
}

}  // namespace rift::studio
