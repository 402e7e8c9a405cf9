#pragma once

#include "studio/commands/session.hpp"
#include "studio/terminal/pictures.hpp"
#include "studio/workbench/live_run.hpp"
#include "studio/workbench/screen.hpp"

#include <optional>

namespace rift::studio {

/// What the workbench's screens share, for whoever works in this folder.
AppContext app_context(int threads);

/// Shows a screen, and those that it leads to, until the last one is left or the session is stopped.
ExitCode work_in_terminal(std::unique_ptr<Screen> first, const Session& session,
                          const GraphicsWish& wish = {});

/// Whether there is a terminal for a live panel, and this build has one.
bool panel_there();

/// Runs in the live panel, which goes when the run has ended. While another job has the terminal, or when it
/// is gone, lines of progress stand for the panel. @return nothing where it was stopped before its first
/// step. Throws what the run threw.
std::optional<simulation::Recorded> run_in_panel(RunRequest request, bool color, const StopSignal& stop);

}  // namespace rift::studio
