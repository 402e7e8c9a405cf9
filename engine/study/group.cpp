#include "engine/base/interrupted.hpp"
#include "engine/scene/scenarios.hpp"
#include "engine/study/store.hpp"
#include "engine/study/under_way.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <thread>
#include <utility>

namespace rift::study {
namespace {

/// The scenario as a preset of its own, so that a message says which of the study's values is meant.
scene::Preset preset_of(const UnderWay& study, const StudyItem& item) {
  scene::Preset preset;
  preset.scene = item.scene;
  preset.origins = study.preset.origins;
  preset.name = study.preset.name;
  for (const auto& [name, text] : study.preset.study[item.row].axes)
    preset.origins[std::string(scene::find_axis(name)->key)] = {preset.name, 0, text};
  return preset;
}

/// How much of the preparation is done when so much of a stage is.
double share_of_preparation(std::string_view stage, double done) {
  constexpr double pre_stressed = 0.9, undamped = 0.95;
  if (stage == "packing") return packing_share * done;
  if (stage == "pre-stress") return packing_share + (pre_stressed - packing_share) * done;
  if (stage == "critical step") return pre_stressed + (undamped - pre_stressed) * done;
  if (stage == "critical step with damping") return undamped + (1.0 - undamped) * done;
  return packing_share;  // a calibration, which comes between the first two
}

/// Under which the cache says that it holds a group's packing and pre-stress.
constexpr const char* prepared_kind = "prepared";

/// The turn to pack and pre-stress a specimen, so that no two processes do the same at once; none where the
/// cache holds both, or nothing is kept. Waits for another process that is at it.
std::optional<base::Claim> turn_to_prepare(UnderWay& study, const StudyItem& item) {
  if (!study.claims || study.cache.folder.empty()) return std::nullopt;
  const std::string name = "specimen-" + hash_text(simulation::specimen_key(item.scene));
  constexpr auto between_looks = std::chrono::milliseconds(200);
  while (!base::recall(study.cache, prepared_kind, item.shares)) {
    if (std::optional<base::Claim> turn = study.claims->take(name)) return turn;
    if (!study.tell("waiting for a specimen that another process prepares", 0.0, 0.0))
      throw base::Interrupted("another process prepared a specimen");
    std::this_thread::sleep_for(between_looks);
  }
  return std::nullopt;
}

/// Some scenarios of a group cannot run, by their rows.
struct ScenariosRefused {
  std::map<int, std::vector<scene::Issue>> of;
};

/// What is wrong with lanes that were prepared together, each with the values of its own scenario.
ScenariosRefused refused_scenarios(const UnderWay& study, std::span<const StudyItem> items,
                                   const simulation::LanesRefused& lanes) {
  ScenariosRefused refused;
  for (const auto& [lane, issues] : lanes.of) {
    const int row = items[lane].row;
    for (scene::Issue issue : issues) {
      for (const auto& [name, text] : study.preset.study[row].axes)
        if (scene::find_axis(name)->key == issue.key) issue.value = text;
      refused.of[row].push_back(std::move(issue));
    }
  }
  return refused;
}

}  // namespace

simulation::Prepared prepare_lanes(UnderWay& study, std::span<const StudyItem> items) {
  std::vector<scene::Scene> scenes;
  for (const StudyItem& item : items) scenes.push_back(item.scene);
  const double preparation = study.preparation;
  const std::optional<base::Claim> turn = turn_to_prepare(study, items.front());
  try {
    simulation::Prepared lanes = simulation::prepare(
        preset_of(study, items.front()), scenes, study.cache, [&](std::string_view stage, double done) {
          return study.tell(stage, share_of_preparation(stage, done), preparation);
        });
    if (turn) base::remember(study.cache, prepared_kind, items.front().shares, std::array{1.0});
    return lanes;
  } catch (const simulation::LanesRefused& lanes) {
    throw refused_scenarios(study, items, lanes);
  }
}

namespace {

void compute_group(UnderWay& study, std::vector<StudyItem> items) {
  if (study.options.work == StudyWork::preparation) return static_cast<void>(prepare_lanes(study, items));
  const auto started = base::Clock::now();
  for (const PassUnderWay& pass : passes_under_way(study, items)) {
    if (std::all_of(pass.items.begin(), pass.items.end(),
                    [&](const StudyItem& item) { return study.is_there(item); }))
      continue;
    march_pass(study, prepare_lanes(study, pass.items), pass.items, started);
    if (study.stopped) return;
  }
  std::erase_if(items, [&](const StudyItem& item) { return study.is_there(item); });
  if (items.empty()) return;
  simulation::Prepared prepared = prepare_lanes(study, items);
  study.cost_done += study.preparation;
  const std::vector<simulation::LanePlan> plans = prepared.lane;
  for (const std::vector<std::size_t>& pass : passes_of(plans)) {
    if (study.stopped) return;
    std::vector<simulation::LanePlan> lanes;
    std::vector<StudyItem> marching;
    for (const std::size_t k : pass) lanes.push_back(plans[k]), marching.push_back(items[k]);
    try {
      simulation::take_lanes(prepared, std::move(lanes));
      march_pass(study, prepared, marching, started);
    } catch (const scene::InputError& error) {  // the other passes are computed all the same
      note_not_made(study, marching, error.issues);
    }
  }
}

}  // namespace

void compute_what_can_be(UnderWay& study, std::vector<StudyItem> items) {
  const std::string specimen = simulation::specimen_key(items.front().scene);
  if (const auto known = study.impossible.find(specimen); known != study.impossible.end())
    return note_not_made(study, items, known->second);
  try {
    compute_group(study, items);
  } catch (const ScenariosRefused& refused) {
    for (const StudyItem& item : items)
      if (const auto found = refused.of.find(item.row); found != refused.of.end())
        note_not_made(study, {item}, found->second);
    std::erase_if(items, [&](const StudyItem& item) { return refused.of.contains(item.row); });
    if (!items.empty()) compute_what_can_be(study, std::move(items));
  } catch (const simulation::SpecimenRefused& error) {
    study.impossible[specimen] = error.issues;
    note_not_made(study, items, error.issues);
  } catch (const scene::InputError& error) {
    note_not_made(study, items, error.issues);
  }
}

}  // namespace rift::study
