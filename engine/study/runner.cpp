#include "engine/study/runner.hpp"

#include "engine/base/clock.hpp"
#include "engine/base/files.hpp"
#include "engine/base/interrupted.hpp"
#include "engine/base/ownership.hpp"
#include "engine/ensemble/instruction_set.hpp"
#include "engine/results/series.hpp"
#include "engine/scene/derived.hpp"
#include "engine/scene/scenarios.hpp"
#include "engine/simulation/kept_march.hpp"
#include "engine/simulation/summary.hpp"
#include "engine/study/kernel_cost.hpp"
#include "engine/study/plan.hpp"
#include "engine/study/store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <system_error>

namespace rift::study {
namespace {

using Clock = std::chrono::steady_clock;
using Json = nlohmann::ordered_json;

/// A study under way.
struct Study {
  const scene::Preset& preset;
  const StudyOptions& options;
  base::Cache& cache;
  const simulation::BuildInfo& build;
  const StudyObserver& observer;
  std::vector<StudyItem> items;  // of all parts
  KernelCosts kernels = {};
  StudyResult result = {};
  int there = 0;                   // scenarios computed or found
  double cost = 0, cost_done = 0;  // of what is to be computed
  bool stopped = false;
  double preparation = 0;  // cost, of the group under way
  std::map<std::string, std::vector<scene::Issue>> impossible =
      {};  // specimens by simulation::specimen_key(), and why

  bool is_there(const StudyItem& item) const { return result.rows[item.row].has_value(); }

