#pragma once

#include "studio/workbench/screen.hpp"

namespace rift::studio {

/// What the workbench's screens share, for whoever works in this folder.
Workshop workshop_here(int threads);

}  // namespace rift::studio
