#include "engine/scene/scenario.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace rift::scene {

namespace {

void put(Scenario& scenario, const Setting& setting) {
  const std::string key(setting.axis->key);
  scenario.preset.origins[key] = {scenario.preset.name, setting.line, shown(setting.value)};
  scenario.unsound.erase(key);  // of the base, whose value no longer counts
  std::string problem = assign(scenario.preset.scene, parameter_of(*setting.axis), setting.value);
  if (problem.empty()) return;
  scenario.unsound.insert(key);
  scenario.preset.issues.push_back(issue_at(scenario.preset, key, std::move(problem)));
}

void settle_damage_zone(Scene& scene, const Scene& base) {
  if (scene.crack.technique != fracture::Technique::simple) return;
  scene.crack.relaxation = base.crack.relaxation;
  scene.crack.damage_zone_ratio = base.crack.damage_zone_ratio;
}

/// Only what the scenario says itself takes damping out: an alpha on a base without a region stays a mistake.
void settle_damping(Scene& scene, bool alpha_given, bool region_given, Chosen chosen) {
  const bool grid = chosen == Chosen::by_grid;
  const bool nowhere = region_given && scene.damping.region == DampingRegion::none;
  const bool nothing = alpha_given && scene.damping.alpha == 0;
  if (nowhere && (grid || !alpha_given)) scene.damping.alpha = 0;
  if (nothing && (grid || !region_given)) scene.damping.region = DampingRegion::none;
}

}  // namespace

Scenario scenario_of(const Base& base, std::span<const Setting> settings, Chosen chosen) {
  Scenario scenario{
      {base.preset.scene, base.preset.origins, {}, base.preset.name, {}, {}, {}, base.preset.rows, {}},
      base.unsound};
  for (const Setting& setting : settings) put(scenario, setting);
  const auto given = [&](std::string_view key) {
    return std::any_of(settings.begin(), settings.end(),
                       [&](const Setting& s) { return s.axis->key == key; });
  };
  Scene& scene = scenario.preset.scene;
  settle_damage_zone(scene, base.preset.scene);
  settle_damping(scene, given("damping.alpha"), given("damping.region"), chosen);
  return scenario;
}

std::string fingerprint(const Scene& scene) {
  std::string out;
  for (const Axis& axis : axes()) out += toml_value(scene, parameter_of(axis)) + '\n';
  return out;
}

}  // namespace rift::scene
