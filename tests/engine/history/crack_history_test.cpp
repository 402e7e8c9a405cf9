#include "engine/history/crack_history.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace rift::history {
namespace {

constexpr double for_ever = std::numeric_limits<double>::infinity();

/// From 1 m at 2 m/s to 5 m (at 2 s), at 0.5 m/s to 6 m (at 4 s), then at 4 m/s.
CrackHistory three_speeds() { return history_of(1.0, {{2.0, 5.0}, {0.5, 6.0}, {4.0, for_ever}}); }

TEST(CrackHistory, AtOneSpeedIsAStraightLineFromTheStart) {
  const CrackHistory history = history_of(-0.5, {{1100.0, for_ever}});
  EXPECT_DOUBLE_EQ(tip_at(history, 0.0), -0.5);
  EXPECT_DOUBLE_EQ(tip_at(history, 1e-3), -0.5 + 1.1);
  EXPECT_DOUBLE_EQ(speed_at(history, 0.0), 1100.0);
  EXPECT_DOUBLE_EQ(time_of_arrival(history, 0.6), 1e-3);
}

TEST(CrackHistory, KeepsEachSpeedUntilItsPosition) {
  const CrackHistory history = three_speeds();
  EXPECT_DOUBLE_EQ(tip_at(history, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(tip_at(history, 1.0), 3.0);
  EXPECT_DOUBLE_EQ(tip_at(history, 2.0), 5.0);
  EXPECT_DOUBLE_EQ(tip_at(history, 3.0), 5.5);
  EXPECT_DOUBLE_EQ(tip_at(history, 4.0), 6.0);
  EXPECT_DOUBLE_EQ(tip_at(history, 10.0), 30.0);
}

TEST(CrackHistory, TakesTheNextSpeedAtTheMomentOfTheChange) {
  const CrackHistory history = three_speeds();
  EXPECT_DOUBLE_EQ(speed_at(history, 1.999), 2.0);
  EXPECT_DOUBLE_EQ(speed_at(history, 2.0), 0.5);
  EXPECT_DOUBLE_EQ(speed_at(history, 3.999), 0.5);
  EXPECT_DOUBLE_EQ(speed_at(history, 4.0), 4.0);
  EXPECT_DOUBLE_EQ(speed_at(history, 1e6), 4.0);
}

TEST(CrackHistory, TimeOfArrivalIsTheInverseOfTheTip) {
  const CrackHistory history = three_speeds();
  for (double time = 0.0; time < 8.0; time += 0.0625)  // exact numbers, the changes of speed among them
    EXPECT_NEAR(time_of_arrival(history, tip_at(history, time)), time,
                1e-14);  // rounding of numbers below 32
  for (double position = 1.0; position < 20.0; position += 0.0625)
    EXPECT_NEAR(tip_at(history, time_of_arrival(history, position)), position, 1e-14);
}

TEST(CrackHistory, PassesOverAPieceThatEndsBehindItsStart) {
  const CrackHistory history = history_of(3.0, {{7.0, 2.0}, {9.0, 3.0}, {2.0, for_ever}});
  EXPECT_DOUBLE_EQ(speed_at(history, 0.0), 2.0);
  EXPECT_DOUBLE_EQ(tip_at(history, 1.5), 6.0);
  EXPECT_DOUBLE_EQ(time_of_arrival(history, 6.0), 1.5);
}

}  // namespace
}  // namespace rift::history
