#include "studio/commands/planned.hpp"

#include "engine/base/process_limits.hpp"
#include "engine/calibration/calibrate.hpp"
#include "engine/experiment/plan.hpp"
#include "engine/study/plan.hpp"
#include "engine/study/resources.hpp"
#include "engine/study/store.hpp"
#include "studio/commands/chosen_claims.hpp"
#include "studio/commands/common.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace rift::studio {
namespace fs = std::filesystem;

fs::path study_folder(const std::string& preset) { return fs::path("studies") / fs::path(preset).stem(); }

void check_holds_study(const scene::Preset& preset) {
  if (!preset.study.empty()) return;
  const std::string what =
      preset.lanes.empty()
          ? "holds no [study]: write a table [study] with a list of values per axis, such as crack_velocity "
            "= [\"0.3 c_r\", \"0.5 c_r\"] and seed = [1, 2]; 'rift run' runs one scene"
          : "holds lanes and no [study]: 'rift run' runs them, [[study.rows]] makes a study of them";
  refuse(preset.name, what);
}

void check_one_history(const scene::Preset& preset) {
  if (!preset.study.empty() || !preset.lanes.empty())
    refuse(preset.name, "holds lanes or a study: 'rift experiment' is of one measured crack");
  if (preset.scene.crack.history.empty())
    refuse(preset.name,
           "has no crack.history: 'rift experiment' needs a measured one, such as --set "
           "crack.history=measured.csv");
  if (preset.scene.crack.tips != 1) refuse(preset.name, "has two tips: 'rift experiment' reads one");
}

void add_experiment_parts(CLI::App& command, experiment::ExperimentOptions& parts) {
  command.add_option("--resamples", parts.resamples, "Histories drawn anew from their noise, for the band")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  command.add_option("--specimens", parts.specimens, "Packings, for the band")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
}

namespace {

double marching_seconds(const std::vector<study::StudyItem>& items) {
  double cost = 0.0;
  for (const study::StudyItem& item : items) cost += item.cost;
  return cost / study::assumed_beam_steps_per_s;
}

double preparing_seconds(const scene::Scene& scene) {
  return study::estimated_preparation(scene) / study::assumed_beam_steps_per_s;
}

/// What is common to all that march: specimens, memory, disk.
void add_resources(PlannedWork& work, const std::vector<study::StudyItem>& items) {
  std::set<int> specimens;
  for (const study::StudyItem& item : items) {
    specimens.insert(item.specimen);
    work.memory_bytes = std::max(work.memory_bytes, study::expected_memory_bytes(item.scene));
    work.disk_bytes += study::disk_bytes_of_scenario(item.scene);
    work.scenes.push_back(item.scene);
  }
  work.specimens = static_cast<int>(specimens.size());
}

/// Those of a study that its folder does not hold yet, and what they take.
void add_missing(PlannedWork& work, std::vector<study::StudyItem> items, const fs::path& folder) {
  std::erase_if(
      items, [&](const study::StudyItem& item) { return fs::exists(study::result_file(folder, item.key)); });
  work.missing = static_cast<int>(items.size());
  work.seconds = study::estimated_seconds(items);
}

/// The stages of a calibration, each specimen on a thread of its own.
void add_calibration(PlannedWork& work, const scene::Scene& scene, bool study, int threads) {
  std::vector<PlannedPart> stages;
  int most = 0;
  for (const calibration::PlannedSpecimen& specimen : calibration::planned_specimens(scene, study)) {
    if (stages.empty() || stages.back().name != specimen.stage) stages.push_back({.name = specimen.stage});
    scene::Scene one = scene;
    one.specimen.elements = specimen.elements;
    const double packing = specimen.packed_before ? 0.0 : study::packing_share,
                 solving = (1.0 - study::packing_share) * specimen.solutions;
    stages.back().count += 1;
    stages.back().seconds += (packing + solving) * preparing_seconds(one);
    most = std::max(most, specimen.elements);
  }
  scene::Scene largest = scene;
  largest.specimen.elements = most;
  const int at_once = base::threads_or_all_cpus(threads);
  work.memory_bytes = std::max(work.memory_bytes, at_once * study::expected_memory_bytes(largest));
  for (PlannedPart& stage : stages) {
    stage.seconds /= std::min(at_once, stage.count);
    work.seconds += stage.seconds;
    work.parts.push_back(std::move(stage));
  }
}

}  // namespace

