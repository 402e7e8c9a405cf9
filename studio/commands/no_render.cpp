#include "engine/base/console.hpp"
#include "studio/commands/commands.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

// What a build without VTK (-DRIFT_VIZ=OFF) has in place of render.cpp.
namespace rift::studio {

void add_render(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand("render", "Films and pictures of a run (not in this build)");
  command.allow_extras();
  command.callback([&exit_code] {
    base::message(
        "rift render: this rift was built without its renderer; build it with -DRIFT_VIZ=ON (it needs VTK), "
        "or look at the run in ParaView: rift export RUN --to pvd\n");
    exit_code = ExitCode::world_failed;
  });
}

}  // namespace rift::studio
