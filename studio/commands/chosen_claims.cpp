#include "studio/commands/chosen_claims.hpp"

#include "engine/scene/issue.hpp"
#include "studio/commands/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace rift::studio {
namespace {

std::vector<std::string> known_names() {
  std::vector<std::string> known{"all", "beyond", "readings"};
  for (const claims::Claim& claim : claims::claims()) known.push_back(claim.name);
  return known;
}

}  // namespace

bool is_claim_name(const std::string& name) {
  const std::vector<std::string> known = known_names();
  return name != "readings" && std::find(known.begin(), known.end(), name) != known.end();
}

std::vector<const claims::Claim*> chosen_claims(const std::vector<std::string>& names) {
  std::set<std::string> wanted(names.begin(), names.end());
  const std::vector<std::string> known = known_names();
  std::vector<scene::Issue> issues;
  for (const std::string& name : wanted) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::string nearest = scene::nearest_name(name, known);
    issues.push_back({.file = "rift reproduce",
                      .key = {},
                      .text = nearest.empty()
                                  ? fmt::format("unknown name '{}': the names are {}", scene::printable(name),
                                                scene::listed(known, "and"))
                                  : fmt::format("unknown name '{}', did you mean '{}'?",
                                                scene::printable(name), nearest)});
  }
  if (!issues.empty()) throw scene::InputError(issues);
  std::vector<const claims::Claim*> chosen;
  if (wanted.empty()) wanted.insert("all");
  for (const claims::Claim& claim : claims::claims())
    if (wanted.contains(claim.beyond ? "beyond" : "all") || wanted.contains(claim.name))
      chosen.push_back(&claim);
  return chosen;
}

claims::PaperStudy paper_study(const std::vector<const claims::Claim*>& chosen, claims::Effort effort) {
  std::vector<std::string> names;
  for (const claims::Claim* claim : chosen)
    for (const std::string& name : claim->needs)
      if (claim->judge && !claim->calibration && std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
  std::vector<std::pair<std::string, scene::Preset>> presets;
  std::vector<scene::Issue> issues;
  for (const std::string& name : names) {
    presets.emplace_back(name, scene::read_preset(resolve_preset(name)));
    const std::vector<scene::Issue>& found = presets.back().second.issues;
    issues.insert(issues.end(), found.begin(), found.end());
  }
  if (!issues.empty()) throw scene::InputError(issues);
  return claims::merge_presets(presets, effort);
}

scene::Scene calibration_scene(const claims::Claim& claim, claims::Effort effort) {
  scene::Scene scene = without_mistakes(scene::read_preset(resolve_preset(claim.needs.front()))).scene;
  if (effort == claims::Effort::full) return scene;
  scene::Scene::Calibration& c = scene.calibration;
  const double most = claims::plate_elements(effort);
  std::erase_if(c.sizes, [&](double elements) { return elements > most; });
  if (c.sizes.empty()) c.sizes = {most};
  c.elements = std::min(c.elements, static_cast<int>(most) / 2);
  c.packings = std::min(c.packings, 2);
  return scene;
}

}  // namespace rift::studio
