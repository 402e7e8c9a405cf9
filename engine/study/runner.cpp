#include "engine/study/runner.hpp"

#include "engine/ensemble/instruction_set.hpp"
#include "engine/interrupted.hpp"
#include "engine/results/files.hpp"
#include "engine/results/ownership.hpp"
#include "engine/results/series.hpp"
#include "engine/scene/axes.hpp"
#include "engine/simulation/summary.hpp"
#include "engine/study/cost.hpp"
#include "engine/study/passes.hpp"
#include "engine/study/plan.hpp"
#include "engine/study/store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace rift {
namespace {

using Clock = std::chrono::steady_clock;
using Json = nlohmann::ordered_json;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A study under way.
struct Study {
  const Preset& preset;
  const StudyOptions& options;
  Cache& cache;
  const BuildInfo& build;
  const StudyObserver& observer;
  StudyResult result = {};
  int there = 0;                   // scenarios computed or found
  double cost = 0, cost_done = 0;  // of what is to be computed   [cost.hpp]
  bool stopped = false;
  std::vector<Issue> issues = {};

  /// Tells how far the whole is when `part` of something of this cost is done.
  bool tell(std::string_view stage, double part, double of_cost) {
    if (!observer.progress) return true;
    stopped = stopped || !observer.progress(stage, std::min(1.0, (cost_done + part * of_cost) / cost));
    return !stopped;
  }
};

Json axes_of(const StudyRow& row) {
  Json axes = Json::object();
  for (const auto& [name, text] : row.axes) axes[name] = text;
  return axes;
}

StudyManifest manifest_of(const Preset& preset, const std::vector<StudyItem>& items, const BuildInfo& build) {
  StudyManifest manifest{.hash = study_hash(preset),
                         .version = build.version,
                         .instruction_set = std::string(name_of(instruction_set())),
                         .preset = preset.name,
                         .preset_text = preset_text(preset),
                         .axes = {},
                         .rows = Json::array()};
  for (const auto& [name, text] : preset.study.front().axes) manifest.axes.push_back(name);
  for (const StudyRow& row : preset.study) manifest.rows.push_back({{"axes", axes_of(row)}});
  for (const StudyItem& item : items) manifest.rows[item.row]["file"] = result_file("", item.key).string();
  return manifest;
}

void take(Study& study, const StudyItem& item, Json scenario) {
  SummaryRow& row = study.result.rows[item.row];
  row = std::move(scenario);
  row["axes"] = axes_of(study.preset.study[item.row]);
  row["row"] = item.row;
  row["series"] = result_file("", item.key).replace_extension(".csv").string();
  if (row.at("outcome") == name_of(Outcome::diverged)) study.result.outcome = Outcome::diverged;
  ++study.there;
  if (study.observer.finished)
    study.observer.finished(row, study.there, static_cast<int>(study.preset.study.size()));
}

/// Takes the scenarios that the folder holds.
void gather(Study& study, const std::vector<StudyItem>& items) {
  for (const StudyItem& item : items) {
    if (!study.result.rows[item.row].is_null()) continue;
    auto scenario = read_result(study.options.folder, item.key, study.cache.notes);
    if (!scenario) continue;
    ++study.result.found;
    take(study, item, std::move(*scenario));
  }
}

/// The scenario as a preset of its own, so that a message says which of the study's values is meant.
Preset preset_of(const Study& study, const StudyItem& item) {
  Preset preset;
  preset.scene = item.scene;
  preset.origins = study.preset.origins;
  preset.name = study.preset.name;
  for (const auto& [name, text] : study.preset.study[item.row].axes)
    preset.origins[std::string(find_axis(name)->key)] = {preset.name, 0, text};
  return preset;
}

/// The books, those of a ramp among them, and the rate curve, as series.csv of a run has them.
std::string series_of(const LaneResult& lane, const Rates& rates) {
  std::vector<results::Sample> rows;
  for (results::Sample row : lane.books) {
    row.lane = 0;
    rows.push_back(row);
  }
  const results::RateCurve curve{0, rates.curve};
  return results::series_csv(rows, {&curve, 1});
}

/// Marches what `prepared` holds now and keeps each scenario as it ends.
void march_pass(Study& study, const Prepared& prepared, const std::vector<StudyItem>& items,
                Clock::time_point started) {
  double cost = 0.0;
  for (const StudyItem& item : items) cost += item.cost;
  Observer observer;
  observer.ended = [&](int k, const RunResult& so_far) {
    const LaneResult& lane = so_far.lane[k];
    if (lane.outcome == Outcome::stopped) return;
    const Rates rates = rates_of(prepared, so_far, k);
    const Json scenario = lane_summary(prepared, so_far, k, rates, study.build, seconds_since(started));
    ++study.result.computed;
    take(study, items[k], write_result(study.options.folder, items[k].key, scenario, series_of(lane, rates)));
  };
  observer.go_on = [&](const Progress& p) {
    return study.tell("crack", static_cast<double>(p.step) / static_cast<double>(p.total), cost);
  };
  std::vector<std::int64_t> steps;
  for (const LanePlan& lane : prepared.lane) steps.push_back(lane.schedule.total());
  const bool ramp = prepared.lane.front().schedule.ramp > 0;
  const int lanes = ramp ? 0 : soonest(steps, prepared.preset.scene.solver.precision).lanes;
  march(prepared, observer, {.threads = study.options.threads, .lanes = lanes});
  study.cost_done += cost;
}

void compute_group(Study& study, const std::vector<StudyItem>& items) {
  const auto started = Clock::now();
  std::vector<Scene> scenes;
  for (const StudyItem& item : items) scenes.push_back(item.scene);
  const double preparation = estimated_preparation(scenes.front());
  Prepared prepared =
      prepare(preset_of(study, items.front()), scenes, study.cache, [&](std::string_view stage, double done) {
        const bool packing = stage == "packing";
        return study.tell(stage, packing ? 0.7 * done : 0.7, preparation);
      });
  study.cost_done += preparation;
  const std::vector<LanePlan> plans = prepared.lane;
  for (const std::vector<std::size_t>& pass : passes_of(plans)) {
    if (study.stopped) return;
    std::vector<LanePlan> lanes;
    std::vector<StudyItem> marching;
    for (const std::size_t k : pass) lanes.push_back(plans[k]), marching.push_back(items[k]);
    take_lanes(prepared, std::move(lanes));
    march_pass(study, prepared, marching, started);
  }
}

/// The scenarios still to be computed, one list per group.
std::vector<std::vector<StudyItem>> missing(const Study& study, const std::vector<StudyItem>& mine) {
  std::vector<std::vector<StudyItem>> groups;
  for (const StudyItem& item : mine) {
    if (!study.result.rows[item.row].is_null()) continue;
    if (groups.empty() || groups.back().front().group != item.group) groups.emplace_back();
    groups.back().push_back(item);
  }
  return groups;
}

void compute(Study& study, const std::vector<std::vector<StudyItem>>& groups) {
  for (const auto& group : groups) {
    study.cost += estimated_preparation(group.front().scene);
    for (const StudyItem& item : group) study.cost += item.cost;
  }
  for (const auto& group : groups) {
    try {
      compute_group(study, group);
    } catch (const InputError& error) {
      study.issues.insert(study.issues.end(), error.issues.begin(), error.issues.end());
    } catch (const Interrupted&) {
      study.stopped = true;
    }
    if (study.stopped) return;
  }
}

}  // namespace

StudyResult run_study(const Preset& preset, const StudyOptions& options, Cache& cache, const BuildInfo& build,
                      const StudyObserver& observer) {
  const auto start = Clock::now();
  Study study{preset, options, cache, build, observer};
  const std::vector<StudyItem> items = plan_study(preset, build.version);
  study.result.rows.resize(preset.study.size());
  if (options.shared) {
    open_shared(options.folder);
  } else {
    open_study(options.folder, manifest_of(preset, items, build), cache.notes);
  }
  const results::FolderLock lock(options.folder, results::FolderLock::Kind::together);
  for (const std::filesystem::path& folder :
       {options.folder, options.folder / "runs", options.folder / "charts"})
    results::remove_leftovers(folder);
  results::check_target(options.folder / "table.csv");
  gather(study, items);
  compute(study, missing(study, part_of(items, options.shard, options.shards)));
  if (!study.issues.empty()) throw InputError(study.issues);
  if (options.shards > 1) gather(study, items);
  if (study.stopped) study.result.outcome = Outcome::stopped;
  study.result.wall_s = seconds_since(start);
  return std::move(study.result);
}

}  // namespace rift
