#pragma once

#include "engine/packing/packing.hpp"
#include "engine/scene/preset.hpp"

#include <string>

/// What a plate of few elements through its thickness is, before it is packed and where it cannot be.
namespace rift::scene {

/// Elements through the thickness of the specimen: the thickness over the expected mean diameter.
double elements_through(const Scene& scene);

/// Where the plate, or some plates of the study, have fewer than two layers of elements: one sentence with
/// the numbers, the scenarios and the coordination that such packings reach; empty where none has.
/// @param[in] preset  without issues
std::string note_on_layers(const Preset& preset);

/// The packing of the preset's scene could not be made, at the key that the user gave of those that decide
/// it: why, of which specimen, and what can be made instead.
Issue packing_issue(const Preset& preset, const packing::PackingError& error);

}  // namespace rift::scene
