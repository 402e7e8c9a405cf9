#pragma once

#include "studio/commands/session.hpp"

namespace rift::studio {

/// `rift calibrate --toughness`: the constant kappa of the cohesive law, in the plate of the preset or,
/// without one, of freund_wave. Says its cost before it begins.
ExitCode calibrate_toughness(const SceneOptions& options);

}  // namespace rift::studio
