#include "engine/base/console.hpp"
#include "studio/commands/commands.hpp"

#include <CLI/CLI.hpp>

/// What a build with VTK and without ncurses (-DRIFT_STUDIO_TUI=OFF) has in place of view.cpp.
namespace rift::studio {

void add_view(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand("view", "A run's pictures in the terminal (not in this build)");
  command.allow_extras();
  command.callback([&exit_code] {
    base::message(
        "rift view: this rift was built without its panels; build it with -DRIFT_STUDIO_TUI=ON (it needs "
        "ncurses)\n");
    exit_code = ExitCode::world_failed;
  });
}

}  // namespace rift::studio
