#include "engine/base/text.hpp"
#include "engine/base/world_error.hpp"
#include "studio/commands/commands.hpp"
#include "studio/commands/film_of_run.hpp"
#include "studio/commands/graphics_options.hpp"
#include "studio/commands/run_panel.hpp"
#include "studio/terminal/event_loop.hpp"
#include "studio/terminal/terminal.hpp"
#include "studio/view/view_screen.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace rift::studio {
namespace {

struct ViewOptions : SessionOptions {
  FilmOptions look;
  GraphicsOptions graphics;
  std::vector<std::string> runs;
};

ExitCode view(ViewOptions& options) try {
  (void)read_look(options.look);
  const GraphicsWish wish = graphics_wish("rift view", options.graphics);
  for (const std::string& run : options.runs) {
    check_is_run(run);
    options.look.request.runs.emplace_back(run);
  }
  const AppContext context = app_context(0);
  auto screen = std::make_unique<ViewScreen>(options.look.request, gl_of(options.look), context.program);
  if (const std::string why = Terminal::why_not(); !why.empty()) {
    base::message("rift view: needs a terminal, and this is {}; without one rift render {} writes pictures\n",
                  why, options.runs.front());
    return ExitCode::bad_input;
  }
  const Session session("rift view", options);
  std::vector<std::string> commands;
  screen->commands_go_to(commands);
  const ExitCode code = work_in_terminal(std::move(screen), session, wish);
  for (const std::string& command : commands) base::print_text(base::escaped(command) + "\n");
  return code;
} catch (const viz::BadRequest& mistake) {
  base::message("rift view: {}\n", mistake.what());
  return ExitCode::bad_input;
}

}  // namespace

void add_view(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command =
      *app.add_subcommand("view", "A run's pictures in the terminal: played, turned, zoomed and asked");
  const auto options = std::make_shared<ViewOptions>();
  add_drawn_runs(command, options->runs, options->look, "shown");
  add_graphics_options(command, options->graphics);
  add_color_option(command, options->color);
  add_film_options(command, options->look);
  command.callback([options, &exit_code] { exit_code = view(*options); });
}

}  // namespace rift::studio
