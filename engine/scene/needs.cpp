#include "engine/scene/needs.hpp"

#include "engine/scene/derived.hpp"
#include "engine/scene/issue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace rift::scene {

Needs needs_of(const Scene& scene) {
  Needs needs;
  needs.damping = scene.damping.alpha > 0 && scene.damping.region != DampingRegion::none;
  needs.numerical_damping = scene.solver.beta < 1;
  needs.damage_zone = scene.crack.technique == fracture::Technique::progressive && !breaks_freely(scene);
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

/// Keys that only some scenes use, and which.
struct Use {
  bool (*by)(const Scene&);
  std::vector<std::string_view> keys;
};

const std::vector<Use>& conditional_uses() {
  static const std::vector<Use> uses{
      {[](const Scene& s) { return s.crack.history.empty() && !breaks_freely(s); }, {"crack.velocity"}},
      {[](const Scene& s) { return !breaks_freely(s); },
       {"crack.end", "crack.tips", "crack.technique", "crack.release_order", "crack.toughness",
        "crack.history"}},
      {[](const Scene& s) { return breaks_freely(s); },
       {"fracture.release_rate", "fracture.kappa", "fracture.duration"}},
      {[](const Scene& s) { return s.breaking.law == fracture::FractureLaw::cohesive; },
       {"fracture.strength"}},
      {[](const Scene& s) { return s.loading.traction.has_value(); },
       {"loading.rise_time", "loading.rollers"}},
      {[](const Scene& s) { return !s.loading.traction; }, {"loading.grip_rotation"}},
      {[](const Scene& s) { return !s.crack.history.empty(); }, {"crack.smoothing", "crack.history_gap"}},
      {[](const Scene& s) { return !s.crack.history.empty() || !s.crack.toughness.row.empty(); },
       {"crack.toughness_window"}},
      {[](const Scene& s) { return !s.crack.path.point.empty(); }, {"crack.path_shape"}},
      {[](const Scene& s) { return needs_of(s).damage_zone; },
       {"crack.relaxation", "crack.damage_zone_ratio"}},
      {[](const Scene& s) { return needs_of(s).damping; }, {"damping.alpha", "damping.region"}},
      {[](const Scene& s) { return needs_of(s).damping && s.damping.region == DampingRegion::surface; },
       {"damping.surface_width"}},
      {[](const Scene& s) { return needs_of(s).ramp; },
       {"loading.ramp_steps", "loading.hold_steps", "loading.ramp_beta"}},
      {[](const Scene& s) { return !s.loading.force && s.loading.curve.row.empty() && !s.loading.traction; },
       {"loading.displacement"}},
      {[](const Scene& s) { return !s.specimen.solid_fraction; }, {"specimen.coordination"}},
      {[](const Scene& s) { return s.output.frames > 0; }, {"output.fields"}},
      {[](const Scene& s) { return needs_of(s).gauges; }, {"output.gauge_length"}}};
  return uses;
}

}  // namespace

bool is_used(const Scene& scene, std::string_view key) {
  const std::vector<Use>& uses = conditional_uses();
  return std::none_of(uses.begin(), uses.end(), [&](const Use& use) {
    return std::find(use.keys.begin(), use.keys.end(), key) != use.keys.end() && !use.by(scene);
  });
}

namespace {

constexpr std::array<double, 2> unmeasured{std::numeric_limits<double>::quiet_NaN(),
                                           std::numeric_limits<double>::quiet_NaN()};

/// A part, how it is decided and how it is described.
struct Decision {
  OptionalPart part;
  bool (*needed)(const Needs&);
  std::string (*why)(const Scene&);  // it is left out
  const char* shared = "";           // what the step of lanes does of which only some need it
};

const std::array<Decision, 10> decisions{{
    {{"damping", {1.1, 2.4}},
     [](const Needs& n) { return n.damping; },
     [](const Scene& scene) {
       return fmt::format("{} = {}, no damped beams are built", scene.damping.alpha == 0 ? "alpha" : "region",
                          scene.damping.alpha == 0 ? "0" : "none");
     },
     "the lanes share a step, which evaluates the damped beams for all of them"},
    {{"numerical_damping", {1.4, 1.5}},
     [](const Needs& n) { return n.numerical_damping; },
     [](const Scene&) { return std::string("beta = 1"); }},
    {{"damage_zone", unmeasured},
     [](const Needs& n) { return n.damage_zone; },
     [](const Scene& scene) {
       return breaks_freely(scene) ? std::string("no crack is moved along a path")
                                   : std::string("technique = simple");
     },
     "each lane has a release law of its own, and nothing is computed for the others"},
    {{"ramp", unmeasured},
     [](const Needs& n) { return n.ramp; },
     [](const Scene&) { return std::string("method = static, the pre-stress is one solve"); }},
    {{"moving_grip", unmeasured},
     [](const Needs& n) { return n.moving_grip || n.ramp; },
     [](const Scene&) {
       return std::string("no loading.curve, the grips stand still while the crack runs");
     }},
    {{"corotation", {4.8, 7.0}},
     [](const Needs& n) { return n.corotation; },
     [](const Scene&) { return std::string("kinematics = linear, the beam axes stay fixed"); }},
    {{"contact", unmeasured},
     [](const Needs& n) { return n.contact; },
     [](const Scene&) { return std::string("no friction, the crack's faces do not touch"); },
     "the lanes share a step, which evaluates the faces of all of them"},
    {{"step_energies", unmeasured},
     [](const Needs& n) { return n.step_energies; },
     [](const Scene& scene) {
       return fmt::format("no dissipation{}, energies are computed at samples only",
                          scene.loading.traction ? ", the work of the traction is summed on its elements"
                                                 : " and no external work");
     },
     "the lanes share a step, which adds up the energies of all of them"},
    {{"frames", unmeasured},
     [](const Needs& n) { return n.frames; },
     [](const Scene& scene) {
       return fmt::format("{}, no fields are written",
                          scene.output.frames == 0 ? "frames = 0" : "fields = []");
     }},
    {{"gauges", unmeasured},
     [](const Needs& n) { return n.gauges; },
     [](const Scene&) { return std::string("output.gauges has no points"); }},
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
  for (const Decision& decision : decisions) {
    const WithoutPart found = without_part(scenes, decision);
    if (found.without.empty()) continue;
    lines.push_back(in_words(decision.part.name) + ": " +
                    (found.with.empty() ? found.why : partly(found, decision)));
  }
  return lines;
}

}  // namespace

std::vector<OptionalPart> optional_parts() {
  std::vector<OptionalPart> parts;
  for (const Decision& decision : decisions) parts.push_back(decision.part);
  return parts;
}

const OptionalPart* find_optional_part(std::string_view name) {
  const auto* found = std::find_if(decisions.begin(), decisions.end(),
                                   [&](const Decision& decision) { return decision.part.name == name; });
  return found == decisions.end() ? nullptr : &found->part;
}

std::vector<std::string> left_out(const Scene& scene) {
  const Needs needs = needs_of(scene);
  std::vector<std::string> names;
  for (const Decision& decision : decisions)
    if (!decision.needed(needs)) names.emplace_back(decision.part.name);
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
