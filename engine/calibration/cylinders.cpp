#include "engine/calibration/cylinders.hpp"

#include "engine/base/interrupted.hpp"
#include "engine/base/process_limits.hpp"
#include "engine/calibration/calibrate.hpp"
#include "engine/calibration/pull.hpp"
#include "engine/lattice/statics.hpp"
#include "engine/packing/packing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <mutex>
#include <numeric>
#include <optional>
#include <thread>

namespace rift::calibration {
namespace {

/// What is still to do, and how far what has begun has come.
class TaskQueue {
 public:
  TaskQueue(const std::vector<double>& work, const base::ProgressCallback& progress)
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
  const base::ProgressCallback& progress_;
  std::vector<std::size_t> order_;
  std::vector<double> done_;
  std::mutex mutex_;
  std::size_t next_ = 0;
  std::exception_ptr failure_;
};

}  // namespace

void side_by_side(const std::vector<double>& work, int threads, const base::ProgressCallback& progress,
                  const std::function<void(std::size_t, int, const base::ProgressCallback&)>& task) {
  TaskQueue queue(work, progress);
  const auto work_off = [&](int thread) {
    while (const auto k = queue.take()) try {
        task(*k, thread, [&](double done) { return queue.tell(*k, done); });
      } catch (...) {
        queue.fail(std::current_exception());
      }
  };
  {
    std::vector<std::jthread> helpers;
    for (int thread = 1; thread < base::threads_or_all_cpus(threads); ++thread)
      helpers.emplace_back(work_off, thread);
    work_off(0);
  }
  queue.rethrow();
}

namespace {

std::string key_of(const CylinderTest& test) {
  constexpr int version = 2;
  std::string key = fmt::format("cylinder {} {} tolerance {:a}", version, packing::key_of(test.packing),
                                test.contact_tolerance);
  for (const BeamShape& b : test.beams)
    key += fmt::format(" beams {:a} {:a}", b.radius_ratio, b.poisson_ratio);
  return key;
}

/// What is remembered of a result: its own numbers, then three a response.
constexpr std::size_t numbers_before_responses = 4;

std::vector<double> numbers_of(const CylinderResult& r) {
  std::vector<double> numbers{r.coordination, r.core_coordination, r.solid_fraction,
                              static_cast<double>(r.rattlers)};
  for (const Response& x : r.responses)
    numbers.insert(numbers.end(), {x.young_over_micro, x.ends_over_micro, x.poisson_ratio});
  return numbers;
}

CylinderResult result_of(const CylinderTest& test, const std::vector<double>& n) {
  CylinderResult r{test.packing, n[0], n[1], n[2], static_cast<int>(n[3]), test.beams, {}};
  for (std::size_t k = numbers_before_responses; k < n.size(); k += 3)
    r.responses.push_back({n[k], n[k + 1], n[k + 2]});
  return r;
}

CylinderResult press(const CylinderTest& test, base::Cache& cache, const base::ProgressCallback& progress) {
  constexpr double share_of_packing = 0.6;
  bool found = false;
  const packing::Packing packing = packing::cached_packing(
      test.packing, cache, found, [&](double done) { return progress(share_of_packing * done); }, 1);
  const packing::Box& box = test.packing.box;
  const packing::Specimen specimen = packing::make_free_specimen(packing, box, test.contact_tolerance);
  CylinderResult result{test.packing,
                        specimen.packing.coordination,
                        core_coordination(packing, box, packing::contacts(packing, box, 1.0),
                                          4.0 * specimen.packing.mean_radius),
                        specimen.packing.solid_fraction,
                        specimen.rattlers,
                        test.beams,
                        {}};
  for (const BeamShape& beams : test.beams) {
    const lattice::Lattice lattice =
        lattice::make_lattice(specimen, {1.0, beams.poisson_ratio, beams.radius_ratio}, 1.0);
    lattice::FreeBody body(lattice, 1);
    const auto all = static_cast<double>(test.beams.size());
    const auto tell = [&, before = static_cast<double>(result.responses.size())](double done) {
      return progress(share_of_packing + (1.0 - share_of_packing) * (before + done) / all);
    };
    const Pulled pressed = pull(lattice, body, 1, -box.section(1), tell);
    result.responses.push_back({pressed.gauge_modulus, pressed.young_modulus,
                                0.5 * (pressed.poisson_ratio.x() + pressed.poisson_ratio.z())});
    base::tell_or_stop(tell, 1.0, "compressing cylinders");
  }
  return result;
}

CylinderResult pressed_or_recalled(const CylinderTest& test, base::Cache& cache,
                                   const base::ProgressCallback& tell) {
  const std::string key = key_of(test);
  if (const auto known = base::recall(cache, "cylinder", key);
      known && known->size() == numbers_before_responses + 3 * test.beams.size()) {
    if (!tell(1.0)) throw base::Interrupted("compressing cylinders");
    return result_of(test, *known);
  }
  CylinderResult result = press(test, cache, tell);
  base::remember(cache, "cylinder", key, numbers_of(result));
  return result;
}

}  // namespace

double core_coordination(const packing::Packing& packing, const packing::Box& box,
                         const std::vector<std::array<int, 2>>& contacts, double away) {
  std::vector<int> degree(packing.radius.size());
  for (const auto& [i, j] : contacts) ++degree[i], ++degree[j];
  double sum = 0.0, members = 0.0;
  for (std::size_t i = 0; i < degree.size(); ++i)
    if (packing::wall_push(box, packing.centre[i], away).isZero(0.0)) sum += degree[i], members += 1.0;
  if (members > 0.0) return sum / members;
  return 2.0 * static_cast<double>(contacts.size()) / static_cast<double>(degree.size());
}

std::vector<CylinderResult> press_cylinders(const std::vector<CylinderTest>& tests, base::Cache& cache,
                                            const base::ProgressCallback& progress, int threads) {
  return each_specimen(tests, cache, progress, threads, pressed_or_recalled);
}

}  // namespace rift::calibration
