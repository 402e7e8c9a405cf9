#include "engine/base/console.hpp"
#include "studio/commands/commands.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

// What a build without ncurses (-DRIFT_STUDIO_TUI=OFF) has in place of studio.cpp.
namespace rift::studio {

ExitCode open_studio() {
  base::message(
      "rift studio: this rift was built without its panels; build it with -DRIFT_STUDIO_TUI=ON (it needs "
      "ncurses); 'rift run PRESET' runs a scene, 'rift list' shows the presets\n");
  return ExitCode::bad_input;
}

void add_studio(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand("studio", "The workbench in the terminal (not in this build)");
  command.allow_extras();
  command.callback([&exit_code] { exit_code = open_studio(); });
}

}  // namespace rift::studio
