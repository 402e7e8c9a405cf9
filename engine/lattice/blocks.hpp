#pragma once

#include "engine/base/thread_pool.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace rift::lattice {

/// Elements in blocks of a fixed size, whole blocks shared out among threads. Sums over elements are added up
/// block by block, so that their bits do not depend on the number of threads.
class Blocks {
 public:
  /// @param[in] threads  0 for one per core; fewer than asked for where there are few elements
  Blocks(int elements, int threads)
      : elements_(elements),
        sum_((elements + size - 1) / size),
        pool_(threads, std::max(1, static_cast<int>(sum_.size()) / fewest_a_thread)) {
    for (int s = 1; s <= shares(); ++s) end_.push_back(std::min(elements_, size * first_block(s)));
  }

  int elements() const { return elements_; }
  int shares() const { return pool_.threads(); }
  /// Where each share ends, ascending.
  const std::vector<int>& ends() const { return end_; }

  /// Calls task(s) for each share, by threads of their own.
  template <class Task>
  void each_share(const Task& task) {
    pool_.run(shares(), task);
  }
  /// Calls task(begin, end) for the elements of each block.
  template <class Task>
  void each_block(const Task& task) {
    each_share([&](int s) { blocks_of(s, [&](int, int begin, int end) { task(begin, end); }); });
  }
  /// Sum of part(begin, end) over the blocks, after first(s) of the share that they belong to.
  template <class First, class Part>
  double sum(const First& first, const Part& part) {
    each_share([&](int s) {
      first(s);
      blocks_of(s, [&](int block, int begin, int end) { sum_[block] = part(begin, end); });
    });
    return std::accumulate(sum_.begin(), sum_.end(), 0.0);
  }
  template <class Part>
  double sum(const Part& part) {
    return sum([](int) {}, part);
  }
  /// Sum of part(begin, end) over the blocks, while the first thread does something else beforehand.
  template <class Beside, class Part>
  double sum_beside(const Beside& beside, const Part& part) {
    const int others = std::max(1, shares() - 1);
    each_share([&](int s) {
      if (s == 0) beside();
      if (s == 0 && shares() > 1) return;
      const int k = std::max(0, s - 1), count = static_cast<int>(sum_.size());
      for (int block = count * k / others; block < count * (k + 1) / others; ++block)
        sum_[block] = part(size * block, std::min(elements_, size * (block + 1)));
    });
    return std::accumulate(sum_.begin(), sum_.end(), 0.0);
  }

 private:
  static constexpr int size = 256, fewest_a_thread = 4;
  int first_block(int share) const {
    return static_cast<int>(static_cast<long>(sum_.size()) * share / shares());
  }
  template <class Task>
  void blocks_of(int share, const Task& task) const {
    for (int block = first_block(share); block < first_block(share + 1); ++block)
      task(block, size * block, std::min(elements_, size * (block + 1)));
  }

  int elements_;
  std::vector<double> sum_;  // of each block
  base::ThreadPool pool_;
  std::vector<int> end_;
};

}  // namespace rift::lattice
