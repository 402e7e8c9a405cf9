#pragma once

#include "engine/cache.hpp"
#include "engine/scene/preset.hpp"
#include "studio/report/progress.hpp"

#include <CLI/App.hpp>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace rift::studio {

/// What every command that takes a preset has in common.
struct SceneOptions {
  std::string preset;
  std::vector<std::string> overrides;
  bool quiet = false, json = false, no_cache = false, print_config = false;
  std::string color;
  int threads = 0;  // 0 for one per core
};

void add_scene_options(CLI::App& command, SceneOptions& options);

/// What commands have in common that leave a report, and that know what to do without a preset.
struct ReportOptions {
  SceneOptions scene;
  std::string out;  // empty: no report
  bool force = false;
};

/// @param[in] holds  what the report's folder holds, for --help
void add_report_options(CLI::App& command, ReportOptions& options, const std::string& holds);

/// Reads and checks the preset, and prints its notes on stderr; throws InputError with every mistake.
Preset read_scene(const SceneOptions& options);

/// What `rift run` and `rift check` take: one scene, or one ensemble of lanes. Throws InputError for a study.
std::vector<Scene> scenes_of_run(const Preset& preset);

/// The user's cache, or none with --no-cache.
Cache cache_for(const SceneOptions& options);

/// What the cache has to say, on stderr.
void print_notes(const Cache& cache);

/// SIGINT, SIGTERM and SIGHUP no longer kill, but set a flag that long work looks at; a time that is up
/// counts as one. Lives as long as the command.
class StopSignal {
 public:
  /// @param budget  [s] from now, none for ever
  explicit StopSignal(std::optional<double> budget = {});
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;
  static constexpr int time_is_up = -1;
  int received() const;  // the signal's number, 0 for none

 private:
  std::optional<std::chrono::steady_clock::time_point> until_;
};

}  // namespace rift::studio
