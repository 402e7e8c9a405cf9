#include "engine/scene/layers_note.hpp"

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

constexpr double few = 2.0;  // layers of elements

/// The coordination at a mean overlap of 4 % of plates of so many layers   [rift pack, 1,500 elements, radius
/// spread 0.125, two seeds, which differ by 0.03].
struct Reach {
  double layers, coordination;
};
constexpr std::array reach_table{Reach{1.0, 4.9}, Reach{1.3, 5.2}, Reach{1.6, 6.2}, Reach{1.8, 6.3},
                                 Reach{2.0, 6.1}};

/// That of the table's plate which is next to it.
double reach_of(double layers) {
  return std::min_element(reach_table.begin(), reach_table.end(),
                          [&](const Reach& a, const Reach& b) {
                            return std::abs(a.layers - layers) < std::abs(b.layers - layers);
                          })
      ->coordination;
}

/// "1.33 layers of elements (1.04 mm thick, elements 0.78 mm across on average)"
std::string layers_text(const Scene& scene) {
  return fmt::format("{:.3g} layers of elements ({} thick, elements {} across on average)",
                     elements_through(scene), in_mm(box_of(scene).thickness),
                     in_mm(2.0 * expected_mean_radius_m(scene)));
}

bool is_thin(const Scene& scene) { return can_crack(scene) && elements_through(scene) < few; }

/// What a packing of so few layers reaches, where that is less than is asked for.
std::string reach_text(const Scene& scene) {
  const double reached = reach_of(elements_through(scene));
  if (scene.specimen.solid_fraction || reached >= scene.specimen.coordination) return {};
  return fmt::format(
      ", and its packing can hardly be made: such plates reach a coordination of about {:g}, {:g} is asked "
      "for",
      reached, scene.specimen.coordination);
}

/// The values of the axes that decide on the layers, of the scenarios that are thin: "layers 1 and 1.3".
std::string values_text(const std::vector<const StudyRow*>& thin) {
  std::vector<std::string> parts;
  for (std::size_t k = 0; k < thin.front()->axes.size(); ++k) {
    const std::string& name = thin.front()->axes[k].first;
    if (name != "layers" && name != "elements" && name != "length") continue;
    std::vector<std::string> values;
    for (const StudyRow* row : thin)
      if (std::find(values.begin(), values.end(), row->axes[k].second) == values.end())
        values.push_back(row->axes[k].second);
    parts.push_back(name + " " + listed(values, "and"));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string of_study(const Preset& preset) {
  std::vector<const StudyRow*> thin;
  for (const StudyRow& row : preset.study)
    if (is_thin(row.scene)) thin.push_back(&row);
  if (thin.empty()) return {};
  const StudyRow& thinnest = **std::min_element(thin.begin(), thin.end(), [](const auto* a, const auto* b) {
    return elements_through(a->scene) < elements_through(b->scene);
  });
  const std::string values = values_text(thin);
  return fmt::format(
      "{} of {} scenarios have fewer than two layers of elements{}: the thinnest plate has {}{}", thin.size(),
      preset.study.size(), values.empty() ? "" : fmt::format(" ({})", values), layers_text(thinnest.scene),
      reach_text(thinnest.scene));
}

/// The key of those that decide on a packing which the user gave.
const char* key_of_packing(const Preset& preset) {
  if (preset.scene.specimen.solid_fraction) return "specimen.solid_fraction";
  for (const char* key :
       {"specimen.coordination", "specimen.layers", "specimen.thickness", "specimen.radius_spread"})
    if (preset.origins.contains(key)) return key;
  return "specimen.coordination";
}

}  // namespace

double elements_through(const Scene& scene) {
  return box_of(scene).thickness / (2.0 * expected_mean_radius_m(scene));
}

std::string note_on_layers(const Preset& preset) {
  if (!preset.study.empty()) return of_study(preset);
  if (!is_thin(preset.scene)) return {};
  return fmt::format("the plate has {}: fewer than two, so that nearly every element lies at a face{}",
                     layers_text(preset.scene), reach_text(preset.scene));
}

Issue packing_issue(const Preset& preset, const packing::PackingError& error) {
  constexpr double tenths = 10.0;
  std::string text = error.what();
  if (error.nearest) {
    const bool pressed = *error.nearest < preset.scene.specimen.coordination;
    if (box_of(preset.scene).is_cuboid())
      text += fmt::format("; the specimen has {}", layers_text(preset.scene));
    text += pressed ? fmt::format(": specimen.coordination = {:.1f} or less is within reach",
                                  std::floor(tenths * *error.nearest) / tenths)
                    : fmt::format(": specimen.coordination = {:.1f} or more is within reach",
                                  std::ceil(tenths * *error.nearest) / tenths);
    const double asked = preset.scene.specimen.coordination;
    if (pressed && is_thin(preset.scene) && asked <= reach_table.back().coordination)
      text += fmt::format(", and so is {:g} from two layers on", asked);
  }
  return issue_at(preset, key_of_packing(preset), text);
}

}  // namespace rift::scene
