#include "engine/base/world_error.hpp"
#include "engine/results/run_folder.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/graphics_options.hpp"
#include "studio/commands/run_panel.hpp"
#include "studio/terminal/event_loop.hpp"
#include "studio/terminal/terminal.hpp"
#include "studio/workbench/panel_screen.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>

namespace rift::studio {
namespace {

struct WatchOptions : SessionOptions {
  std::string run;
};

ExitCode watch(const WatchOptions& options) {
  check_is_run(options.run);
  if (const results::RunState state = results::inspect_run(options.run); state.header_json.empty())
    throw base::WorldError("watch", options.run, state.reason);
  if (const std::string why = Terminal::why_not(); !why.empty()) {
    base::message(
        "rift watch: needs a terminal, and this is {0}; without one, look at {1}/series.csv or rift render "
        "{1} --at 1\n",
        why, options.run);
    return ExitCode::bad_input;
  }
  const GraphicsWish wish = graphics_wish("rift watch", {});
  AppContext context = app_context(0);
  auto screen = std::make_unique<WatchScreen>(context, options.run);
  return work_in_terminal(std::move(screen), Session("rift watch", options), wish);
}

}  // namespace

void add_watch(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command =
      *app.add_subcommand("watch", "Live panel of a run that another process computes, read only");
  const auto options = std::make_shared<WatchOptions>();
  command.add_option("run", options->run, "Folder of the run")->type_name("FOLDER")->required();
  add_color_option(command, options->color);
  command.callback([options, &exit_code] { exit_code = watch(*options); });
}

}  // namespace rift::studio
