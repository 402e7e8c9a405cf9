#include "engine/results/series.hpp"
#include "engine/scene/derived.hpp"
#include "engine/simulation/kept_march.hpp"
#include "engine/simulation/summary.hpp"
#include "engine/study/store.hpp"
#include "engine/study/under_way.hpp"

#include <algorithm>
#include <sstream>
#include <system_error>

namespace rift::study {
namespace {

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

std::filesystem::path passes_folder(const UnderWay& study) { return study.options.folder / "passes"; }

}  // namespace

void march_pass(UnderWay& study, const simulation::Prepared& prepared, std::span<const StudyItem> pass,
                base::Clock::time_point started) {
  const std::string identity = pass_identity(pass);
  simulation::MarchKeeping keeping{
      .folder = passes_folder(study) / hash_text(identity), .identity = identity, .result_too = false};
  std::string note;
  const std::optional<simulation::Resumption> from = simulation::kept_march(keeping, note);
  keeping.taken_before_s =
      base::seconds_since(started) + (from ? simulation::taken_s(from->checkpoint) : 0.0);
  const auto marching = base::Clock::now();
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

std::vector<PassUnderWay> passes_under_way(const UnderWay& study, std::span<const StudyItem> missing) {
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

void forget_passes_that_are_done(const UnderWay& study) {
  for (const PassUnderWay& pass : passes_under_way(study, {})) simulation::forget_march(pass.folder);
  std::error_code none;  // a folder that holds other passes stays
  std::filesystem::remove(passes_folder(study), none);
}

}  // namespace rift::study
