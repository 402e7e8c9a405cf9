#include "tests/studio/run_rift.hpp"

#include <gtest/gtest.h>

namespace rift::studio {
namespace {

TEST(Validate, NamesTheProblemsWhereOneIsUnknown) {
  const Ran ran = run_rift("validate borden");
  EXPECT_EQ(ran.exit_code, 2);
  EXPECT_EQ(
      ran.err,
      "rift validate: 'borden' is no problem; there are freund_wave, borden_branching, bobaru_branching\n");
  EXPECT_NE(run_rift("validate --quick --fine").exit_code, 0);
}

TEST(CalibrateToughness, RefusesAPlateWithoutTheLawOrItsLoad) {
  const Ran law = run_rift("calibrate plate_pnrt --toughness");
  EXPECT_EQ(law.exit_code, 2);
  EXPECT_TRUE(contains(law.err, "must be \"cohesive\": kappa is that law's constant")) << law.err;
  const Ran load = run_rift("calibrate borden_branching --toughness");
  EXPECT_EQ(load.exit_code, 2);
  EXPECT_TRUE(contains(load.err, "loading.rollers = false (default): must be true")) << load.err;
  EXPECT_TRUE(contains(run_rift("calibrate --toughness --young '3 GPa'").err, "--young"));
}

}  // namespace
}  // namespace rift::studio
