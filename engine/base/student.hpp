#pragma once

#include <cstddef>
#include <span>

namespace rift::base {

/// By how much an uncertainty that was estimated from `count` numbers is widened, so that one of it holds the
/// share of a normal distribution's standard deviation, 68.27 %: Student's t of (count - 1) degrees of
/// freedom   [Student 1908]. 1.84 of two numbers, 1.32 of three, 1.11 of six; NaN of fewer than two.
/// To 1e-4 of itself: exact for two and three, then 1 + 1/(2n) + 1/(4n^2) + 1/(16n^3), which is Fisher's
/// expansion in the degrees of freedom n at one standard deviation.
double student_factor(std::size_t count);

/// Standard uncertainty of the mean of a sample: deviation over sqrt(count), Student's factor counted in; NaN
/// of fewer than two.
double standard_error_of(std::span<const double> numbers);

}  // namespace rift::base
