#pragma once

#include "studio/commands/session.hpp"

#include <string>

namespace rift::studio {

/// Where `rift accuracy PRESET` works by default: NAME_accuracy.
std::filesystem::path accuracy_folder(const std::string& preset);

/// By what a folder of `rift accuracy` is known.
nlohmann::ordered_json accuracy_mark(const scene::Preset& preset);

/// What the time step itself is known to add to G_ID/G_I0: as a former `rift accuracy` of this very scene has
/// measured it in its folder, else the command that does. Empty of lanes and of what has no ratio.
std::string step_error_text(const SceneOptions& options, const scene::Preset& preset);

}  // namespace rift::studio
