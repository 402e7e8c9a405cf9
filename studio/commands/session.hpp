#pragma once

#include "engine/base/cache.hpp"
#include "engine/base/clock.hpp"
#include "engine/base/console.hpp"
#include "engine/scene/preset.hpp"
#include "engine/simulation/march.hpp"
#include "studio/commands/common.hpp"
#include "studio/commands/stop_signal.hpp"
#include "studio/text/progress.hpp"

#include <CLI/App.hpp>
#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rift::studio {

/// How a command works and speaks: options that many have, each added by a function of its own.
struct SessionOptions {
  bool quiet = false, json = false, no_cache = false, plain = false;
  std::string color = "auto";
  int threads = 0;  // 0 for one per available CPU
};

void add_threads(CLI::App& command, SessionOptions& options);
void add_quiet(CLI::App& command, SessionOptions& options);
void add_plain(CLI::App& command, SessionOptions& options);
void add_json(CLI::App& command, SessionOptions& options);
void add_no_cache(CLI::App& command, SessionOptions& options);

/// What every command that takes a preset has in common.
struct SceneOptions : SessionOptions {
  std::string preset;
  std::vector<std::string> overrides;
  bool print_config = false;
  const CLI::App* command = nullptr;  // that takes them
};

void add_scene_options(CLI::App& command, SceneOptions& options);

/// What commands have in common that leave a report, and that know what to do without a preset.
struct ReportOptions : SceneOptions {
  std::string out;  // empty: no report
  bool force = false;
};

/// @param[in] holds  what the report's folder holds, for --help
void add_report_options(CLI::App& command, ReportOptions& options, const std::string& holds);

/// The preset, or InputError with every mistake of it.
scene::Preset without_mistakes(scene::Preset preset);

/// Reads and checks the preset, and prints its notes on stderr; throws InputError with every mistake.
scene::Preset read_scene(const SceneOptions& options);

/// With --print-config: prints the preset. @return whether it did, and nothing else is to be done
bool prints_config(const SceneOptions& options, const scene::Preset& preset);

/// What `rift run` and `rift check` take: one scene, or one ensemble of lanes. Throws InputError for a study.
std::vector<scene::Scene> scenes_of_run(const scene::Preset& preset);

/// The user's cache, or none with --no-cache.
base::Cache cache_for(const SessionOptions& options);

/// What a cache has to say, on stderr.
void print_notes(const base::Cache& cache);

/// "rift accuracy quickstart --set 'a=b'": the command with its preset and overrides, as reports tell it.
std::string command_with_preset(const std::string& name, const SceneOptions& options);

/// A command at work: its clock, its line of progress, the signal that stops it, the cache, and what it
/// says.
class Session {
 public:
  /// @param name  "rift run", before each message;  @param budget  [s] from now, none for ever
  Session(std::string name, const SessionOptions& options, std::optional<double> budget = {});

  [[nodiscard]] double seconds() const { return base::seconds_since(start_); }
  [[nodiscard]] bool goes_on() const { return stop.received() == 0; }
  [[nodiscard]] bool ran_out_of_budget() const { return stop.received() == StopSignal::time_is_up; }
  [[nodiscard]] bool color() const { return wants_color(options.color, stdout); }

  /// Shows how far a stage is. @return whether the work goes on
  bool progress(std::string_view stage, double done, std::string_view rate = {});
  /// The same of one stage, and of many, as the engine asks for it.
  [[nodiscard]] std::function<bool(double)> progress_of(std::string stage);
  [[nodiscard]] std::function<bool(std::string_view, double)> progress_of_stages();

  /// "rift run: TEXT" on stderr, the line of progress taken away.
  void message(std::string_view text);
  void print_notes() const { studio::print_notes(cache); }
  /// The result on stdout: JSON with --json, else what `print` prints.
  void print_result(const nlohmann::ordered_json& json, const std::function<void()>& print) const;

  /// Writes a report while the line says so.
  void write(const std::function<void()>& report);
  /// The same; what cannot be written is said, and the result printed all the same.
  [[nodiscard]] ExitCode write_or_say(const std::function<void()>& report);

  /// Does the work; where the user stops it, says what was stopped and `what_is_left` of it.
  [[nodiscard]] ExitCode until_stopped(const std::function<ExitCode()>& work,
                                       std::string_view what_is_left = {});

  /// Stopped by a signal, by the budget, or by hand in the panel, which counts as a Ctrl-C.
  [[nodiscard]] ExitCode stopped() const;
  [[nodiscard]] ExitCode ended(simulation::Outcome outcome) const;

  const SessionOptions options;
  const StopSignal stop;
  ProgressLine line;
  base::Cache cache;

 private:
  std::string name_;
  base::Clock::time_point start_ = base::Clock::now();
};

}  // namespace rift::studio
