#include "engine/base/numbers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace rift::base {
namespace {

TEST(Numbers, HaveAMeanAndTheDeviationOfTheirSample) {
  const std::vector<double> numbers{1.0, 2.0, 3.0};
  EXPECT_EQ(mean_of(numbers), 2.0);
  EXPECT_EQ(deviation_of(numbers), 1.0);
}

TEST(Numbers, ASingleOneHasNoDeviationAndNoneHaveNoMean) {
  const std::vector<double> one{7.0}, none;
  EXPECT_EQ(mean_of(one), 7.0);
  EXPECT_TRUE(std::isnan(deviation_of(one)));
  EXPECT_TRUE(std::isnan(mean_of(none)));
  EXPECT_TRUE(std::isnan(deviation_of(none)));
}

TEST(Interval, IsTheOneThatHoldsANumberOrTheOutermost) {
  const std::vector<double> x{1.0, 2.0, 4.0};
  const auto is = [&](double at, std::size_t k, double part) {
    const Interval found = interval_at(x, at);
    EXPECT_EQ(found.k, k) << at;
    EXPECT_EQ(found.part, part) << at;
  };
  is(1.5, 1, 0.5);
  is(2.0, 1, 1.0);
  is(3.0, 2, 0.5);
  is(0.0, 1, -1.0);
  is(6.0, 2, 2.0);
}

TEST(Interval, IsFoundByWhatIsAskedOfARow) {
  const std::vector<std::array<double, 2>> rows{{0.0, 5.0}, {1.0, 7.0}};
  EXPECT_EQ(interval_at(rows, 0.25, [](const auto& row) { return row[0]; }).part, 0.25);
}

}  // namespace
}  // namespace rift::base
