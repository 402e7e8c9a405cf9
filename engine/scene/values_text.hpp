#pragma once

#include "engine/scene/parameters.hpp"

#include <string>

/// What a scene is compared by.
namespace rift::scene {

/// The value of a parameter as preset_text() gives it: empty where it is absent, or where another key that
/// excludes it is given.
std::string value_that_counts(const Scene& scene, const Parameter& row);

/// Whether a scene uses the parameter at all: [calibration] counts only where one is needed.
bool is_used(const Scene& scene, const Parameter& row);

/// "key = value" for each parameter that counts in the scene, a line each in the table's order, without those
/// that `wanted` refuses. Two scenes are the same scenario where these texts are equal; no doc stands in
/// them, so that other words for a key change no result's name.
std::string values_text(
    const Scene& scene, bool (*wanted)(const Parameter&) = [](const Parameter&) { return true; });

}  // namespace rift::scene