  /// Tells how far the whole is when `part` of something of this cost is done.
  bool tell(std::string_view stage, double part, double of_cost) {
    if (!observer.progress) return true;
    stopped = stopped || !observer.progress(stage, std::min(1.0, (cost_done + part * of_cost) / cost));
    return !stopped;
  }
};

Json axes_of(const AxisTexts& row) {
  Json axes = Json::object();
  for (const auto& [name, text] : row) axes[name] = text;
  return axes;
}

StudyManifest manifest_of(const scene::Preset& preset, const std::vector<StudyItem>& items,
                          const simulation::BuildInfo& build) {
  StudyManifest manifest{.hash = study_hash(preset),
                         .version = build.version,
                         .instruction_set = std::string(ensemble::name_of(ensemble::instruction_set())),
                         .preset = preset.name,
                         .preset_text = scene::preset_text(preset),
                         .axes = {},
                         .rows = Json::array()};
  for (const auto& [name, text] : preset.study.front().axes) manifest.axes.push_back(name);
  for (const scene::StudyRow& row : preset.study) manifest.rows.push_back({{"axes", axes_of(row.axes)}});
  for (const StudyItem& item : items) manifest.rows[item.row]["file"] = result_file("", item.key).string();
  return manifest;
}

void take(Study& study, const StudyItem& item, results::LaneSummary summary) {
  const SummaryRow& row = study.result.rows[item.row].emplace(
      SummaryRow{std::move(summary), study.preset.study[item.row].axes, item.row,
                 result_file("", item.key).replace_extension(".csv").string()});
  if (row.outcome == simulation::name_of(simulation::Outcome::diverged))
    study.result.outcome = simulation::Outcome::diverged;
  ++study.there;
  if (study.observer.finished)
    study.observer.finished(row, study.there, static_cast<int>(study.preset.study.size()));
}

/// Takes the scenarios that the folder holds.
void gather(Study& study, const std::vector<StudyItem>& items) {
  for (const StudyItem& item : items) {
    if (study.is_there(item)) continue;
    auto summary = read_result(study.options.folder, item.key, study.cache.notes);
    if (!summary) continue;
    ++study.result.found;
    take(study, item, std::move(*summary));
  }
}

/// The scenario as a preset of its own, so that a message says which of the study's values is meant.
scene::Preset preset_of(const Study& study, const StudyItem& item) {
  scene::Preset preset;
  preset.scene = item.scene;
  preset.origins = study.preset.origins;
  preset.name = study.preset.name;
  for (const auto& [name, text] : study.preset.study[item.row].axes)
    preset.origins[std::string(scene::find_axis(name)->key)] = {preset.name, 0, text};
  return preset;
}

/// The energy balance, that of a ramp included, and the rate curve, as series.csv of a run has them.
std::string series_of(const simulation::LaneResult& lane, const simulation::Rates& rates) {
  std::vector<results::Sample> rows;
  for (results::Sample row : lane.samples) {
    row.lane = 0;
    rows.push_back(row);
  }
  const results::RateCurve curve{0, rates.curve};
  return results::series_csv(rows, {&curve, 1});
}

/// A pass is known by the names of its scenarios' results, in the order in which they march.
std::string pass_identity(std::span<const StudyItem> pass) {
  std::string names;
  for (const StudyItem& item : pass) names += hash_text(item.key) + "\n";
  return names;
}

std::filesystem::path passes_folder(const Study& study) { return study.options.folder / "passes"; }

/// Marches what `prepared` holds now, keeps each scenario as it ends, and of what is under way a checkpoint.
void march_pass(Study& study, const simulation::Prepared& prepared, std::span<const StudyItem> pass,
                Clock::time_point started) {
  const std::string identity = pass_identity(pass);
  simulation::MarchKeeping keeping{
      .folder = passes_folder(study) / hash_text(identity), .identity = identity, .result_too = false};
  std::string note;
  const std::optional<simulation::Resumption> from = simulation::kept_march(keeping, note);
  keeping.taken_before_s =
      base::seconds_since(started) + (from ? simulation::taken_s(from->checkpoint) : 0.0);
  const auto marching = Clock::now();
  double cost = 0.0;
  for (const StudyItem& item : pass)
    if (!study.is_there(item)) cost += item.cost;
  simulation::Observer observer;
  observer.ended = [&](int k, const simulation::RunResult& so_far) {
    const simulation::LaneResult& lane = so_far.lane[k];
    if (lane.outcome == simulation::Outcome::stopped || study.is_there(pass[k])) return;
    const simulation::Rates rates = simulation::rates_of(prepared, so_far, k);
    results::LaneSummary scenario = simulation::lane_summary(
        prepared, so_far, k, rates, study.build, keeping.taken_before_s + base::seconds_since(marching));
    scenario.cost_s = study.kernels.cost_s(pass[k].scene, scenario);
    ++study.result.computed;
    take(study, pass[k], write_result(study.options.folder, pass[k].key, scenario, series_of(lane, rates)));
  };
  observer.go_on = [&](const simulation::Progress& p) {
    return study.tell("crack", static_cast<double>(p.step) / static_cast<double>(p.total), cost);
  };
  std::vector<std::int64_t> steps;
  for (const simulation::LanePlan& lane : prepared.lane) steps.push_back(lane.schedule.total());
  const scene::Scene& scene = prepared.preset.scene;
  const bool all_at_once = prepared.lane.front().schedule.ramp > 0 || scene::grip_moves(scene);
  const int lanes = all_at_once ? 0 : soonest(steps, scene.solver.precision).lanes;
  const simulation::RunResult marched = simulation::march_and_keep(
      prepared, observer,
      {.threads = study.options.threads, .lanes = lanes, .checkpoint_s = study.options.checkpoint_s}, keeping,
      from ? &*from : nullptr, note);
  study.result.lane_steps += marched.lane_steps, study.result.lane_room += marched.lane_room;
  if (!note.empty()) study.cache.notes.push_back(note + ": the pass starts from the beginning");
  study.cost_done += cost;
  if (!study.stopped) simulation::forget_march(keeping.folder);
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

/// Some scenarios of a group cannot run, by their rows.
struct ScenariosRefused {
  std::map<int, std::vector<scene::Issue>> of;
};

/// What is wrong with lanes that were prepared together, each with the values of its own scenario.
ScenariosRefused refused_scenarios(const Study& study, std::span<const StudyItem> items,
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

/// The group's lattice under its pre-stress, with a lane for each of these scenarios. Throws
/// ScenariosRefused.
simulation::Prepared prepare_lanes(Study& study, std::span<const StudyItem> items) {
  std::vector<scene::Scene> scenes;
  for (const StudyItem& item : items) scenes.push_back(item.scene);
  const double preparation = study.preparation;
  try {
    return simulation::prepare(preset_of(study, items.front()), scenes, study.cache,
                               [&](std::string_view stage, double done) {
                                 return study.tell(stage, share_of_preparation(stage, done), preparation);
                               });
  } catch (const simulation::LanesRefused& lanes) {
    throw refused_scenarios(study, items, lanes);
  }
}

/// A pass that an earlier call has left under way.
struct PassUnderWay {
  std::filesystem::path folder;
  std::vector<StudyItem> items;
};

/// Those passes whose scenarios are all known: computed, or among `missing`.
std::vector<PassUnderWay> passes_under_way(const Study& study, std::span<const StudyItem> missing) {
  std::map<std::string, const StudyItem*> known;  // by the name of the result
  for (const StudyItem& item : study.items)
    if (study.is_there(item)) known[hash_text(item.key)] = &item;
  for (const StudyItem& item : missing) known[hash_text(item.key)] = &item;
  std::vector<PassUnderWay> passes;
  std::error_code none;  // no folder, no passes
  for (const auto& entry : std::filesystem::directory_iterator(passes_folder(study), none)) {
    PassUnderWay pass{.folder = entry.path(), .items = {}};
    std::istringstream names(simulation::kept_identity(entry.path()));
    bool whole = true;
    for (std::string name; whole && std::getline(names, name);) {
      const auto item = known.find(name);
      whole = item != known.end();
      if (whole) pass.items.push_back(*item->second);
    }
    if (whole && !pass.items.empty()) passes.push_back(std::move(pass));
  }
  return passes;
}

/// Removes the passes all of whose scenarios have been computed, by whichever call.
void forget_passes_that_are_done(const Study& study) {
  for (const PassUnderWay& pass : passes_under_way(study, {})) simulation::forget_march(pass.folder);
  std::error_code none;  // a folder that holds other passes stays
  std::filesystem::remove(passes_folder(study), none);
}

void compute_group(Study& study, std::vector<StudyItem> items) {
  const auto started = Clock::now();
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
      add_not_made(study.result.not_made, marching, error.issues);
    }
  }
}

/// The scenarios still to be computed, one list per group.
std::vector<std::vector<StudyItem>> missing(const Study& study, const std::vector<StudyItem>& mine) {
  std::vector<std::vector<StudyItem>> groups;
  for (const StudyItem& item : mine) {
    if (study.is_there(item)) continue;
    if (groups.empty() || groups.back().front().group != item.group) groups.emplace_back();
    groups.back().push_back(item);
  }
  return groups;
}

/// Computes what can be of a group; what cannot is kept with its reason, and each specimen that cannot be
/// made is tried once.
void compute_what_can_be(Study& study, std::vector<StudyItem> items) {
  const std::string specimen = simulation::specimen_key(items.front().scene);
  if (const auto known = study.impossible.find(specimen); known != study.impossible.end())
    return add_not_made(study.result.not_made, items, known->second);
  try {
    compute_group(study, items);
  } catch (const ScenariosRefused& refused) {
    for (const StudyItem& item : items)
      if (const auto found = refused.of.find(item.row); found != refused.of.end())
        add_not_made(study.result.not_made, {item}, found->second);
    std::erase_if(items, [&](const StudyItem& item) { return refused.of.contains(item.row); });
    if (!items.empty()) compute_what_can_be(study, std::move(items));
  } catch (const simulation::SpecimenRefused& error) {
    study.impossible[specimen] = error.issues;
    add_not_made(study.result.not_made, items, error.issues);
  } catch (const scene::InputError& error) {
    add_not_made(study.result.not_made, items, error.issues);
  }
}

void compute(Study& study, const std::vector<std::vector<StudyItem>>& groups) {
  PreparationCost preparation;
  std::vector<double> preparing, ends;  // of each group
  for (const auto& group : groups) {
    preparing.push_back(preparation.next(group.front()));
    study.cost += preparing.back();
    for (const StudyItem& item : group) study.cost += item.cost;
    ends.push_back(study.cost);
  }
  for (std::size_t k = 0; k < groups.size() && !study.stopped; ++k) {
    study.preparation = preparing[k];
    try {
      compute_what_can_be(study, groups[k]);
    } catch (const base::Interrupted&) {
      study.stopped = true;
    }
    study.cost_done = ends[k];
  }
}

/// Throws InputError where there is nothing but scenarios that cannot be made.
void refuse_if_nothing_is_there(const Study& study) {
  std::vector<scene::Issue> issues;
  for (const NotMade& one : study.result.not_made)
    issues.insert(issues.end(), one.issues.begin(), one.issues.end());
  if (study.there == 0 && !study.stopped && !issues.empty()) throw scene::InputError(issues);
}

}  // namespace

double marching_time(const SummaryRow& row) {
  return row.wall_fracture_s + (row.prestress_method == "ramp" ? row.wall_prestress_s : 0.0);
}

Json to_json(const SummaryRow& row) {
  Json json = results::to_json(row);
  json["axes"] = axes_of(row.axes);
  json["row"] = row.row;
  json["series"] = row.series;
  return json;
}

Json to_json(const StudyRows& rows) {
  Json list = Json::array();
  for (const std::optional<SummaryRow>& row : rows) list.push_back(row ? to_json(*row) : Json(nullptr));
  return list;
}

StudyResult run_study(const scene::Preset& preset, const StudyOptions& options, base::Cache& cache,
                      const simulation::BuildInfo& build, const StudyObserver& observer) {
  const auto start = Clock::now();
  Study study{preset, options, cache, build, observer, plan_study(preset, build.version)};
  const std::vector<StudyItem>& items = study.items;
  study.result.rows.resize(preset.study.size());
  if (options.shared) {
    open_shared(options.folder);
  } else {
    open_study(options.folder, manifest_of(preset, items, build), cache.notes);
  }
  const base::FolderLock lock(options.folder, base::FolderLock::Kind::together);
  for (const std::filesystem::path& folder :
       {options.folder, options.folder / "runs", options.folder / "charts"})
    base::remove_leftovers(folder);
  base::check_target(options.folder / "table.csv");
  gather(study, items);
  compute(study, missing(study, part_of(items, options.shard, options.shards)));
  refuse_if_nothing_is_there(study);
  if (options.shards > 1) gather(study, items);
  if (study.stopped)
    study.result.outcome = simulation::Outcome::stopped;
  else
    forget_passes_that_are_done(study);
  study.result.wall_s = base::seconds_since(start);
  return std::move(study.result);
}

}  // namespace rift::study
