#pragma once

#include "engine/base/cache.hpp"
#include "engine/results/lane_summary.hpp"
#include "engine/scene/preset.hpp"
#include "engine/simulation/march.hpp"
#include "engine/simulation/record.hpp"
#include "engine/study/not_made.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Studies: many scenarios, each computed once, kept as soon as it is there.
namespace rift::study {

/// The axes that a study names, with the values of a scenario as text.
using AxisTexts = std::vector<std::pair<std::string, std::string>>;

/// The summary of a scenario, its axes with the texts of their values, its place in the study, and the file
/// of its series in the folder.
struct SummaryRow : results::LaneSummary {
  AxisTexts axes;
  int row = 0;
  std::string series;
};

/// Seconds that the scenario marched: its crack, and its ramp where it has one.
double marching_time(const SummaryRow& row);

/// The row as tables and --json have it: the summary's columns, "axes": {name: text}, "row" and "series".
nlohmann::ordered_json to_json(const SummaryRow& row);

/// The rows of a study in its order; none where a scenario is not computed yet, which is null in JSON.
using StudyRows = std::vector<std::optional<SummaryRow>>;
nlohmann::ordered_json to_json(const StudyRows& rows);

/// What a call does of a study that several calls may work on.
enum class StudyWork {
  everything,   // computes what is missing; waits for scenarios that other calls compute
  share,        // one of several tasks: some scenarios of a group at a time, so that the others find some
  preparation,  // packs and pre-stresses each specimen, for the cache
  gathering     // computes nothing
};

struct StudyOptions {
  std::filesystem::path folder;  // of the study; made or continued
  int threads = 0;               // 0: one per available CPU
  bool shared = false;           // several studies lie in the folder, each finds its scenarios: no study.json
  double checkpoint_s = 30;      // between two checkpoints of a pass
  int shard = 1, shards = 1;  // this call computes the i-th part of n and gathers what is there of the others
  StudyWork work = StudyWork::everything;
  int tasks = 1;           // that share the work, this one included
  std::string label = {};  // of this call among those that share the study's folder, such as a job's number
};

struct StudyObserver {
  std::function<bool(std::string_view stage, double done)> progress;  // of the whole study; false stops it
  std::function<void(const SummaryRow&, int done, int of)>
      finished;  // each scenario, as soon as it is computed or found
};

struct StudyResult {
  StudyRows rows;
  std::vector<NotMade> not_made;
  simulation::Outcome outcome = simulation::Outcome::finished;
  int computed = 0, found = 0;
  int elsewhere = 0;  // scenarios that other calls are computing as this one ends
  double wall_s = 0;
  std::int64_t lane_steps = 0, lane_room = 0;  // of the scenarios computed, as of RunResult
};

/// Computes the scenarios of a preset's study that the folder does not hold yet and that no other process, on
/// this node or another one, has taken on: each keeps a claim in claims/ for what it is at. Each result is
/// bit for bit that of the scenario run by itself, but for wall times, lanes and threads, and is on the disk
/// as soon as the scenario ends. Of a pass under way a checkpoint is kept in passes/ now and then and at a
/// stop, with which the next call goes on. Scenarios that differ only in what lanes may differ in share
/// specimen, lattice and pre-stress, and march side by side where their steps are equal. Damaged files are
/// noted in cache.notes and computed again. Scenarios that cannot be run stand in `not_made` and in
/// not_made/, and the others are computed all the same. Throws FolderExists (open_study), InputError where
/// none can be run, and WorldError.
StudyResult run_study(const scene::Preset& preset, const StudyOptions& options, base::Cache& cache,
                      const simulation::BuildInfo& build, const StudyObserver& observer);

}  // namespace rift::study
