#include "engine/base/student.hpp"

#include "engine/base/numbers.hpp"

#include <cmath>
#include <limits>

namespace rift::base {

double student_factor(std::size_t count) {
  if (count < 2) return std::numeric_limits<double>::quiet_NaN();
  if (count == 2) return 1.83734;
  if (count == 3) return 1.32128;
  const double n = static_cast<double>(count - 1);
  return 1.0 + (0.5 + (0.25 + 0.0625 / n) / n) / n;
}

double standard_error_of(std::span<const double> numbers) {
  return student_factor(numbers.size()) * deviation_of(numbers) /
         std::sqrt(static_cast<double>(numbers.size()));
}

}  // namespace rift::base
