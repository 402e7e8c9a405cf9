#include "engine/base/numbers.hpp"

#include <cmath>
#include <limits>

namespace rift::base {

double mean_of(std::span<const double> numbers) {
  if (numbers.empty()) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0.0;
  for (const double n : numbers) sum += n;
  return sum / static_cast<double>(numbers.size());
}

double deviation_of(std::span<const double> numbers) {
  if (numbers.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  const double mean = mean_of(numbers);
  double squares = 0.0;
  for (const double n : numbers) squares += (n - mean) * (n - mean);
  return std::sqrt(squares / static_cast<double>(numbers.size() - 1));
}

}  // namespace rift::base
