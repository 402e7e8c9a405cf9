#include "tests/studio/commands/range_sweep.hpp"

namespace rift::studio {
namespace {

// Each of these once crashed, hung, or ended in a library's words; ranges_slow_test sweeps all keys.
TEST(Ranges, OfWhatFollowsFromAKeyAreRefusedByCheckAndRunAlike) {
  RangeSweep sweep(20);
  const std::vector<Given> extremes{
      {"specimen.height", "1e-300"},        {"specimen.length", "5e-324"},
      {"material.young_modulus", "5e-324"}, {"material.rayleigh_speed", "1e-300"},
      {"crack.velocity", "1e-300 c_r"},     {"crack.damage_zone_ratio", "5e-324"},
      {"loading.displacement", "1e-300"}};
  for (const Given& given : extremes) EXPECT_EQ(sweep.complaint({given}), "");
  EXPECT_EQ(sweep.tally.refused, sweep.tally.runs);
}

TEST(Ranges, OfWhatFollowsFromTwoKeysAreRefusedThoughEachAloneIsFine) {
  RangeSweep sweep(20);
  EXPECT_EQ(sweep.complaint({{"material.young_modulus", "1e13"}, {"material.rayleigh_speed", "1e-2"}}), "");
  EXPECT_EQ(sweep.tally.refused, 2);
  EXPECT_EQ(sweep.complaint({{"material.rayleigh_speed", "10"}}), "");
  EXPECT_EQ(sweep.tally.refused, 2);
}

}  // namespace
}  // namespace rift::studio
