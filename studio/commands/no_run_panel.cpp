#include "studio/commands/run_panel.hpp"

// What a build without ncurses (-DRIFT_STUDIO_TUI=OFF) has in place of run_panel.cpp.
namespace rift::studio {

bool panel_there() { return false; }

std::optional<simulation::Recorded> run_in_panel(RunWish, bool, const StopSignal&) { return std::nullopt; }

}  // namespace rift::studio
