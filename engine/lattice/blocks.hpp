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
  /// @param[in] threads  0 for one per core; fewer than asked for where there are few elements, and several
  ///                     shares a thread, for others to take over what one has not begun
  Blocks(int elements, int threads)
      : elements_(elements),
        sum_((elements + size - 1) / size),
        pool_(threads, most_shares()),
        shares_(pool_.threads() == 1 ? 1 : std::min(most_shares(), shares_a_thread * pool_.threads())) {
    for (int s = 1; s <= shares_; ++s) end_.push_back(std::min(elements_, size * first_block(s)));
  }

  int elements() const { return elements_; }
  int shares() const { return shares_; }
  /// Where each share ends, ascending.
  const std::vector<int>& ends() const { return end_; }

  /// Calls task(s) for each share, by all threads.
  template <class Task>
  void each_share(const Task& task) {
    pool_.run(shares_, task);
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
  /// Sum of part(begin, end) over the blocks, while one thread begins with something else.
  template <class Beside, class Part>
  double sum_beside(const Beside& beside, const Part& part) {
    pool_.run(1 + shares_, [&](int task) {
      if (task == 0) return beside();
      blocks_of(task - 1, [&](int block, int begin, int end) { sum_[block] = part(begin, end); });
    });
    return std::accumulate(sum_.begin(), sum_.end(), 0.0);
  }

 private:
  static constexpr int size = 256, fewest_a_share = 4, shares_a_thread = 4;
  int most_shares() const { return std::max(1, static_cast<int>(sum_.size()) / fewest_a_share); }
  int first_block(int share) const {
    return static_cast<int>(static_cast<long>(sum_.size()) * share / shares_);
  }
  template <class Task>
  void blocks_of(int share, const Task& task) const {
    for (int block = first_block(share); block < first_block(share + 1); ++block)
      task(block, size * block, std::min(elements_, size * (block + 1)));
  }

  int elements_;
  std::vector<double> sum_;  // of each block
  base::ThreadPool pool_;
  int shares_;
  std::vector<int> end_;
};

}  // namespace rift::lattice
