#pragma once

#include "engine/scene/preset.hpp"

#include <string>

namespace rift::scene {

/// A plate of `layers` has a thickness that follows from its elements, length and height. Where --set or an
/// axis of the study changes it, one sentence says so with the thicknesses; empty where nothing does.
/// @param[in] preset  without issues;  @param[in] own  its scene with its own elements, length and height
std::string note_on_thickness(const Preset& preset, const Scene& own);

}  // namespace rift::scene
