#include "engine/scene/needs.hpp"

#include "engine/scene/derived.hpp"
#include "engine/scene/issue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace rift::scene {

Needs needs_of(const Scene& scene) {
  Needs needs;
  needs.damping = scene.damping.alpha > 0 && scene.damping.region != DampingRegion::none;
  needs.numerical_damping = scene.solver.beta < 1;
  needs.damage_zone = scene.crack.technique == fracture::Technique::progressive;
  needs.ramp = scene.loading.method == LoadingMethod::ramp;
  needs.moving_grip = grip_moves(scene);
  needs.corotation = scene.solver.kinematics == lattice::Kinematics::corotational;
  needs.contact = scene.crack.friction.has_value();
  needs.step_energies =
      needs.damping || needs.numerical_damping || needs.ramp || needs.moving_grip || needs.contact;
  needs.frames = scene.output.frames > 0 && !scene.output.fields.empty();
  needs.gauges = !scene.output.gauges.empty();
  return needs;
}

bool needs_calibration(const Scene& scene) {
  return scene.specimen.shape == packing::Shape::cylinder ||
         scene.material.stiffness == StiffnessChoice::calibrated;
}

namespace {

constexpr double unmeasured = std::numeric_limits<double>::quiet_NaN();

constexpr std::array<OptionalPart, 10> part_table{{{"damping", {1.0, 2.7}},
                                                   {"numerical_damping", {1.0, 1.7}},
                                                   {"damage_zone", {unmeasured, unmeasured}},
                                                   {"ramp", {unmeasured, unmeasured}},
                                                   {"moving_grip", {unmeasured, unmeasured}},
                                                   {"corotation", {1.7, 3.4}},
                                                   {"contact", {unmeasured, unmeasured}},
                                                   {"step_energies", {unmeasured, unmeasured}},
                                                   {"frames", {unmeasured, unmeasured}},
                                                   {"gauges", {unmeasured, unmeasured}}}};

/// How a part is decided and spoken of.
struct Decision {
  bool (*needed)(const Needs&);
  std::string (*why)(const Scene&);  // it is left out
  const char* shared = "";           // what the step of lanes does of which only some need it
};

/// In the order of the parts.
const std::array<Decision, part_table.size()> decisions{{
    {[](const Needs& n) { return n.damping; },
     [](const Scene& scene) -> std::string {
       return scene.damping.alpha == 0 ? "alpha = 0, no damped beams are built"
                                       : "region = none, no damped beams are built";
     },
     "the lanes share a step, which evaluates the damped beams for all of them"},
    {[](const Needs& n) { return n.numerical_damping; },
     [](const Scene&) -> std::string { return "beta = 1"; }},
    {[](const Needs& n) { return n.damage_zone; },
     [](const Scene&) -> std::string { return "technique = simple"; },
     "each lane has a release law of its own, and nothing is computed for the others"},
    {[](const Needs& n) { return n.ramp; },
     [](const Scene&) -> std::string { return "method = static, the pre-stress is one solve"; }},
    {[](const Needs& n) { return n.moving_grip || n.ramp; },
     [](const Scene&) -> std::string {
       return "no loading.curve, the grips stand still while the crack runs";
     }},
    {[](const Needs& n) { return n.corotation; },
     [](const Scene&) -> std::string { return "kinematics = linear, the beam axes stay fixed"; }},
    {[](const Needs& n) { return n.contact; },
     [](const Scene&) -> std::string { return "no friction, the crack's faces do not touch"; },
     "the lanes share a step, which evaluates the faces of all of them"},
    {[](const Needs& n) { return n.step_energies; },
     [](const Scene&) -> std::string {
       return "no dissipation and no external work, energies are computed at samples only";
     },
     "the lanes share a step, which adds up the energies of all of them"},
    {[](const Needs& n) { return n.frames; },
     [](const Scene& scene) -> std::string {
       return scene.output.frames == 0 ? "frames = 0, no fields are written"
                                       : "fields = [], no fields are written";
     }},
    {[](const Needs& n) { return n.gauges; },
     [](const Scene&) -> std::string { return "output.gauges has no points"; }},
}};

/// Which of the scenes leave a part out, and their reasons, each once.
struct WithoutPart {
  std::vector<std::size_t> without, with;
  std::string why;
};

WithoutPart without_part(std::span<const Scene> scenes, const Decision& part) {
  WithoutPart found;
  std::vector<std::string> reasons;
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    const bool needed = part.needed(needs_of(scenes[k]));
    (needed ? found.with : found.without).push_back(k);
    if (needed) continue;
    std::string why = part.why(scenes[k]);
    if (std::find(reasons.begin(), reasons.end(), why) == reasons.end()) reasons.push_back(std::move(why));
  }
  found.why = fmt::format("{}", fmt::join(reasons, "; "));
  return found;
}

/// "lane 0", "lanes 1 and 2".
std::string lanes_text(const std::vector<std::size_t>& lanes) {
  std::vector<std::string> numbers;
  for (const std::size_t lane : lanes) numbers.push_back(std::to_string(lane));
  return (lanes.size() == 1 ? "lane " : "lanes ") + listed(numbers, "and");
}

std::string in_words(std::string_view name) {
  std::string words(name);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

/// A line for each part that some of the scenes leave out; `partly` words one that others need.
template <class Partly>
std::vector<std::string> lines_of(std::span<const Scene> scenes, const Partly& partly) {
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < part_table.size(); ++k) {
    const WithoutPart found = without_part(scenes, decisions[k]);
    if (found.without.empty()) continue;
    lines.push_back(in_words(part_table[k].name) + ": " +
                    (found.with.empty() ? found.why : partly(found, decisions[k])));
  }
  return lines;
}

}  // namespace

std::span<const OptionalPart> optional_parts() { return part_table; }

const OptionalPart* find_optional_part(std::string_view name) {
  const auto* found = std::find_if(part_table.begin(), part_table.end(),
                                   [&](const OptionalPart& part) { return part.name == name; });
  return found == part_table.end() ? nullptr : found;
}

std::vector<std::string> left_out(const Scene& scene) {
  const Needs needs = needs_of(scene);
  std::vector<std::string> names;
  for (std::size_t k = 0; k < part_table.size(); ++k)
    if (!decisions[k].needed(needs)) names.emplace_back(part_table[k].name);
  return names;
}

std::vector<std::string> left_out_by_lanes(std::span<const Scene> lanes) {
  return lines_of(lanes, [](const WithoutPart& found, const Decision& part) {
    return fmt::format("{} ({}); {} need{} it: {}", lanes_text(found.without), found.why,
                       lanes_text(found.with), found.with.size() == 1 ? "s" : "", part.shared);
  });
}

std::vector<std::string> left_out_by_scenarios(std::span<const Scene> scenarios) {
  return lines_of(scenarios, [&](const WithoutPart& found, const Decision&) {
    return fmt::format("{} of {} scenarios ({})", found.without.size(), scenarios.size(), found.why);
  });
}

std::vector<std::string> left_out_lines(const Preset& preset) {
  if (preset.study.empty())
    return left_out_by_lanes(preset.lanes.empty() ? std::span(&preset.scene, 1) : std::span(preset.lanes));
  std::vector<Scene> scenarios;
  for (const StudyRow& row : preset.study) scenarios.push_back(row.scene);
  return left_out_by_scenarios(scenarios);
}

}  // namespace rift::scene
