#pragma once

#include <barrier>
#include <functional>
#include <thread>
#include <vector>

namespace rift {

/// Threads that share out numbered tasks: each takes a contiguous run of them,
/// the caller the first. Who does a task does not show in the result as long as
/// every task writes to places of its own.
class Crew {
 public:
  /// @param[in] hands  threads, the caller's among them; 0 for one per core
  /// @param[in] most   more hands than this would find nothing to do
  Crew(int hands, int most);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  /// Calls task(k) for k in [0, tasks) and returns when all are done. Tasks
  /// must not throw.
  void run(int tasks, const std::function<void(int)>& task);

 private:
  void work(int hand) const;

  const int hands_;
  int tasks_ = 0;
  const std::function<void(int)>* task_ = nullptr;  // none: the helpers go home
  std::barrier<> start_, end_;
  std::vector<std::jthread> helpers_;
};

}  // namespace rift
