#include "studio/commands/scene_options.hpp"

#include "engine/base/console.hpp"
#include "studio/commands/common.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace rift::studio {
void add_scene_options(CLI::App& command, SceneOptions& options) {
  command.add_option("preset", options.preset, "A preset file, or the name of one that 'rift list' shows")
      ->required();
  command
      .add_option("--set", options.overrides,
                  "key=value: any parameter of docs/parameters.md; may be repeated")
      ->allow_extra_args(false);
  command
      .add_option("--threads", options.threads,
                  "Threads (default: one per CPU that this process may use); the results do not depend on it")
      ->check(CLI::Range(1, 1024));
  command.add_flag("--quiet", options.quiet, "No progress on stderr");
  command.add_flag("--json", options.json, "Progress as JSON lines on stderr, the result as JSON on stdout");
  command.add_flag("--no-cache", options.no_cache,
                   "Neither read nor write the cache of packings and pre-stresses");
  command.add_flag("--print-config", options.print_config, "Print the effective preset and stop");
  add_color_option(command, options.color);
}

void add_report_options(CLI::App& command, ReportOptions& options, const std::string& holds) {
  add_scene_options(command, options.scene);
  command.get_option("preset")->required(false);
  command.add_option("--out", options.out, "Folder of a report: " + holds);
  command.add_flag("--force", options.force, "Replace what a former run left in the folder");
}

scene::Preset read_scene(const SceneOptions& options) {
  scene::Preset preset = scene::read_preset(resolve_preset(options.preset), options.overrides);
  if (!preset.issues.empty()) throw scene::InputError(preset.issues);
  for (const std::string& note : preset.notes) base::message("note: {}\n", note);
  return preset;
}

std::vector<scene::Scene> scenes_of_run(const scene::Preset& preset) {
  if (!preset.study.empty())
    throw scene::InputError(
        {scene::Issue{.file = preset.name,
                      .key = {},
                      .text = fmt::format("holds a study of {} scenarios: 'rift study {}' computes it",
                                          preset.study.size(), preset.name)}});
  return preset.lanes.empty() ? std::vector<scene::Scene>{preset.scene} : preset.lanes;
}

base::Cache cache_for(const SceneOptions& options) {
  return options.no_cache ? base::Cache{} : base::user_cache();
}

void print_notes(const base::Cache& cache) {
  for (const std::string& note : cache.notes) base::message("cache: {}\n", note);
}

}  // namespace rift::studio
