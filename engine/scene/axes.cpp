#include "engine/scene/axes.hpp"

#include "engine/scene/wording.hpp"

#include <fmt/format.h>

#include <array>
#include <cassert>
#include <vector>

namespace rift::scene {

namespace {

// Per lane is what changes neither the lattice nor the critical step.
constexpr std::array<Axis, 20> table{{
    {"technique", "crack.technique", true},
    {"relaxation", "crack.relaxation", true},
    {"damage_zone_ratio", "crack.damage_zone_ratio", true},
    {"damping_alpha", "damping.alpha", true},
    {"damping_region", "damping.region", true},
    {"crack_velocity", "crack.velocity", true},
    {"friction", "crack.friction", true},
    {"elements", "specimen.elements", false},
    {"layers", "specimen.layers", false},
    {"seed", "specimen.seed", false},
    {"stiffness", "material.stiffness", false},
    {"plane", "material.plane", false},
    {"dt_fraction", "solver.dt_fraction", false},
    {"beta", "solver.beta", false},
    {"precision", "solver.precision", false},
    {"kinematics", "solver.kinematics", false},
    {"length", "specimen.length", false},
    {"path", "crack.path", false},
    {"prestress_method", "loading.method", false},
    {"samples", "output.samples", false},
}};

std::vector<std::string> axis_names() {
  std::vector<std::string> names;
  names.reserve(table.size());
  for (const Axis& axis : table) names.emplace_back(axis.name);
  return names;
}

/// The axis that varies the key which is called so, with or without its table: "velocity" is crack_velocity.
std::string axis_of_key(const std::string& name) {
  for (const Axis& axis : table) {
    if (name == axis.key || name == name_of(parameter_of(axis))) return std::string(axis.name);
  }
  return {};
}

std::string without_quotes(const std::string& text) {
  return text.starts_with('"') ? text.substr(1, text.size() - 2) : text;
}

}  // namespace

std::span<const Axis> axes() { return table; }

const Axis* find_axis(std::string_view name) {
  for (const Axis& axis : table) {
    if (axis.name == name) return &axis;
  }
  return nullptr;
}

const Parameter& parameter_of(const Axis& axis) {
  const Parameter* row = find_parameter(axis.key);
  assert(row);
  return *row;
}

bool applies(const Scene& scene, const Axis& axis) {
  const bool of_zone = axis.key == "crack.relaxation" || axis.key == "crack.damage_zone_ratio";
  return !of_zone || scene.crack.technique == fracture::Technique::progressive;
}

std::string axis_text(const Scene& scene, const Axis& axis) {
  const std::string value = applies(scene, axis) ? toml_value(scene, parameter_of(axis)) : std::string{};
  return value.empty() ? "-" : without_quotes(value);
}

std::string unknown_axis(const std::string& name) {
  const std::vector<std::string> names = axis_names();
  std::string nearest = axis_of_key(name);
  if (nearest.empty()) nearest = nearest_name(name, names);
  if (!nearest.empty()) return fmt::format("unknown axis '{}', did you mean '{}'?", printable(name), nearest);
  return fmt::format("unknown axis '{}': the axes are {}", printable(name), listed(names, "and"));
}

std::string lane_axes() {
  std::vector<std::string> names;
  for (const Axis& axis : table) {
    if (axis.per_lane) names.emplace_back(axis.name);
  }
  return listed(names, "and");
}

}  // namespace rift::scene
