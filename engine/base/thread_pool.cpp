#include "engine/base/thread_pool.hpp"

#include "engine/base/process_limits.hpp"

#include <algorithm>
#include <cstdint>

namespace rift::base {
namespace {

/// Threads that share a CPU would only take turns, and who waits awake would keep the one that works from it.
int count_hands(int hands, int most) {
  const int cpus = available_cpus();
  return std::clamp(hands > 0 ? std::min(hands, cpus) : cpus, 1, std::max(1, most));
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

ThreadPool::ThreadPool(int hands, int most) : hands_(count_hands(hands, most)) {
  for (int hand = 1; hand < hands_; ++hand) helpers_.emplace_back([this, hand] { help(hand); });
}

ThreadPool::~ThreadPool() {
  call_ = nullptr;
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
}

void ThreadPool::help(int hand) {
  for (unsigned done = 0;; ++done) {
    await_change(round_, done);
    if (call_ == nullptr) return;
    work(hand);
    if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1) busy_.notify_one();
  }
}

void ThreadPool::dispatch(int tasks, const void* task, Call call) {
  tasks_ = tasks;
  task_ = task;
  call_ = call;
  if (hands_ > 1) {
    busy_.store(hands_ - 1, std::memory_order_relaxed);
    round_.fetch_add(1, std::memory_order_release);
    round_.notify_all();
  }
  work(0);
  if (hands_ == 1) return;
  for (int left = busy_.load(std::memory_order_acquire); left != 0;
       left = busy_.load(std::memory_order_acquire))
    await_change(busy_, left);
}

void ThreadPool::work(int hand) const {
  const auto share = [&](int h) { return static_cast<int>(std::int64_t{tasks_} * h / hands_); };
  for (int k = share(hand); k < share(hand + 1); ++k) call_(task_, k);
}

}  // namespace rift::base
