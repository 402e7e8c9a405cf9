#pragma once

#include "engine/scene/preset.hpp"

#include <string>
#include <vector>

namespace rift::scene {

/// What is worth a look in rows without a defect, a line each: frames that a camera seems to have missed,
/// with their times, and a crack path that crosses itself.
std::vector<std::string> notes_on_rows(const Preset& preset);

}  // namespace rift::scene
