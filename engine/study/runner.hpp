#pragma once

#include "engine/base/cache.hpp"
#include "engine/simulation/march.hpp"
#include "engine/simulation/record.hpp"
#include "engine/study/identity.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

/// Studies: many scenarios, each computed once, kept as soon as it is there.
namespace rift::study {

/// One object of summary.json's "scenarios", plus "axes": {name: text}, its place "row" in the study, and
/// "series": the file of its series in the folder.
using SummaryRow = nlohmann::ordered_json;

/// A number of a row, NaN where it is null or missing.
double number_in(const SummaryRow& row, const char* name);

/// A text of a row, empty where it is null or missing.
std::string text_in(const SummaryRow& row, const char* name);

/// The text of an axis of a row, or `absent` where the study does not name it.
std::string axis_in(const SummaryRow& row, const char* axis, const std::string& absent);

struct StudyOptions {
  std::filesystem::path folder;  // of the study; made or continued
  int threads = 0;               // 0: one per available CPU
  bool shared = false;           // several studies lie in the folder, each finds its scenarios: no study.json
  double checkpoint_s = 30;      // between two checkpoints of a pass
  int shard = 1, shards = 1;  // this call computes the i-th part of n and gathers what is there of the others
};

struct StudyObserver {
  std::function<bool(std::string_view stage, double done)> progress;  // of the whole study; false stops it
  std::function<void(const SummaryRow&, int done, int of)>
      finished;  // each scenario, as soon as it is computed or found
};

struct StudyResult {
  std::vector<SummaryRow> rows;  // in the order of preset.study; null where not computed yet
  simulation::Outcome outcome = simulation::Outcome::finished;
  int computed = 0, found = 0;
  double wall_s = 0;
};

/// Computes the scenarios of a preset's study that the folder does not hold yet. Each result is bit for bit
/// that of the scenario run by itself, but for wall times, lanes and threads, and is on the disk as soon as
/// the scenario ends. Of a pass under way a checkpoint is kept in passes/ now and then and at a stop, with
/// which the next call goes on. Scenarios that differ only in what lanes may differ in share specimen,
/// lattice and pre-stress, and march side by side where their steps are equal. Damaged files are noted in
/// cache.notes and computed again. Throws FolderExists (open_study), InputError with all scenarios that
/// cannot be run, after the others, and WorldError.
StudyResult run_study(const scene::Preset& preset, const StudyOptions& options, base::Cache& cache,
                      const simulation::BuildInfo& build, const StudyObserver& observer);

}  // namespace rift::study
