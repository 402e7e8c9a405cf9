#pragma once

#include "engine/base/cache.hpp"
#include "engine/base/process_limits.hpp"
#include "engine/calibration/side_by_side.hpp"

namespace rift::calibration {

/// The result of each test, several at once, the largest packing first; each thread has a cache of its own,
/// whose notes are gathered in `cache`.
/// @param[in] result_of  (test, cache, tell) -> result; tell as in side_by_side()
template <class Test, class ResultOf>
auto each_specimen(const std::vector<Test>& tests, base::Cache& cache, const CalibrationProgress& progress,
                   int threads, const ResultOf& result_of) {
  std::vector<double> work;
  for (const Test& test : tests) work.push_back(test.packing.elements);
  std::vector<base::Cache> caches(base::threads_or_all_cpus(threads), base::Cache{cache.folder, {}});
  std::vector<decltype(result_of(tests.front(), cache, progress))> results(tests.size());
  side_by_side(work, threads, progress, [&](std::size_t k, int thread, const CalibrationProgress& tell) {
    results[k] = result_of(tests[k], caches[thread], tell);
  });
  for (const base::Cache& used : caches)
    cache.notes.insert(cache.notes.end(), used.notes.begin(), used.notes.end());
  return results;
}

}  // namespace rift::calibration
