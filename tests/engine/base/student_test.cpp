#include "engine/base/student.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace rift::base {
namespace {

// t of (count - 1) degrees of freedom whose two tails hold 31.73 %, by scipy.stats.t.ppf.
TEST(StudentFactor, IsTheQuantileOfOneStandardDeviation) {
  struct {
    std::size_t count;
    double t;
  } known[] = {{2, 1.83734}, {3, 1.32128},  {4, 1.19688}, {5, 1.14163},
               {6, 1.11051}, {12, 1.04757}, {51, 1.01010}};
  for (const auto& [count, t] : known) EXPECT_NEAR(student_factor(count), t, 1.3e-4 * t) << count;
  EXPECT_TRUE(std::isnan(student_factor(1)));
}

TEST(StandardError, IsWidenedForFewNumbers) {
  const std::array<double, 3> three{1.0, 2.0, 3.0};
  EXPECT_NEAR(standard_error_of(three), 1.32128 / std::sqrt(3.0), 1e-12);
  EXPECT_TRUE(std::isnan(standard_error_of(std::array{1.0})));
}

}  // namespace
}  // namespace rift::base
