#include "studio/workbench/dry_run_thread.hpp"

#include "engine/base/interrupted.hpp"
#include "studio/text/dry_run.hpp"

#include <fmt/format.h>

namespace rift::studio {

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
