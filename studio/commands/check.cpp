#include "engine/interrupted.hpp"
#include "engine/simulation/prepare.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/scene_options.hpp"
#include "studio/report/dry_run.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace rift::studio {
namespace {

using Json = nlohmann::ordered_json;

void print_table(const Json& j, const std::string& title, bool color) {
  fmt::print("{}\n", heading(title, color));
  for (const auto& [label, text] : dry_run_rows(j)) fmt::print("  {:<16}{}\n", label, text);
}

ExitCode check(const SceneOptions& options) {
  const Preset preset = read_scene(options);
  if (options.print_config) {
    fmt::print("{}", preset_text(preset));
    return ExitCode::done;
  }
  const std::vector<Scene> lanes = scenes_of_run(preset);
  const StopSignal stop;
  ProgressLine line(progress_style(options.quiet, options.json));
  Cache cache = cache_for(options);
  try {
    const Prepared prepared = prepare(preset, lanes, cache, [&](std::string_view stage, double done) {
      line.tell(stage, done);
      return stop.received() == 0;
    });
    const Json j = dry_run(prepared, options.threads);
    line.clear();
    print_notes(cache);
    if (options.json) {
      fmt::print("{}\n", j.dump(2));
    } else {
      print_table(j, prepared.preset.name, wants_color(options.color, stdout));
    }
  } catch (const Interrupted& interrupted) {
    line.clear();
    fmt::print(stderr, "rift check: {}\n", interrupted.what());
    return static_cast<ExitCode>(128 + stop.received());
  }
  return ExitCode::done;
}

}  // namespace

void add_check(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command =
      *app.add_subcommand("check", "Dry run: what follows from a preset, its step, cost, what it leaves out");
  const auto options = std::make_shared<SceneOptions>();
  add_scene_options(command, *options);
  command.callback([options, &exit_code] { exit_code = check(*options); });
}

}  // namespace rift::studio
