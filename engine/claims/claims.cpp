#include "engine/claims/claims.hpp"

#include "engine/claims/lattice_efficiency.hpp"
#include "engine/scene/derived.hpp"
#include "engine/scene/values_text.hpp"
#include "engine/study/plan.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace rift::claims {
namespace {

std::vector<Claim> all_claims() {
  std::vector<Claim> all = claims_of_figures();
  for (const auto part : {claims_of_sections, beyond_the_paper})
    for (Claim& claim : part()) all.push_back(std::move(claim));
  return all;
}

}  // namespace

const std::vector<Claim>& claims() {
  static const std::vector<Claim> table = all_claims();
  return table;
}

const Claim* find_claim(std::string_view name) {
  const auto found =
      std::find_if(claims().begin(), claims().end(), [&](const Claim& c) { return c.name == name; });
  return found == claims().end() ? nullptr : &*found;
}

std::vector<SummaryRow> rows_in(const Evidence& evidence, Selection selection) {
  if (selection.elements == 0) selection.elements = evidence.elements;
  std::vector<SummaryRow> rows;
  std::copy_if(evidence.rows.begin(), evidence.rows.end(), std::back_inserter(rows),
               [&](const SummaryRow& row) { return selects(selection, row); });
  return rows;
}

Curve curve_in(const Evidence& evidence, Selection selection) {
  if (selection.elements == 0) selection.elements = evidence.elements;
  return curve_of(evidence.rows, selection);
}

Curve curve_of_elements(const Evidence& evidence, double factor) {
  Selection selection;
  selection.elements = static_cast<int>(std::lround(factor * evidence.elements));
  return curve_of(evidence.rows, selection);
}
namespace {

constexpr int coarser = 4;  // fewer elements in quick; the step of a scene that gives one grows as much
constexpr int most_quick_elements = 10000;
constexpr double slowest = 0.011;  // [c_r]

/// The scenes that a preset asks for.
std::vector<scene::Scene> scenes_of(const scene::Preset& preset) {
  std::vector<scene::Scene> scenes;
  for (const scene::StudyRow& row : preset.study) scenes.push_back(row.scene);
  if (!scenes.empty()) return scenes;
  for (const scene::StiffnessChoice stiffness :
       {scene::StiffnessChoice::bulk, scene::StiffnessChoice::in_situ}) {
    scenes.push_back(preset.scene);
    scenes.back().material.stiffness = stiffness;
    scenes.back().output.frames = 0;
  }
  return scenes;
}

/// The scene as --quick computes it; nothing where it leaves it out.
std::optional<scene::Scene> quick_scene(scene::Scene scene) {
  scene.specimen.elements /= coarser;
  if (scene.specimen.elements > most_quick_elements) return std::nullopt;
  if (scene::highest_velocity(scene) < slowest && scene.specimen.seed != 1) return std::nullopt;
  if (scene.solver.dt) {
    *scene.solver.dt *= coarser;
    scene.loading.ramp_steps /= coarser;
    scene.loading.hold_steps /= coarser;
  }
  return scene;
}

}  // namespace

int plate_elements(Effort effort) {
  return effort == Effort::quick ? paper_elements / coarser : paper_elements;
}

PaperStudy merge_presets(const std::vector<std::pair<std::string, scene::Preset>>& presets, Effort effort) {
  PaperStudy merged;
  if (!presets.empty()) merged.preset.scene = presets.front().second.scene;
  merged.preset.name = "reproduction";
  std::map<std::string, int> row_of_scene;  // by the scene as text
  for (const auto& [name, preset] : presets) {
    std::vector<int>& rows = merged.of[name];
    for (const scene::Scene& scene : scenes_of(preset)) {
      const std::optional<scene::Scene> wanted =
          effort == Effort::quick ? quick_scene(scene) : std::optional<scene::Scene>(scene);
      if (!wanted) continue;
      const auto [known, fresh] =
          row_of_scene.emplace(scene::values_text(*wanted), static_cast<int>(merged.preset.study.size()));
      if (fresh) merged.preset.study.push_back(study::study_row_of(*wanted));
      if (std::find(rows.begin(), rows.end(), known->second) == rows.end()) rows.push_back(known->second);
    }
  }
  return merged;
}

}  // namespace rift::claims
