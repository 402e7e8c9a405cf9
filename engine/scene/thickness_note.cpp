#include "engine/scene/thickness_note.hpp"

#include "engine/scene/derived.hpp"
#include "engine/scene/issue.hpp"
#include "engine/scene/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace rift::scene {
namespace {

constexpr std::array keys_of_size{"specimen.elements", "specimen.length", "specimen.height"};

bool follows_from_layers(const Scene& scene) {
  return scene.specimen.shape == packing::Shape::plate && scene.specimen.layers && !scene.specimen.thickness;
}

bool differ(double a, double b) { return std::abs(a - b) > 1e-9 * std::abs(b); }

/// Whether the plate's elements go into this thickness.
bool can_have(Scene scene, double thickness) {
  scene.specimen.layers.reset();
  scene.specimen.thickness = thickness;
  return 2.0 * expected_mean_radius_m(scene) <= thickness;
}

std::string of_override(const Preset& preset, const Scene& own) {
  if (!follows_from_layers(preset.scene) || !follows_from_layers(own)) return {};
  const double before = thickness_m(own), now = thickness_m(preset.scene);
  if (!differ(now, before)) return {};
  std::vector<std::string> causes;
  for (const char* key : keys_of_size) {
    const auto origin = preset.origins.find(key);
    if (origin != preset.origins.end() && origin->second.file == "--set")
      causes.push_back(fmt::format("{} = {}", key, origin->second.value));
  }
  const std::string text =
      fmt::format("{} change{} the thickness from {} to {}, as layers = {:g} stays", listed(causes, "and"),
                  causes.size() == 1 ? "s" : "", in_mm(before), in_mm(now), *own.specimen.layers);
  return can_have(preset.scene, before)
             ? fmt::format("{}: --set specimen.thickness='{}' keeps it", text, in_mm(before))
             : text;
}

/// The thicknesses of a study's plates, where its axes other than `layers` make them differ.
std::string of_axes(const Preset& preset) {
  std::vector<std::string> names;
  if (preset.study.empty()) return {};
  for (const auto& [name, text] : preset.study.front().axes)
    if (name == "elements" || name == "length") names.push_back(name);
  std::vector<double> thickness;
  for (const StudyRow& row : preset.study) {
    if (!follows_from_layers(row.scene)) continue;
    const double one = thickness_m(row.scene);
    if (std::none_of(thickness.begin(), thickness.end(), [&](double other) { return !differ(one, other); }))
      thickness.push_back(one);
  }
  if (names.empty() || thickness.size() < 2) return {};
  std::sort(thickness.begin(), thickness.end());
  return fmt::format(
      "the study's {} change{} the thickness: {} to {}, as layers stays; specimen.thickness in place of "
      "layers keeps one",
      listed(names, "and"), names.size() == 1 && names.front() == "length" ? "s" : "",
      in_mm(thickness.front()), in_mm(thickness.back()));
}

}  // namespace

std::string note_on_thickness(const Preset& preset, const Scene& own) {
  const std::string set = of_override(preset, own), axes = of_axes(preset);
  return set.empty() || axes.empty() ? set + axes : set + "; " + axes;
}

}  // namespace rift::scene
