#include "studio/workbench/dry_run_thread.hpp"

#include "engine/base/interrupted.hpp"
#include "engine/study/plan.hpp"
#include "studio/text/dry_run.hpp"
#include "studio/text/progress.hpp"

#include <fmt/format.h>

#include <set>

namespace rift::studio {
namespace {

/// What a study costs, estimated without any lattice: its scenarios in the passes in which they march.
DryRunThread::Rows cost_of_study(const scene::Preset& preset) {
  const std::vector<study::StudyItem> items = study::plan_study(preset, {});
  std::int64_t steps = 0;
  std::set<int> specimens;
  for (const study::StudyItem& item : items) {
    steps += study::estimated_steps(item.scene).steps;
    specimens.insert(item.specimen);
  }
  return {{"cost", fmt::format("about {} at 100 M beams/s, lanes side by side; {}",
                               duration_text(study::estimated_seconds(items)),
                               base::counted(static_cast<std::int64_t>(specimens.size()), "specimen"))},
          {"steps", fmt::format("about {} in all", steps)}};
}

}  // namespace

DryRunThread::~DryRunThread() { give_up(); }

void DryRunThread::give_up() {
  const std::lock_guard lock(mutex_);
  stop_ = true;
  found_ = {};
}

void DryRunThread::begin(const scene::Preset& preset) {
  if (thread_.joinable()) thread_.join();  // it has ended
  stop_ = false;
  busy_ = true;
  thread_ = std::jthread([this, preset] {
    work(preset);
    busy_ = false;
  });
}

void DryRunThread::publish(Found found) {
  const std::lock_guard lock(mutex_);
  if (!stop_) found_ = std::move(found);
}

void DryRunThread::work(const scene::Preset& preset) try {
  if (!preset.study.empty()) return publish({cost_of_study(preset), {}, {}});
  const std::vector<scene::Scene> lanes =
      preset.lanes.empty() ? std::vector<scene::Scene>{preset.scene} : preset.lanes;
  const simulation::Prepared prepared =
      simulation::prepare(preset, lanes, cache_, [this](std::string_view stage, double done) {
        publish({{}, fmt::format("{} {:.0f} %", stage, 100 * done), {}});
        return !stop_;
      });
  if (!stop_) publish({dry_run_rows(dry_run(prepared, threads_)), {}, {}});
} catch (const base::Interrupted&) {
  // another one is asked for, or none
} catch (const std::exception& error) {
  publish({{}, {}, error.what()});
}

DryRunThread::Found DryRunThread::found() const {
  const std::lock_guard lock(mutex_);
  return found_;
}

}  // namespace rift::studio
