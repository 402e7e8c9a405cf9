#include "engine/calibration/side_by_side.hpp"

#include "engine/base/process_limits.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <numeric>
#include <optional>
#include <thread>

namespace rift::calibration {
namespace {

/// What is still to do, and how far what has begun has come.
class Bench {
 public:
  Bench(const std::vector<double>& work, const CalibrationProgress& progress)
      : work_(work), progress_(progress), order_(work.size()), done_(work.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    std::ranges::stable_sort(order_, std::greater{}, [&](std::size_t k) { return work[k]; });
  }
  std::optional<std::size_t> take() {
    const std::lock_guard lock(mutex_);
    if (failure_ || next_ == order_.size()) return {};
    return order_[next_++];
  }
  bool tell(std::size_t k, double fraction) {
    const std::lock_guard lock(mutex_);
    done_[k] = fraction * work_[k];
    const double all = std::accumulate(work_.begin(), work_.end(), 0.0);
    return !failure_ && (!progress_ || progress_(std::accumulate(done_.begin(), done_.end(), 0.0) / all));
  }
  void fail(const std::exception_ptr& failure) {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = failure;
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  const std::vector<double>& work_;
  const CalibrationProgress& progress_;
  std::vector<std::size_t> order_;
  std::vector<double> done_;
  std::mutex mutex_;
  std::size_t next_ = 0;
  std::exception_ptr failure_;
};

}  // namespace

void side_by_side(const std::vector<double>& work, int threads, const CalibrationProgress& progress,
                  const std::function<void(std::size_t, int, const CalibrationProgress&)>& task) {
  Bench bench(work, progress);
  const auto work_off = [&](int thread) {
    while (const auto k = bench.take()) try {
        task(*k, thread, [&](double done) { return bench.tell(*k, done); });
      } catch (...) {
        bench.fail(std::current_exception());
      }
  };
  {
    std::vector<std::jthread> helpers;
    for (int thread = 1; thread < base::threads_or_all_cpus(threads); ++thread)
      helpers.emplace_back(work_off, thread);
    work_off(0);
  }
  bench.rethrow();
}

}  // namespace rift::calibration
