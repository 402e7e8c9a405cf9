#include "engine/history/crack_history.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rift::history {
namespace {

/// A tip that speeds up evenly to 600 m/s within 100 us, runs on for 50 us, rests for 50 us and runs again.
double truth(double t) {
  const double a = 6e6, up = 100e-6, rest = 150e-6, again = 200e-6, v = a * up;
  const double speeding = std::min(t, up), running = std::clamp(t - up, 0.0, rest - up);
  return 0.01 + 0.5 * a * speeding * speeding + v * running + v * std::max(0.0, t - again);
}

std::vector<HistoryPoint> measured(int rows, double noise, bool known, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<HistoryPoint> out;
  for (int i = 0; i < rows; ++i) {
    const double t = 300e-6 * i / (rows - 1);
    out.push_back({t - 20e-6, truth(t) + (i > 0 ? noise * normal(random) : 0.0), known ? noise : 0.0});
  }
  return out;
}

double largest_error(const SmoothedHistory& course) {
  double most = 0.0;
  for (double t = 0.0; t < 300e-6; t += 1e-6)
    most = std::max(most, std::abs(tip_at(course.history, t) - truth(t)));
  return most;
}

TEST(MeasuredCourse, NeverGoesBackwardWhateverTheNoise) {
  for (const double noise : {2e-5, 2e-4, 2e-3, 2e-2})
    for (const unsigned seed : {1U, 2U, 3U}) {
      const SmoothedHistory course =
          smoothed_history(measured(60, noise, true, seed), 0.01, Smoothing::monotone);
      for (double t = 0.0; t <= 300e-6; t += 1e-6) ASSERT_GE(speed_at(course.history, t), -1e-9) << noise;
      EXPECT_EQ(tip_at(course.history, 0.0), 0.01);
      EXPECT_NEAR(course.end, tip_at(course.history, 300e-6), 1e-12);
      EXPECT_EQ(course.first_time, -20e-6);
    }
}

TEST(MeasuredCourse, RecoversTheTruthWithinTheNoiseArrestAndRestartIncluded) {
  for (const bool known : {true, false}) {
    const SmoothedHistory course = smoothed_history(measured(400, 2e-4, known), 0.01, Smoothing::monotone);
    EXPECT_LT(largest_error(course), 6e-4) << known;
    EXPECT_NEAR(course.scatter, 2e-4, 3e-5) << known;
    EXPECT_NEAR(speed_at(course.history, 50e-6), 300.0, 30.0) << known;
    EXPECT_LT(speed_at(course.history, 175e-6), 10.0) << known;
  }
}

TEST(MeasuredCourse, ErrorsFallWithMoreRows) {
  const double few = largest_error(smoothed_history(measured(40, 1e-3, true), 0.01, Smoothing::monotone));
  const double many = largest_error(smoothed_history(measured(4000, 1e-3, true), 0.01, Smoothing::monotone));
  EXPECT_LT(many, 0.6 * few);
}

TEST(MeasuredCourse, FitsRowsAsNearAsTheirUncertaintiesSay) {
  const SmoothedHistory course = smoothed_history(measured(200, 5e-4, true), 0.01, Smoothing::monotone);
  EXPECT_LE(course.chi2, 1.0);
  EXPECT_GT(course.chi2, 0.7);
}

TEST(MeasuredCourse, OfExactRowsAtOneSpeedIsThatSpeed) {
  std::vector<HistoryPoint> rows;
  for (int i = 0; i < 20; ++i) rows.push_back({1e-6 * i, 0.01 + 500e-6 * i, 0.0});
  for (const Smoothing smoothing : {Smoothing::monotone, Smoothing::none}) {
    const SmoothedHistory course = smoothed_history(rows, 0.01, smoothing);
    for (const double t : {0.0, 3.3e-6, 18.9e-6}) {
      EXPECT_NEAR(speed_at(course.history, t), 500.0, 1e-3);
      EXPECT_NEAR(tip_at(course.history, t), 0.01 + 500.0 * t, 1e-9);
    }
    EXPECT_NEAR(course.end, rows.back().position, 1e-9);
  }
}

TEST(MeasuredCourse, WithoutSmoothingGoesThroughEveryRow) {
  const std::vector<HistoryPoint> rows{{0, 0.01, 0}, {4e-6, 0.012, 0}, {6e-6, 0.012, 0}, {7e-6, 0.0125, 0}};
  const SmoothedHistory course = smoothed_history(rows, 0.01, Smoothing::none);
  const std::vector<double> at = positions_at_rows(course, rows);
  ASSERT_FALSE(rows.empty());
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_NEAR(at[i], rows[i].position, 1e-15);
  EXPECT_EQ(speed_at(course.history, 5e-6), 0.0);
  EXPECT_NEAR(time_of_arrival(course.history, 0.012), 4e-6, 1e-18);  // first there, not when it leaves
  EXPECT_NEAR(time_of_arrival(course.history, 0.01225), 6.5e-6, 1e-18);
}

TEST(CrackHistory, OfAStretchThatSpeedsUpArrivesWhenItsTipIsThere) {
  const CrackHistory history{{{0, 1.0, 2.0, 0.5}, {4, 13.0, 4.0, -1.0}, {8, 21.0, 0.0, 0.0}}};
  EXPECT_DOUBLE_EQ(tip_at(history, 2.0), 6.0);
  EXPECT_DOUBLE_EQ(speed_at(history, 2.0), 3.0);
  EXPECT_DOUBLE_EQ(highest_speed(history), 4.0);
  for (const double t : {0.0, 0.7, 3.9, 4.0, 5.5, 7.9})
    EXPECT_NEAR(time_of_arrival(history, tip_at(history, t)), t, 1e-9);
  EXPECT_DOUBLE_EQ(time_of_arrival(history, 21.0), 8.0);
  EXPECT_TRUE(std::isinf(time_of_arrival(history, 21.1)));  // it rests there for ever
}

}  // namespace
}  // namespace rift::history
