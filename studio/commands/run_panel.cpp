#include "studio/commands/run_panel.hpp"

#include "studio/commands/workshop.hpp"
#include "studio/terminal/bench.hpp"
#include "studio/terminal/terminal.hpp"
#include "studio/workbench/panel_screen.hpp"

namespace rift::studio {

bool panel_there() { return Terminal::there(); }

std::optional<Recorded> run_in_panel(RunWish wish, bool color, const StopSignal& stop) {
  Workshop workshop = workshop_here(wish.threads);
  auto screen = std::make_unique<RunScreen>(workshop, std::move(wish), true);
  const std::shared_ptr<LiveRun> run = screen->run();
  work_in_terminal(std::move(screen), color, [&] { return stop.received() != 0; });
  run->stop();
  return run->result();
}

}  // namespace rift::studio
