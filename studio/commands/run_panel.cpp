#include "studio/commands/run_panel.hpp"

#include "studio/commands/graphics_options.hpp"
#include "studio/commands/plate_pictures.hpp"
#include "studio/terminal/event_loop.hpp"
#include "studio/terminal/terminal.hpp"
#include "studio/workbench/panel_screen.hpp"

#include <system_error>

namespace rift::studio {

AppContext app_context(int threads) {
  AppContext w;
  std::error_code none;
  w.presets = presets_folder();
  w.own_presets = own_presets_folder();
  w.program = std::filesystem::read_symlink("/proc/self/exe", none);
  w.cache = base::user_cache();
  w.build = build_info();
  w.threads = threads;
  w.plate_picture = plate_pictures(w.program.parent_path());
  return w;
}

ExitCode work_in_terminal(std::unique_ptr<Screen> first, const Session& session, const GraphicsWish& wish) {
  work_in_terminal(
      std::move(first), session.color(), [&] { return !session.goes_on(); }, {}, wish);
  return session.goes_on() ? ExitCode::done : session.stopped();
}

bool panel_there() { return Terminal::there(); }

std::optional<simulation::Recorded> run_in_panel(RunRequest request, bool color, const StopSignal& stop) {
  const GraphicsWish wish = graphics_wish(request.resume ? "rift resume" : "rift run", {});  // refused before anything starts
  AppContext context = app_context(request.threads);
  auto screen = std::make_unique<RunScreen>(context, std::move(request), true);
  const RunScreen& panel = *screen;
  const std::shared_ptr<LiveRun> run = screen->run();
  ProgressLine line(ProgressStyle::plain);
  const auto go_on_unseen = [&](bool gone) {
    if (gone) run->go_on_alone();
    line.show("run", panel.live().done, panel.live().state);
  };
  work_in_terminal(
      std::move(screen), color, [&] { return stop.received() != 0; }, go_on_unseen, wish);
  run->stop();
  return run->result();
}

}  // namespace rift::studio
