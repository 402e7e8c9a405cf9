#pragma once

#include "engine/scene/preset.hpp"
#include "engine/scene/toml_text.hpp"

#include <set>
#include <string>
#include <vector>

namespace rift::scene {

/// Most scenarios that one preset may ask for.
inline constexpr int most_scenarios = 10000;

/// Makes the scenarios of [study] or [[lanes]] from the preset's scene, whose keys in `unsound` have an issue
/// already, and checks each of them for contradictions. Without any, the scene itself is checked; with some,
/// it is only what they start from, and may want what they bring (a damped region its alpha).
/// @return what is wrong, each mistake once
std::vector<Issue> take_scenarios(Preset& preset, const TomlDocument& document,
                                  const std::set<std::string>& unsound);

}  // namespace rift::scene
