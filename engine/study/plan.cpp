#include "engine/study/plan.hpp"

#include "engine/ensemble/instruction_set.hpp"
#include "engine/history/crack_history.hpp"
#include "engine/scene/derived.hpp"
#include "engine/scene/parameters.hpp"
#include "engine/scene/scenarios.hpp"
#include "engine/scene/values_text.hpp"
#include "engine/simulation/prepare.hpp"
#include "engine/simulation/schedule.hpp"
#include "engine/study/resources.hpp"
#include "engine/study/store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string_view>
#include <tuple>

namespace rift::study {
namespace {

/// The scene as text without how it is shown, which changes none of its numbers.
std::string text_without_film(const scene::Scene& scene) {
  return scene::values_text(scene, [](const scene::Parameter& row) { return !row.key.starts_with("film."); });
}

}  // namespace

std::vector<scene::Scene> scenes_of_study(const scene::Preset& preset) {
  std::vector<scene::Scene> scenes;
  for (const scene::StudyRow& row : preset.study) {
    scenes.push_back(row.scene);
    scenes.back().output.frames = 0;
  }
  return scenes;
}

scene::StudyRow study_row_of(const scene::Scene& scene) {
  scene::StudyRow row{scene, {}};
  for (const scene::Axis& axis : scene::axes())
    row.axes.emplace_back(axis.name, scene::axis_text(scene, axis));
  return row;
}

std::string result_key(const scene::Scene& scene, const std::string& version) {
  return fmt::format("{}\nversion {}\ninstruction set {}\n", text_without_film(scene), version,
                     ensemble::name_of(ensemble::instruction_set()));
}

std::string study_hash(const scene::Preset& preset) {
  std::string text = "version " RIFT_VERSION "\n";
  for (const scene::Scene& scene : scenes_of_study(preset)) text += text_without_film(scene);
  return hash_text(text);
}

namespace {

constexpr double critical_radii = 0.63;        // critical step x c_r / R
constexpr double preparation_steps = 10000.0;  // packing and static solve last as long as so many steps

double crack_time(const scene::Scene& scene) {
  if (scene::breaks_freely(scene)) return *scene.breaking.duration;
  if (!scene.crack.history.empty())
    return history::time_of_arrival(scene::smoothed_history(scene).history, scene::crack_end(scene));
  std::vector<history::SpeedUntil> pieces;
  for (const scene::VelocityPiece& piece : scene.crack.velocity)
    pieces.push_back({scene::speed_m_s(piece.speed, scene::rayleigh_speed(scene)),
                      piece.until.value_or(std::numeric_limits<double>::infinity())});
  return history::time_of_arrival(
      history::history_of(scene.crack.start - scene::expected_zone_m(scene), pieces),
      scene::crack_end(scene));
}

double estimated_step(const scene::Scene& scene) {
  if (scene.solver.dt) return *scene.solver.dt;
  const double critical =
      critical_radii * scene::expected_mean_radius_m(scene) / scene::rayleigh_speed(scene);
  if (scene.solver.dt_fraction) return *scene.solver.dt_fraction * critical;
  return simulation::default_step(critical, scene::expected_zone_m(scene),
                                  scene::highest_velocity(scene) * scene::rayleigh_speed(scene));
}

}  // namespace

StepCount estimated_steps(const scene::Scene& scene) {
  const double step = estimated_step(scene);
  double steps = crack_time(scene) / step;
  if (scene.loading.method == scene::LoadingMethod::ramp)
    steps += scene.loading.ramp_steps + scene.loading.hold_steps;
  return {step, static_cast<std::int64_t>(std::min(steps, simulation::most_steps))};  // more are refused
}

double estimated_step_cost(const scene::Scene& scene) {
  const double damping = scene.damping.region == scene::DampingRegion::all       ? 2.0
                         : scene.damping.region == scene::DampingRegion::surface ? 1.2
                                                                                 : 1.0;
  const double turning = scene.solver.kinematics == lattice::Kinematics::corotational ? 6.0 : 1.0;
  return damping * turning * expected_size(scene).beams;
}

double estimated_cost(const scene::Scene& scene) {
  return estimated_step_cost(scene) * static_cast<double>(estimated_steps(scene).steps);
}

double estimated_preparation(const scene::Scene& scene) {
  return expected_size(scene).beams * preparation_steps;
}

namespace {

bool must_agree_in_lanes(const scene::Parameter& row) {
  static const std::set<std::string_view> may_differ = [] {
    std::set<std::string_view> keys;
    for (const scene::Axis& axis : scene::axes())
      if (axis.per_lane) keys.insert(axis.key);
    return keys;
  }();
  return !may_differ.contains(row.key);
}

/// Equal for scenes that differ at most in what lanes may differ in, or by being in-situ and bulk: time and
/// energy tell these apart, on one lattice.
std::string shared_text(scene::Scene scene) {
  if (scene.material.stiffness == scene::StiffnessChoice::bulk)
    scene.material.stiffness = scene::StiffnessChoice::in_situ;
  return scene::values_text(scene, must_agree_in_lanes);
}

/// Scenarios of a group, of about equal step and damped or not, march in one pass: each costs its steps'
/// share.
void share_costs(std::vector<StudyItem>& items) {
  std::map<std::tuple<int, long, bool>, std::vector<StudyItem*>> passes;
  for (StudyItem& item : items) {
    const long rung = std::lround(std::log2(estimated_steps(item.scene).step_s));
    passes[{item.group, rung, item.scene.damping.region != scene::DampingRegion::none}].push_back(&item);
  }
  for (const auto& [kind, pass] : passes) {
    std::vector<std::int64_t> steps;
    double all = 0.0, dearest = 0.0;
    for (const StudyItem* item : pass) {
      steps.push_back(std::max<std::int64_t>(1, estimated_steps(item->scene).steps));
      all += static_cast<double>(steps.back());
      dearest = std::max(dearest, estimated_step_cost(item->scene));
    }
    const double cost = dearest * soonest(steps, pass.front()->scene.solver.precision).time;
    for (std::size_t k = 0; k < pass.size(); ++k) pass[k]->cost = cost * static_cast<double>(steps[k]) / all;
  }
}

}  // namespace

std::vector<StudyItem> plan_scenes(std::vector<scene::Scene> scenes, const std::string& version) {
  std::vector<StudyItem> items;
  std::map<std::string, int> groups, specimens;
  for (scene::Scene& scene : scenes) {
    StudyItem item;
    item.row = static_cast<int>(items.size());
    item.key = result_key(scene, version);
    item.shares = hash_text(shared_text(scene));
    item.group = groups.emplace(item.shares, static_cast<int>(groups.size())).first->second;
    item.specimen =
        specimens.emplace(simulation::specimen_key(scene), static_cast<int>(specimens.size())).first->second;
    item.scene = std::move(scene);
    items.push_back(std::move(item));
  }
  std::stable_sort(items.begin(), items.end(),
                   [](const StudyItem& a, const StudyItem& b) { return a.group < b.group; });
  share_costs(items);
  return items;
}

std::vector<StudyItem> plan_study(const scene::Preset& preset, const std::string& version) {
  return plan_scenes(scenes_of_study(preset), version);
}

double PreparationCost::next(const StudyItem& item) {
  const double packing = packed_.insert(item.specimen).second ? packing_share : 0.0,
               solving = solved_.insert(item.group).second ? 1.0 - packing_share : 0.0;
  return (packing + solving) * estimated_preparation(item.scene);
}

double estimated_seconds(const std::vector<StudyItem>& items) {
  PreparationCost preparation;
  double beam_steps = 0.0;
  for (const StudyItem& item : items) beam_steps += item.cost + preparation.next(item);
  return beam_steps / assumed_beam_steps_per_s;
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

namespace {

/// Lanes as a part of most_lanes, and what a step of so many takes, in steps of a half   [measured with
/// AVX-512, 20,000 elements, one thread beside other load: 0.41 and 2.15 in single precision, 0.47 and 2.46
/// in double; 3,000 elements, which the cache holds: 1.7 and 1.6 for all]. One lane puts beams side by side;
/// a quarter is for processors with no wider registers.
struct Width {
  int part;
  double step;
};

std::vector<Width> widths(ensemble::Precision precision) {
  const int most = ensemble::most_lanes(precision);
  std::vector<Width> usable{{most, 0.45}};
  for (const Width& width : {Width{4, 1.1}, Width{2, 1.0}, Width{1, 2.1}})
    if (most / width.part <= ensemble::lanes_in_register(precision, ensemble::instruction_set()))
      usable.push_back(width);
  return usable;
}

}  // namespace

std::vector<std::vector<std::size_t>> passes_of(const std::vector<simulation::LanePlan>& lanes) {
  const auto kind = [&](std::size_t k) {
    const simulation::LanePlan& lane = lanes[k];
    const bool moving = scene::grip_moves(lane.scene);  // by one clock
    return std::tuple(lane.step.dt, lane.scene.damping.region == scene::DampingRegion::none,
                      moving ? lane.lead : 0.0, moving ? lane.units.time : 0.0);
  };
  const auto length = [&](std::size_t k) {
    return history::time_of_arrival(lanes[k].scenario.history, lanes[k].crack_end);
  };
  std::vector<std::size_t> order(lanes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return length(a) > length(b); });
  const ensemble::Precision precision = lanes.front().scene.solver.precision;
  const auto most = static_cast<std::size_t>(lanes_of_many(precision));
  const bool one_grip = lanes.front().scene.loading.method == scene::LoadingMethod::ramp ||
                        scene::grip_moves(lanes.front().scene);
  std::vector<std::vector<std::size_t>> passes;
  for (const std::size_t k : order) {
    const auto fits = [&](const std::vector<std::size_t>& pass) {
      return kind(pass.front()) == kind(k) && !(one_grip && pass.size() >= most);
    };
    const auto pass = std::find_if(passes.begin(), passes.end(), fits);
    if (pass == passes.end()) {
      passes.push_back({k});
    } else {
      pass->push_back(k);
    }
  }
  return passes;
}

namespace {

/// Steps until the last scenario is done: the longest first, each on the lane that is free first.
double steps_of_queue(const std::vector<std::int64_t>& longest_first, int lanes) {
  std::vector<std::int64_t> busy_until(lanes, 0);
  for (const std::int64_t steps : longest_first)
    *std::min_element(busy_until.begin(), busy_until.end()) += steps;
  return static_cast<double>(*std::max_element(busy_until.begin(), busy_until.end()));
}

}  // namespace

Queue soonest(std::vector<std::int64_t> steps, ensemble::Precision precision) {
  std::sort(steps.begin(), steps.end(), std::greater<>());
  Queue best;
  for (const Width& width : widths(precision)) {
    const int lanes = ensemble::most_lanes(precision) / width.part;
    const double time = width.step * steps_of_queue(steps, lanes);
    if (best.time == 0.0 || time < best.time) best = {lanes, time};
  }
  return best;
}

int lanes_of_many(ensemble::Precision precision) {
  return soonest(std::vector<std::int64_t>(1000, 1), precision).lanes;
}

}  // namespace rift::study
