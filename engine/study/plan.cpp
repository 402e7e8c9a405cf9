#include "engine/study/plan.hpp"

#include "engine/scene/axes.hpp"
#include "engine/scene/parameters.hpp"
#include "engine/study/cost.hpp"
#include "engine/study/identity.hpp"
#include "engine/study/passes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace rift::study {
namespace {

bool may_differ_in_lanes(const scene::Parameter& row) {
  const auto table = scene::axes();
  return std::any_of(table.begin(), table.end(),
                     [&](const scene::Axis& axis) { return axis.per_lane && axis.key == row.key; });
}

/// Equal for scenes that differ at most in what lanes may differ in, or by being in-situ and bulk: time and
/// energy tell these apart, on one lattice.
std::string shared_text(scene::Scene scene) {
  if (scene.material.stiffness == scene::StiffnessChoice::bulk)
    scene.material.stiffness = scene::StiffnessChoice::in_situ;
  std::string text;
  for (const scene::Parameter& row : scene::parameters())
    if (!may_differ_in_lanes(row))
      text += std::string(row.key) + " = " + scene::toml_value(scene, row) + "\n";
  return text;
}

/// Scenarios of a group, of about equal step and damped or not, march in one pass: each costs its steps'
/// share.
void share_costs(std::vector<StudyItem>& items) {
  std::map<std::tuple<int, long, bool>, std::vector<StudyItem*>> passes;
  for (StudyItem& item : items) {
    const long rung = std::lround(std::log2(estimated_length(item.scene).step_s));
    passes[{item.group, rung, item.scene.damping.region != scene::DampingRegion::none}].push_back(&item);
  }
  for (const auto& [kind, pass] : passes) {
    std::vector<std::int64_t> steps;
    double all = 0.0, dearest = 0.0;
    for (const StudyItem* item : pass) {
      steps.push_back(std::max<std::int64_t>(1, estimated_length(item->scene).steps));
      all += static_cast<double>(steps.back());
      dearest = std::max(dearest, estimated_step_cost(item->scene));
    }
    const double cost = dearest * soonest(steps, pass.front()->scene.solver.precision).time;
    for (std::size_t k = 0; k < pass.size(); ++k) pass[k]->cost = cost * static_cast<double>(steps[k]) / all;
  }
}

}  // namespace

std::vector<StudyItem> plan_study(const scene::Preset& preset, const std::string& version) {
  std::vector<StudyItem> items;
  std::map<std::string, int> groups;
  for (scene::Scene& scene : scenes_of_study(preset)) {
    StudyItem item;
    item.row = static_cast<int>(items.size());
    item.key = result_key(scene, version);
    item.group = groups.emplace(shared_text(scene), static_cast<int>(groups.size())).first->second;
    item.scene = std::move(scene);
    items.push_back(std::move(item));
  }
  std::stable_sort(items.begin(), items.end(),
                   [](const StudyItem& a, const StudyItem& b) { return a.group < b.group; });
  share_costs(items);
  return items;
}

std::vector<StudyItem> part_of(const std::vector<StudyItem>& items, int shard, int shards) {
  double total = 0.0, before = 0.0;
  for (const StudyItem& item : items) total += item.cost;
  std::vector<StudyItem> part;
  for (const StudyItem& item : items) {
    const double middle = (before + 0.5 * item.cost) / total;
    if (std::min(shards, 1 + static_cast<int>(std::floor(middle * shards))) == shard) part.push_back(item);
    before += item.cost;
  }
  return part;
}

}  // namespace rift::study