PlannedWork planned_study(const scene::Preset& preset, const std::string& command, const fs::path& folder) {
  check_holds_study(preset);
  const std::vector<study::StudyItem> items = study::plan_study(preset, RIFT_VERSION);
  PlannedWork work{.command = command, .count = static_cast<int>(items.size())};
  add_resources(work, items);
  add_missing(work, items, folder);
  if (work.seconds > long_work_s) work.to_start = "--yes, or --budget TIME which does what fits";
  return work;
}

PlannedWork planned_experiment(const scene::Preset& preset, const std::string& command,
                               const experiment::ExperimentOptions& options, const MeasuredCrack& crack) {
  check_one_history(preset);
  PlannedWork work{.command = fmt::format("{} --resamples {} --specimens {}", command, options.resamples,
                                          options.specimens)};
  const std::vector<study::StudyItem> alone = study::plan_scenes({preset.scene}, RIFT_VERSION);
  const double pace = crack.seconds / marching_seconds(alone);  // over that of the estimates
  work.steps_factor = crack.steps / static_cast<double>(study::estimated_steps(preset.scene).steps);
  std::vector<scene::Scene> scenes;
  const double preparing = preparing_seconds(preset.scene),
               solving = (1.0 - study::packing_share) * preparing;
  for (const experiment::PlannedPart& part : experiment::planned_parts(preset, options)) {
    const bool solved = part.scenes.empty();
    PlannedPart& told = work.parts.emplace_back(
        PlannedPart{.name = part.name,
                    .count = solved ? part.solutions : static_cast<int>(part.scenes.size()),
                    .counted = solved ? "static solutions" : ""});
    told.seconds =
        pace * marching_seconds(study::plan_scenes(part.scenes, RIFT_VERSION)) + part.solutions * solving;
    scenes.insert(scenes.end(), part.scenes.begin(), part.scenes.end());
    work.seconds += told.seconds;
  }
  work.count = work.missing = static_cast<int>(scenes.size());
  add_resources(work, study::plan_scenes(scenes, RIFT_VERSION));
  work.seconds += options.specimens * preparing;
  work.disk_bytes += study::expected_disk_bytes({&preset.scene, 1});
  return work;
}

PlannedWork planned_calibration(const scene::Scene& scene, const std::string& command, int threads) {
  PlannedWork work{.command = command + " --out FOLDER", .counted = "pressings"};
  add_calibration(work, scene, true, threads);
  for (const PlannedPart& part : work.parts) work.count += part.count;
  work.missing = work.count;
  return work;
}

PlannedWork planned_reproduction(const std::vector<std::string>& names, claims::Effort effort, int threads) {
  const std::vector<const claims::Claim*> chosen = chosen_claims(names);
  const claims::PaperStudy paper = paper_study(chosen, effort);
  PlannedWork work{.command = fmt::format("rift reproduce {}{}", fmt::join(names, " "),
                                          effort == claims::Effort::quick ? " --quick" : ""),
                   .count = static_cast<int>(paper.preset.study.size())};
  std::vector<study::StudyItem> items;
  if (work.count > 0) items = study::plan_study(paper.preset, RIFT_VERSION);
  add_resources(work, items);
  add_missing(work, items, reproduction_folder);
  for (const claims::Claim* claim : chosen) {
    if (!claim->judge) continue;
    if (claim->calibration) {
      add_calibration(work, calibration_scene(*claim, effort), true, threads);
      continue;
    }
    std::set<int> rows;
    for (const std::string& name : claim->needs)
      if (const auto of = paper.of.find(name); of != paper.of.end())
        rows.insert(of->second.begin(), of->second.end());
    std::vector<scene::Scene> scenes;
    for (const int row : rows) scenes.push_back(paper.preset.study[static_cast<std::size_t>(row)].scene);
    work.parts.push_back({claim->name, static_cast<int>(scenes.size()),
                          study::estimated_seconds(study::plan_scenes(scenes, RIFT_VERSION))});
  }
  return work;
}

}  // namespace rift::studio
