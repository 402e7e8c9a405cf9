#pragma once

#include "engine/base/cache.hpp"
#include "engine/scene/preset.hpp"
#include "studio/commands/stop_signal.hpp"
#include "studio/text/progress.hpp"

#include <CLI/App.hpp>

#include <string>
#include <vector>

namespace rift::studio {

/// What every command that takes a preset has in common.
struct SceneOptions {
  std::string preset;
  std::vector<std::string> overrides;
  bool quiet = false, json = false, no_cache = false, print_config = false;
  std::string color;
  int threads = 0;  // 0 for one per available CPU
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
scene::Preset read_scene(const SceneOptions& options);

/// What `rift run` and `rift check` take: one scene, or one ensemble of lanes. Throws InputError for a study.
std::vector<scene::Scene> scenes_of_run(const scene::Preset& preset);

/// The user's cache, or none with --no-cache.
base::Cache cache_for(const SceneOptions& options);

/// What the cache has to say, on stderr.
void print_notes(const base::Cache& cache);

}  // namespace rift::studio
