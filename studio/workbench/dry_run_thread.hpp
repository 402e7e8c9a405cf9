#pragma once

#include "engine/base/cache.hpp"
#include "engine/scene/preset.hpp"

#include <atomic>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace rift::studio {

/// Dry runs in the background: what follows from the preset that was asked for last.
class DryRunThread {
 public:
  using Rows = std::vector<std::pair<std::string, std::string>>;

  DryRunThread(base::Cache cache, int threads) : cache_(std::move(cache)), threads_(threads) {}
  /// Gives up the one under way and waits for its end.
  ~DryRunThread();
  DryRunThread(const DryRunThread&) = delete;
  DryRunThread& operator=(const DryRunThread&) = delete;

  /// Begins one; none may be under way. @param preset  without issues
  void begin(const scene::Preset& preset);
  /// The one under way counts no more; it ends soon, and nobody waits for it: a pre-stress cannot be left
  /// halfway.
  void give_up();
  [[nodiscard]] bool busy() const { return busy_; }

  struct Found {
    Rows rows;            // empty as long as it is under way
    std::string doing;    // "packing 40 %"
    std::string trouble;  // why there are none
  };
  [[nodiscard]] Found found() const;

 private:
  void work(const scene::Preset& preset);
  void publish(Found found);

  base::Cache cache_;
  int threads_;
  std::atomic<bool> stop_ = false, busy_ = false;
  mutable std::mutex mutex_;
  Found found_;
  std::jthread thread_;
};

}  // namespace rift::studio
