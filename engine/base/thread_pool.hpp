#pragma once

#include <atomic>
#include <thread>
#include <vector>

namespace rift::base {

/// Threads that share out numbered tasks: each takes a contiguous run of them, the caller the first. Who does
/// a task does not show in the result as long as every task writes to places of its own. Between two runs the
/// helpers spin for some fifty microseconds, then sleep.
class ThreadPool {
 public:
  /// @param[in] threads  the caller's among them, at most one for each CPU that the process may use; 0 for as
  ///                     many as that
  /// @param[in] most     more threads than this would find nothing to do
  ThreadPool(int threads, int most);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  int threads() const { return threads_; }

  /// Calls task(k) for k in [0, tasks) and returns when all are done. Tasks must not throw. Allocates
  /// nothing.
  template <class Task>
  void run(int tasks, const Task& task) {
    dispatch(tasks, &task, [](const void* t, int k) { (*static_cast<const Task*>(t))(k); });
  }

 private:
  using Call = void (*)(const void* task, int k);
  void dispatch(int tasks, const void* task, Call call);
  void help(int thread);
  void work(int thread) const;

  const int threads_;
  int tasks_ = 0;
  const void* task_ = nullptr;
  Call call_ = nullptr;              // none: the helpers end
  std::atomic<unsigned> round_ = 0;  // rises when there is work
  std::atomic<int> busy_ = 0;        // helpers still at it
  std::vector<std::jthread> helpers_;
};

}  // namespace rift::base
