#include "studio/workbench/dry_run_thread.hpp"

#include "engine/interrupted.hpp"
#include "studio/report/dry_run.hpp"

#include <fmt/format.h>

namespace rift::studio {

DryRunThread::~DryRunThread() { give_up(); }

void DryRunThread::give_up() {
  stop_ = true;
  if (thread_.joinable()) thread_.join();
  const std::lock_guard lock(mutex_);
  found_ = {};
}

void DryRunThread::wish(const Preset& preset) {
  give_up();
  stop_ = false;
  thread_ = std::jthread([this, preset] { work(preset); });
}

void DryRunThread::work(Preset preset) try {
  const std::vector<Scene> lanes = preset.lanes.empty() ? std::vector<Scene>{preset.scene} : preset.lanes;
  const Prepared prepared = prepare(preset, lanes, cache_, [this](std::string_view stage, double done) {
    const std::lock_guard lock(mutex_);
    found_.doing = fmt::format("{} {:.0f} %", stage, 100 * done);
    return !stop_;
  });
  if (stop_) return;
  auto rows = dry_run_rows(dry_run(prepared, threads_));
  const std::lock_guard lock(mutex_);
  found_ = {std::move(rows), {}, {}};
} catch (const Interrupted&) {
  // another one is wished for, or none
} catch (const std::exception& error) {
  const std::lock_guard lock(mutex_);
  found_ = {{}, {}, error.what()};
}

DryRunThread::Found DryRunThread::found() const {
  const std::lock_guard lock(mutex_);
  return found_;
}

}  // namespace rift::studio
