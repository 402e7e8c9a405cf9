#pragma once

#include <cmath>
#include <limits>
#include <vector>

namespace rift::base {

/// Mean of numbers; NaN for none.
inline double mean_of(const std::vector<double>& numbers) {
  if (numbers.empty()) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0.0;
  for (const double n : numbers) sum += n;
  return sum / static_cast<double>(numbers.size());
}

/// Standard deviation of a sample of numbers; 0 for one, NaN for none.
inline double deviation_of(const std::vector<double>& numbers) {
  const double mean = mean_of(numbers);
  if (numbers.size() < 2) return numbers.empty() ? mean : 0.0;
  double sum = 0.0;
  for (const double n : numbers) sum += (n - mean) * (n - mean);
  return std::sqrt(sum / static_cast<double>(numbers.size() - 1));
}

}  // namespace rift::base
