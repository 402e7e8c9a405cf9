#include "engine/base/console.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/run_panel.hpp"

#include <CLI/CLI.hpp>

/// What a build without ncurses (-DRIFT_STUDIO_TUI=OFF) has in place of run_panel.cpp, studio.cpp and
/// watch.cpp.
namespace rift::studio {
namespace {

constexpr const char* without_panels =
    "this rift was built without its panels; build it with -DRIFT_STUDIO_TUI=ON (it needs ncurses)";

}  // namespace

bool panel_there() { return false; }

std::optional<simulation::Recorded> run_in_panel(RunRequest, bool, const StopSignal&) { return std::nullopt; }

ExitCode open_studio() {
  base::message("rift studio: {}; 'rift run PRESET' runs a scene, 'rift list' shows the presets\n",
                without_panels);
  return ExitCode::bad_input;
}

void add_studio(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand("studio", "The workbench in the terminal (not in this build)");
  command.allow_extras();
  command.callback([&exit_code] { exit_code = open_studio(); });
}

void add_watch(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand("watch", "A live panel of a run (not in this build)");
  command.allow_extras();
  command.callback([&exit_code] {
    base::message("rift watch: {}\n", without_panels);
    exit_code = ExitCode::world_failed;
  });
}

}  // namespace rift::studio
