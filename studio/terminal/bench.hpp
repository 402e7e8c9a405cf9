#pragma once

#include "studio/workbench/screen.hpp"

#include <functional>
#include <memory>

namespace rift::studio {

/// Shows a screen, and those that it leads to, in the terminal until the last one is left, or `stopped` says
/// so. Screens that are left clean up after themselves.
void work_in_terminal(std::unique_ptr<Screen> first, bool color, const std::function<bool()>& stopped);

}  // namespace rift::studio
