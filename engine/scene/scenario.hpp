#pragma once

#include "engine/scene/axes.hpp"
#include "engine/scene/preset.hpp"

#include <set>
#include <span>
#include <string>
#include <vector>

/// One scenario of a study, or one lane: the base scene with the values of some axes put in their place.
namespace rift::scene {

/// An axis at a value, and the line of the preset that says so.
struct Setting {
  const Axis* axis;
  Value value;
  int line = 0;
};

/// The scene of a preset that scenarios start from.
struct Base {
  const Preset& preset;
  const std::set<std::string>& unsound;  // its keys with an issue of their own
};

struct Scenario {
  Preset preset;  // scene and origins, those of the settings at their lines; issues: of the settings alone
  std::set<std::string> unsound;  // keys with an issue of their own
};

/// Who chose a combination of values. In a grid it is arithmetic, and what means nothing is taken out; in a
/// table of its own it is a wish, and two values that cannot both be meant stay for contradictions() to find.
enum class Chosen { by_grid, by_hand };

/// The base with `settings` assigned, then settled, so that what is physically one scenario is one scene:
/// a simple release has the base's relaxation and damage zone; no damped region has alpha 0; alpha 0 has no
/// region.
Scenario scenario_of(const Base& base, std::span<const Setting> settings, Chosen chosen);

/// Equal for two scenarios of one base exactly where their scenes are.
std::string fingerprint(const Scene& scene);

}  // namespace rift::scene
