#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <thread>
#include <vector>

namespace rift::base {

/// Threads that share out numbered tasks: each takes the contiguous run of its share, the caller the first,
/// and whoever is done takes what others have not begun: beside other load a helper may get no CPU for longer
/// than its tasks last. Who does a task does not show in the result as long as every task writes to places of
/// its own. Between two runs the helpers spin for some fifty microseconds, then sleep.
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
  /// What nobody has taken of a thread's share: a round and the pieces [next, end) in one word, so that who
  /// wakes up late cannot take anything of another round.
  struct alignas(64) Share {
    std::atomic<std::uint64_t> pieces = 0;
  };
  void dispatch(int tasks, const void* task, Call call);
  /// Tells the helpers to end.
  void end();
  void help(int thread);
  void work(int thread, std::uint32_t round);
  static std::optional<int> take_piece(Share& share, std::uint32_t round);

  const int threads_;
  // Of a round; read by nobody but who has taken a piece of it.
  int tasks_ = 0, pieces_ = 0;
  const void* task_ = nullptr;
  Call call_ = nullptr;
  std::vector<Share> share_;
  std::atomic<int> left_ = 0;  // pieces that are not done
  std::atomic<bool> ends_ = false;
  std::atomic<std::uint32_t> round_ = 0;  // rises when there is work
  std::vector<std::jthread> helpers_;
};

}  // namespace rift::base
