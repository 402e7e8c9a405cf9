#include "engine/base/console.hpp"
#include "studio/commands/commands.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

// What a build without ncurses (-DRIFT_STUDIO_TUI=OFF) has in place of watch.cpp.
namespace rift::studio {

void add_watch(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand("watch", "A live panel of a run (not in this build)");
  command.allow_extras();
  command.callback([&exit_code] {
    base::message(
        "rift watch: this rift was built without its panels; build it with -DRIFT_STUDIO_TUI=ON (it needs "
        "ncurses)\n");
    exit_code = ExitCode::world_failed;
  });
}

}  // namespace rift::studio
