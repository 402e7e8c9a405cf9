#pragma once

#include "engine/scene/preset.hpp"

#include <set>
#include <string>
#include <vector>

namespace rift::scene {

/// Mistakes that show only when parameters are seen together: contradictions, an order along the crack's way,
/// sizes that do not fit. A check that would rest on a key of `unsound` (already reported) is left out.
std::vector<Issue> contradictions(const Preset& preset, const std::set<std::string>& unsound);

/// The keys which say otherwise what `key` says, so that a preset has one of them: layers for thickness. The
/// start of the crack is among those of a measured history, whose first row it is.
std::vector<std::string> rivals_of(const std::string& key);

}  // namespace rift::scene
