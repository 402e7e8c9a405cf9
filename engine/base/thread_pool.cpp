#include "engine/base/thread_pool.hpp"

#include "engine/base/process_limits.hpp"

#include <algorithm>
#include <cstdint>

namespace rift::base {
namespace {

/// Threads that share a CPU would only take turns, and who waits awake would keep the one that works from it.
int count_threads(int threads, int most) {
  const int cpus = available_cpus();
  return std::clamp(threads > 0 ? std::min(threads, cpus) : cpus, 1, std::max(1, most));
}

inline void breathe() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

/// Waits until `value` is no longer `old`: awake for a while, since work mostly comes soon, then asleep.
template <class T>
void await_change(const std::atomic<T>& value, T old) {
  constexpr int patience = 2000;
  for (int k = 0; k < patience; ++k) {
    if (value.load(std::memory_order_acquire) != old) return;
    breathe();
  }
  value.wait(old, std::memory_order_acquire);
}

}  // namespace

ThreadPool::ThreadPool(int threads, int most) : threads_(count_threads(threads, most)) {
  for (int thread = 1; thread < threads_; ++thread) helpers_.emplace_back([this, thread] { help(thread); });
}

ThreadPool::~ThreadPool() {
  call_ = nullptr;
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
}

void ThreadPool::help(int thread) {
  for (unsigned done = 0;; ++done) {
    await_change(round_, done);
    if (call_ == nullptr) return;
    work(thread);
    if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1) busy_.notify_one();
  }
}

void ThreadPool::dispatch(int tasks, const void* task, Call call) {
  tasks_ = tasks;
  task_ = task;
  call_ = call;
  if (threads_ > 1) {
    busy_.store(threads_ - 1, std::memory_order_relaxed);
    round_.fetch_add(1, std::memory_order_release);
    round_.notify_all();
  }
  work(0);
  if (threads_ == 1) return;
  for (int left = busy_.load(std::memory_order_acquire); left != 0;
       left = busy_.load(std::memory_order_acquire))
    await_change(busy_, left);
}

void ThreadPool::work(int thread) const {
  const auto share = [&](int h) { return static_cast<int>(std::int64_t{tasks_} * h / threads_); };
  for (int k = share(thread); k < share(thread + 1); ++k) call_(task_, k);
}

}  // namespace rift::base
