#pragma once

#include "engine/ensemble/numbers.hpp"
#include "engine/ensemble/part.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace rift::ensemble {

/// Where beams break by themselves: what is left of a part's beams, the energies above which its walk notes
/// them, and those it has noted. A place is that of a beam among the part's intact ones, halo beams first.
template <class Real>
class WatchedBeams {
 public:
  /// @param[in] damageable_of  of each place, its beam's place among the damageable beams, or -1
  /// @param[in] damageable     how many of those there are
  /// @param[in] group_size     beams side by side where there is one lane, else 0
  void make(std::vector<std::int32_t> damageable_of, std::size_t damageable, int lanes,
            std::size_t group_size) {
    k_of_ = std::move(damageable_of), lanes_ = lanes, group_size_ = group_size;
    place_of_.assign(damageable, -1);
    for (std::size_t place = 0; place < k_of_.size(); ++place)
      if (k_of_[place] >= 0) place_of_[k_of_[place]] = static_cast<std::int32_t>(place);
    const std::size_t rows =
        group_size ? std::max<std::size_t>(1, (k_of_.size() + group_size - 1) / group_size) : k_of_.size();
    // Places beyond the last beam are never above their thresholds.
    above_.assign(rows * std::max<std::size_t>(group_size, lanes), std::numeric_limits<Real>::infinity());
    if (!group_size) left_.assign(rows * lanes, Real(1));
    noted_.resize(rows);
  }

  /// The place of a damageable beam, or -1 where it is another part's.
  std::int32_t place_of(int k) const { return place_of_[k]; }

  void set(std::int32_t place, int lane, double left, double above) {
    above_[static_cast<std::size_t>(place) * lanes_ + lane] = static_cast<Real>(above);
    if (!left_.empty()) left_[static_cast<std::size_t>(place) * lanes_ + lane] = static_cast<Real>(left);
  }

  /// Appends the damageable beams of a lane that the walk has noted last. Halo beams, which stand before
  /// `own`, are their first element's part's.
  void add_noted(int lane, std::size_t own, std::vector<int>& k) const {
    for (std::int32_t n = 0; n < count_; ++n) {
      const auto [place, which] = noted_[n];
      if (!group_size_) {
        if ((which >> lane & 1U) != 0) k.push_back(k_of_[place]);
        continue;
      }
      for (std::size_t beam = 0; beam < group_size_; ++beam)
        if (const std::size_t at = place * group_size_ + beam; (which >> beam & 1U) != 0 && at >= own)
          k.push_back(k_of_[at]);
    }
  }

  void show(PartView<Real>& view) {
    view.left = left_.data(), view.watch_above = above_.data();
    view.watched = noted_.data(), view.watched_count = &count_;
  }

 private:
  std::vector<std::int32_t> k_of_, place_of_;
  int lanes_ = 1;
  std::size_t group_size_ = 0;
  AlignedVector<Real> left_, above_;
  std::vector<WatchedRow> noted_;
  std::int32_t count_ = 0;
};

}  // namespace rift::ensemble
