#include "studio/commands/commands.hpp"
#include "studio/commands/graphics_options.hpp"
#include "studio/commands/run_panel.hpp"
#include "studio/terminal/event_loop.hpp"
#include "studio/terminal/terminal.hpp"
#include "studio/workbench/home_screen.hpp"
#include "studio/workbench/screen.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace rift::studio {
namespace {

struct StudioOptions : SessionOptions {
  std::string preset, lesson;
};

std::unique_ptr<Screen> first_screen(const StudioOptions& options, AppContext& context) {
  if (!options.lesson.empty()) return lesson_screen(context, options.lesson);
  if (!options.preset.empty()) return form_of_preset(context, resolve_preset(options.preset));
  return std::make_unique<HomeScreen>(context);
}

ExitCode open_studio(const StudioOptions& options) {
  if (const std::string why = Terminal::why_not(); !why.empty()) {
    base::message(
        "rift studio: needs a terminal, and this is {}; without one 'rift run PRESET' runs a scene, 'rift "
        "study PRESET' a study, 'rift list' shows the presets, 'rift --help' the rest\n",
        why);
    return ExitCode::bad_input;
  }
  const GraphicsWish wish = graphics_wish("rift studio", {});  // refused before a lesson's run starts
  AppContext context = app_context(options.threads);
  return work_in_terminal(first_screen(options, context), Session("rift studio", options), wish);
}

}  // namespace

ExitCode open_studio() { return open_studio(StudioOptions{}); }

void add_studio(CLI::App& app, ExitCode& exit_code) {
  CLI::App& command =
      *app.add_subcommand("studio", "The workbench in the terminal; 'rift' alone opens it too");
  const auto options = std::make_shared<StudioOptions>();
  CLI::Option* preset =
      command.add_option("preset", options->preset, "A preset to begin with")->type_name("NAME|FILE");
  command
      .add_option("--lesson", options->lesson,
                  "A guided lesson with a live run: node-release, damping, velocity")
      ->type_name("NAME")
      ->excludes(preset);
  command
      .add_option("--threads", options->threads, "Threads (default: one per CPU that this process may use)")
      ->check(CLI::Range(1, 1024));
  add_color_option(command, options->color);
  command.callback([options, &exit_code] { exit_code = open_studio(*options); });
}

}  // namespace rift::studio
