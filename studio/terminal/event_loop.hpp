#pragma once

#include "studio/terminal/pictures.hpp"
#include "studio/workbench/screen.hpp"

#include <functional>
#include <memory>

namespace rift::studio {

/// Called ten times a second while another job has the terminal, or when it is gone.
using Unseen = std::function<void(bool gone)>;

/// Shows a screen, and those that it leads to, in the terminal until the last one is left, or `stopped` says
/// so. Screens that are left clean up after themselves. While another job has the terminal the screens go on
/// without being drawn. @param unseen  where empty, a terminal that is gone ends the work
void work_in_terminal(std::unique_ptr<Screen> first, bool color, const std::function<bool()>& stopped,
                      const Unseen& unseen = {}, const GraphicsWish& wish = {});

}  // namespace rift::studio
