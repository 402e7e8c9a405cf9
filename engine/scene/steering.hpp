#pragma once

#include "engine/scene/parameters.hpp"
#include "engine/scene/toml_text.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// Changes of a scenario while its crack runs, so that a run that was steered by hand can be repeated.
namespace rift::scene {

struct Preset;
struct Issue;

/// One change of one lane.
struct Change {
  int lane = 0;           // from 0
  std::int64_t step = 0;  // of the lane; made between this step and the next
  std::string axis;       // one of steerable_axes()
  std::string value;      // as --set would take it: "0.3 c_r", "quadratic", "0.05"
  bool operator==(const Change&) const = default;
};

/// What can be changed while a crack runs: technique, relaxation, damage_zone_ratio, damping_alpha,
/// crack_velocity.
std::span<const std::string_view> steerable_axes();

/// Makes the change in a lane's scene: a new velocity holds from `tip` on, damping without a region is of the
/// beams near the path.
/// @param[in] tip  where the lane's tip is [m]
/// @return what is wrong with the change (the scene is then as before), or empty
std::string steer(Scene& scene, const Change& change, double tip);

/// The changes of [[steering]] by lane and step, and what is wrong with them.
std::vector<Issue> take_steering(Preset& preset, const TomlDocument& document);

/// The changes as [[steering]] tables, which read_preset() takes back.
std::string steering_text(const std::vector<Change>& changes);

}  // namespace rift::scene
