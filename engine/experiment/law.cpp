#include "engine/experiment/law.hpp"

#include <algorithm>

namespace rift::experiment {
namespace {

constexpr double stretch = 0.02;  // of the velocity that is averaged over [c_R]
constexpr double least = 0.05;    // of the lowest rate, at rest: nothing breaks for nothing

using Law = std::vector<std::array<double, 3>>;

/// Points that are averaged.
struct Pool {
  double over_cr = 0, rate = 0, uncertainty = 0, count = 0;  // sums

  void take(const Pool& other) {
    over_cr += other.over_cr, rate += other.rate, uncertainty += other.uncertainty, count += other.count;
  }
  double mean() const { return rate / count; }
};

std::vector<Pool> by_velocity(std::vector<CriticalPoint> along) {
  std::stable_sort(along.begin(), along.end(),
                   [](const CriticalPoint& a, const CriticalPoint& b) { return a.over_cr < b.over_cr; });
  std::vector<Pool> pools;
  double from = 0.0;
  for (const CriticalPoint& p : along) {
    if (pools.empty() || p.over_cr > from + stretch) pools.emplace_back(), from = p.over_cr;
    pools.back().take({p.over_cr, p.as_paper, p.uncertainty, 1.0});
  }
  return pools;
}

/// Neighbours that fall become one, until nothing falls (pool adjacent violators).
void make_rise(std::vector<Pool>& pools) {
  for (std::size_t k = 1; k < pools.size();) {
    if (pools[k].mean() >= pools[k - 1].mean()) {
      ++k;
      continue;
    }
    pools[k - 1].take(pools[k]);
    pools.erase(pools.begin() + static_cast<std::ptrdiff_t>(k));
    k = std::max<std::size_t>(1, k - 1);
  }
}

/// With the mean slope down to rest and up to c_R.
void go_on_beyond(Law& law) {
  const auto [slow, low, of_low] = law.front();
  const auto [fast, high, of_high] = law.back();
  const double slope = fast > slow ? (high - low) / (fast - slow) : 0.0;
  if (slow > 0.0) law.insert(law.begin(), {0.0, std::max(least * low, low - slope * slow), of_low});
  if (fast < 1.0) law.push_back({1.0, high + slope * (1.0 - fast), of_high});
}

}  // namespace

Law law_of(const std::vector<CriticalPoint>& along) {
  std::vector<Pool> pools = by_velocity(along);
  make_rise(pools);
  Law law;
  law.reserve(pools.size() + 2);
  for (const Pool& p : pools) law.push_back({p.over_cr / p.count, p.mean(), p.uncertainty / p.count});
  go_on_beyond(law);
  return law;
}

}  // namespace rift::experiment
