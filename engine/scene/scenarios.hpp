#pragma once

#include "engine/scene/parameters.hpp"
#include "engine/scene/preset.hpp"
#include "engine/scene/toml_text.hpp"

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rift::scene {

/// A parameter that studies and lanes vary, under the one name which [study], rows, lanes, tables and
/// summaries share.
struct Axis {
  std::string_view name;  // "crack_velocity"
  std::string_view key;   // "crack.velocity", its row of the parameter table
  bool per_lane;          // the lanes of one ensemble, which share a lattice and a step, may differ in it
};

/// THE table of the axes, in the order in which they are listed to the user.
std::span<const Axis> axes();

/// The axis of a name, or null.
const Axis* find_axis(std::string_view name);

/// The row of the parameter table that the axis varies.
const Parameter& parameter_of(const Axis& axis);

/// True where the axis means anything in this scene: a simple release has no damage zone, thus no relaxation
/// either.
bool applies(const Scene& scene, const Axis& axis);

/// The scene's value as tables and charts show it: "0.5 c_r", "linear", "3"; "-" where the axis does not
/// apply or the scene gives it no value (layers beside a thickness).
std::string axis_text(const Scene& scene, const Axis& axis);

/// "unknown axis 'damge_zone_ratio', did you mean 'damage_zone_ratio'?"
std::string unknown_axis(const std::string& name);

/// What makes the axis count for nothing where it is said of a scenario: "technique = \"simple\"".
std::string_view settled_by(const Axis& axis);

/// "technique, relaxation, ... and crack_velocity": those in which lanes may differ.
std::string lane_axes();

/// Most scenarios that one preset may ask for.
inline constexpr int most_scenarios = 10000;

/// Makes the scenarios of [study] or [[lanes]] from the preset's scene, whose keys in `invalid` have an issue
/// already, and checks each of them for contradictions. Without any, the scene itself is checked; with some,
/// it is only what they start from, and may want what they bring (a damped region its alpha).
/// @return what is wrong, each mistake once
std::vector<Issue> take_scenarios(Preset& preset, const TomlDocument& document,
                                  const std::set<std::string>& invalid);

}  // namespace rift::scene
