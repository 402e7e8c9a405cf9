#include "engine/scene/axes.hpp"
#include "engine/scene/needs.hpp"
#include "engine/scene/parameters.hpp"
#include "engine/scene/preset.hpp"

#include <fmt/format.h>

namespace rift::scene {

namespace {

/// Rows of numbers one below the other where there are many: for the eye, and because a reader of presets
/// takes a line of very many dots for a hostile key.
std::string in_lines(std::string value) {
  constexpr std::size_t wide = 100;
  if (!value.starts_with("[[") || value.size() <= wide) return value;
  std::string out = "[\n  ";
  for (std::size_t from = 1;;) {
    const std::size_t next = value.find("], [", from);
    if (next == std::string::npos) return out + value.substr(from, value.size() - 1 - from) + ",\n]";
    out += value.substr(from, next + 1 - from) + ",\n  ";
    from = next + 3;
  }
}

/// One line per axis that the scene has a value for; what is left out is the base's when it is read.
std::string axis_lines(const Scene& scene, const std::vector<const Axis*>& varied) {
  std::string out;
  for (const Axis* axis : varied) {
    const std::string value = toml_value(scene, parameter_of(*axis));
    if (applies(scene, *axis) && !value.empty()) out += fmt::format("{} = {}\n", axis->name, in_lines(value));
  }
  return out;
}

/// The axes in which some lane differs from the base; never none, for a table without any is a mistake.
std::vector<const Axis*> varied_in_lanes(const Preset& preset) {
  std::vector<const Axis*> varied;
  for (const Axis& axis : axes()) {
    const Parameter& row = parameter_of(axis);
    const std::string base = toml_value(preset.scene, row);
    bool differs = false;
    for (const Scene& lane : preset.lanes) differs = differs || toml_value(lane, row) != base;
    if (differs) varied.push_back(&axis);
  }
  if (varied.empty()) varied.push_back(find_axis("technique"));
  return varied;
}

/// Whether another key that excludes it is given.
bool has_no_say(const Parameter& row, const Scene& scene) {
  const Scene::Loading& loading = scene.loading;
  if (row.key == "crack.velocity") return !scene.crack.history.empty();
  return row.key == "loading.displacement" && (loading.force || !loading.curve.row.empty());
}

}  // namespace

std::string preset_text(const Scene& scene) {
  std::string out = "# The effective preset; docs/parameters.md says more.\n";
  std::string table;
  for (const Parameter& row : parameters()) {
    if (table_of(row) == "calibration" && !needs_calibration(scene)) continue;
    if (table_of(row) != table) {
      table = table_of(row);
      out += fmt::format("\n[{}]\n", table);
    }
    const std::string value = has_no_say(row, scene) ? std::string{} : toml_value(scene, row);
    out += fmt::format("# {} Allowed: {}.\n", row.doc, allowed(row));
    out += value.empty() ? fmt::format("# {} is not given\n", name_of(row))
                         : fmt::format("{} = {}\n", name_of(row), in_lines(value));
  }
  return out;
}

std::string preset_text(const Preset& preset) {
  std::string out = preset_text(preset.scene);
  const std::vector<const Axis*> in_lanes = varied_in_lanes(preset);
  for (const Scene& lane : preset.lanes) out += "\n[[lanes]]\n" + axis_lines(lane, in_lanes);
  for (const StudyRow& row : preset.study) {
    std::vector<const Axis*> varied;
    for (const auto& [name, text] : row.axes) varied.push_back(find_axis(name));
    out += "\n[[study.rows]]\n" + axis_lines(row.scene, varied);
  }
  return out + steering_text(preset.steering);
}

}  // namespace rift::scene
