#include "engine/study/runner.hpp"

#include "engine/base/clock.hpp"
#include "engine/base/files.hpp"
#include "engine/base/interrupted.hpp"
#include "engine/base/ownership.hpp"
#include "engine/ensemble/instruction_set.hpp"
#include "engine/scene/scenarios.hpp"
#include "engine/study/store.hpp"
#include "engine/study/under_way.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace rift::study {
namespace {

using Json = nlohmann::ordered_json;

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

/// Takes what earlier calls have found that cannot be made.
void gather_not_made(UnderWay& study) {
  for (const StudyItem& item : study.items) {
    if (study.is_there(item)) continue;
    if (const auto issues = read_not_made(study.options.folder, item.key))
      add_not_made(study.result.not_made, {item}, *issues);
  }
}

/// Throws InputError where there is nothing but scenarios that cannot be made.
void refuse_if_nothing_is_there(const UnderWay& study) {
  std::vector<scene::Issue> issues;
  for (const NotMade& one : study.result.not_made)
    issues.insert(issues.end(), one.issues.begin(), one.issues.end());
  if (study.there == 0 && !study.stopped && !issues.empty()) throw scene::InputError(issues);
}

}  // namespace

bool UnderWay::tell(std::string_view stage, double part, double of_cost) {
  if (!observer.progress) return true;
  stopped = stopped || !observer.progress(stage, std::min(1.0, (cost_done + part * of_cost) / cost));
  return !stopped;
}

void take(UnderWay& study, const StudyItem& item, results::LaneSummary summary) {
  const SummaryRow& row = study.result.rows[item.row].emplace(
      SummaryRow{std::move(summary), study.preset.study[item.row].axes, item.row,
                 result_file("", item.key).replace_extension(".csv").string()});
  if (row.outcome == simulation::name_of(simulation::Outcome::diverged))
    study.result.outcome = simulation::Outcome::diverged;
  ++study.there;
  if (study.observer.finished)
    study.observer.finished(row, study.there, static_cast<int>(study.preset.study.size()));
}

void gather(UnderWay& study, std::span<const StudyItem> items) {
  for (const StudyItem& item : items) {
    if (study.is_there(item)) continue;
    std::vector<std::string> damaged;
    auto summary = read_result(study.options.folder, item.key, damaged);
    for (std::string& note : damaged)  // it is looked at again when it is taken on
      if (std::find(study.cache.notes.begin(), study.cache.notes.end(), note) == study.cache.notes.end())
        study.cache.notes.push_back(std::move(note));
    if (!summary) continue;
    ++study.result.found;
    take(study, item, std::move(*summary));
  }
}

void note_not_made(UnderWay& study, const std::vector<StudyItem>& items,
                   const std::vector<scene::Issue>& issues) {
  add_not_made(study.result.not_made, items, issues);
  if (study.options.shared) return;
  for (const StudyItem& item : items) write_not_made(study.options.folder, item.key, issues);
}

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
  const auto start = base::Clock::now();
  UnderWay study{preset, options, cache, build, observer, plan_study(preset, build.version)};
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
  if (!options.shared) gather_not_made(study);
  if (options.work != StudyWork::gathering) compute(study, part_of(items, options.shard, options.shards));
  if (options.work == StudyWork::everything || options.work == StudyWork::gathering)
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
