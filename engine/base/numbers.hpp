#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <span>

namespace rift::base {

/// Mean of numbers; NaN of none.
double mean_of(std::span<const double> numbers);

/// Standard deviation of which the numbers are a sample, with n - 1; NaN of fewer than two.
double deviation_of(std::span<const double> numbers);

/// Where a number lies between the rows of a table: x = x[k-1] + part (x[k] - x[k-1]).
struct Interval {
  std::size_t k = 1;
  double part = 0;  // below 0 before the first row, above 1 behind the last
};

/// @param[in] rows  two at least, their x ascending;  @param[in] x_of  of a row. Cost O(log rows).
template <class Rows, class X = std::identity>
Interval interval_at(const Rows& rows, double x, const X& x_of = {}) {
  const auto after = std::partition_point(std::next(std::begin(rows)), std::prev(std::end(rows)),
                                          [&](const auto& row) { return std::invoke(x_of, row) < x; });
  const double from = std::invoke(x_of, *std::prev(after)), to = std::invoke(x_of, *after);
  return {static_cast<std::size_t>(after - std::begin(rows)), (x - from) / (to - from)};
}

}  // namespace rift::base
