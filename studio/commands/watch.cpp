#include "studio/commands/commands.hpp"
#include "studio/commands/scene_options.hpp"
#include "studio/screen/live_of_run.hpp"
#include "studio/terminal/terminal.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace rift::studio {
namespace {

struct WatchOptions {
  std::string run, color;
};

/// The lane that a key asks for; otherwise the one that is shown.
int lane_after(int key, int shown, int lanes) {
  if (key == '\t') return (shown + 1) % lanes;
  const int asked = key - '1';
  return asked >= 0 && asked < lanes ? asked : shown;
}

ExitCode watch(const WatchOptions& options) {
  if (!Terminal::there()) {
    fmt::print(
        stderr,
        "rift watch: needs a terminal; without one, look at {0}/series.csv or rift render {0} --at 1\n",
        options.run);
    return ExitCode::bad_input;
  }
  LiveOfRun run(options.run);
  const StopSignal stop;
  Terminal terminal(wants_color(options.color, stdout));
  int shown = 0;
  const int lanes = static_cast<int>(run.live().lanes.size());
  for (int key = 0; key != 'q' && key != key_escape && stop.received() == 0;) {
    Canvas canvas(terminal.width(), terminal.height());
    draw_live(canvas, run.live(), shown,
              lanes > 1 ? "q leave (the run goes on)   1-8, tab lane" : "q leave (the run goes on)",
              terminal.glyphs());
    terminal.show(canvas);
    key = terminal.press(100).key;
    shown = lane_after(key, shown, lanes);
    run.look();
  }
  return stop.received() == 0 ? ExitCode::done : static_cast<ExitCode>(128 + stop.received());
}

}  // namespace

void add_watch(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command = *app.add_subcommand("watch", "A live panel of a run that goes on elsewhere, read only");
  const auto options = std::make_shared<WatchOptions>();
  command.add_option("run", options->run, "Folder of the run")->required();
  add_color_option(command, options->color);
  command.callback([options, &exit_code] { exit_code = watch(*options); });
}

}  // namespace rift::studio
