#include "studio/text/progress.hpp"

#include "tests/studio/run_rift.hpp"

#include <chrono>
#include <thread>

namespace rift::studio {
namespace {

TEST(Pace, OfASteadyStageTellsTheRest) {
  Pace pace;
  for (int k = 0; k <= 30; ++k) pace.note(k, 0.01 * k);
  EXPECT_NEAR(pace.remaining(30.0), 70.0, 1e-9);
}

TEST(Pace, OfAStageThatSlowsDownIsThatOfItsLastQuarter) {
  Pace pace;
  for (int k = 0; k <= 40; ++k) pace.note(k, 0.02 * k);             // 0.8 in 40 s
  for (int k = 1; k <= 60; ++k) pace.note(40 + k, 0.8 + 1e-4 * k);  // then a two hundredth of that
  EXPECT_NEAR(pace.remaining(100.0), (1.0 - 0.806) / 1e-4, 1.0);    // not the 24 s of the whole
}

TEST(Pace, OfAStageThatStandsStillIsNotKnown) {
  Pace pace;
  EXPECT_LT(pace.remaining(0.0), 0.0);
  for (int k = 0; k <= 10; ++k) pace.note(k, 0.099 * k);  // "0.1 s left"
  EXPECT_GE(pace.remaining(10.0), 0.0);
  pace.note(1000.0, 0.99);
  EXPECT_LT(pace.remaining(1000.0), 0.0);
}

TEST(Pace, OfManySmallStepsKeepsFew) {
  Pace pace;
  for (int k = 0; k <= 1'000'000; ++k) pace.note(1e-4 * k, 1e-6 * k);
  EXPECT_LT(pace.kept(), 1000u);
  EXPECT_NEAR(pace.remaining(100.0), 0.0, 1e-6);
}

TEST(ProgressLine, ShowsAStageThatTellsNothingFurther) {
  testing::internal::CaptureStderr();
  {
    ProgressLine line(ProgressStyle::plain);
    line.show("critical step", 0.0);
    std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  }
  EXPECT_TRUE(contains(testing::internal::GetCapturedStderr(), "critical step   0 %  for "));
}

TEST(ProgressLine, IsSilentAfterTheEndOfAStage) {
  testing::internal::CaptureStderr();
  ProgressLine line(ProgressStyle::plain);
  line.show("packing", 0.0);
  line.clear();
  std::this_thread::sleep_for(std::chrono::milliseconds(2200));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace rift::studio
