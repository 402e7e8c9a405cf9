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

/// Of each thread's share: few enough to cost nothing, enough for others to help.
constexpr int pieces_of_a_share = 8;

std::uint64_t packed(std::uint32_t round, int next, int end) {
  return std::uint64_t{round} << 32 | static_cast<std::uint64_t>(next) << 16 |
         static_cast<std::uint64_t>(end);
}

}  // namespace

ThreadPool::ThreadPool(int threads, int most) : threads_(count_threads(threads, most)), share_(threads_) {
  try {
    for (int thread = 1; thread < threads_; ++thread) helpers_.emplace_back([this, thread] { help(thread); });
  } catch (...) {  // the system has no more threads: those that were begun end
    end();
    throw;
  }
}

ThreadPool::~ThreadPool() { end(); }

void ThreadPool::end() {
  ends_.store(true, std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
}

void ThreadPool::help(int thread) {
  for (std::uint32_t round = 0;;) {
    await_change(round_, round);
    round = round_.load(std::memory_order_acquire);
    if (ends_.load(std::memory_order_relaxed)) return;
    work(thread, round);
  }
}

void ThreadPool::dispatch(int tasks, const void* task, Call call) {
  tasks_ = tasks, task_ = task, call_ = call;
  pieces_ = std::min(tasks, pieces_of_a_share * threads_);
  left_.store(pieces_, std::memory_order_relaxed);
  const std::uint32_t round = round_.load(std::memory_order_relaxed) + 1;
  for (int h = 0; h < threads_; ++h)
    share_[h].pieces.store(packed(round, pieces_ * h / threads_, pieces_ * (h + 1) / threads_),
                           std::memory_order_release);
  // Sequentially consistent, or the count of those who sleep may be read before it: one would miss the round.
  round_.store(round, std::memory_order_seq_cst);
  if (threads_ > 1) round_.notify_all();
  work(0, round);
  for (int left = left_.load(std::memory_order_acquire); left != 0;
       left = left_.load(std::memory_order_acquire))
    await_change(left_, left);
}

std::optional<int> ThreadPool::take_piece(Share& share, std::uint32_t round) {
  std::uint64_t word = share.pieces.load(std::memory_order_acquire);
  while (word >> 32 == round && (word >> 16 & 0xffff) < (word & 0xffff))
    if (share.pieces.compare_exchange_weak(word, word + (1U << 16), std::memory_order_acq_rel,
                                           std::memory_order_acquire))
      return static_cast<int>(word >> 16 & 0xffff);
  return std::nullopt;
}

void ThreadPool::work(int thread, std::uint32_t round) {
  for (int h = 0; h < threads_; ++h)
    while (const std::optional<int> piece = take_piece(share_[(thread + h) % threads_], round)) {
      const auto first = [&](int k) { return static_cast<int>(std::int64_t{tasks_} * k / pieces_); };
      for (int k = first(*piece); k < first(*piece + 1); ++k) call_(task_, k);
      if (left_.fetch_sub(1, std::memory_order_acq_rel) == 1) left_.notify_one();
    }
}

}  // namespace rift::base
