#include "engine/stability/suite.hpp"
#include "tests/expectations.hpp"

#include <gtest/gtest.h>

#include <cstdio>

namespace rift::stability {
namespace {

// A million steps of free vibration and cracks at 1e-4 c_r among them.
TEST(StiffAndExtremeCases, AllComeToWhatTheyMust) {
  int cases = 0;
  for (const StabilityCase& one : not_empty(stability_cases({}))) {
    const StabilityRow row = try_case(one);
    EXPECT_TRUE(row.as_expected) << row.family << ": " << row.name;
    ++cases;
  }
  std::printf("%d cases\n", cases);
}

}  // namespace
}  // namespace rift::stability
