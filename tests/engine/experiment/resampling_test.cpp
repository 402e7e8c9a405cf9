#include "engine/experiment/efficiency.hpp"
#include "engine/scene/derived.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rift::experiment {
namespace {

/// A tip at 600 m/s, seen every microsecond.
scene::Scene measured(double uncertainty) {
  scene::Scene scene = scene::read_preset_text("", "x.toml").scene;
  scene.crack.start = 0.01;
  for (int k = 0; k < 200; ++k) {
    const double wobble = uncertainty > 0.0 || k == 0 ? 0.0 : 2e-4 * std::sin(12.9898 * k * k);
    scene.crack.history.push_back({1e-6 * k, 0.01 + 6e-4 * k + wobble, uncertainty});
  }
  return scene;
}

double deviation(const std::vector<std::vector<history::HistoryPoint>>& histories, const scene::Scene& scene,
                 const history::SmoothedHistory& course) {
  double squares = 0.0, count = 0.0;
  const std::vector<double> fitted = history::positions_at_rows(course, scene.crack.history);
  for (const auto& rows : histories)
    for (std::size_t k = 1; k < rows.size(); ++k)
      squares += std::pow(rows[k].position - fitted[k], 2.0), ++count;
  return std::sqrt(squares / count);
}

TEST(Resampled, RowsScatterAsTheirUncertaintiesSayOrAsTheRowsDid) {
  for (const double uncertainty : {3e-4, 0.0}) {
    const scene::Scene scene = measured(uncertainty);
    const history::SmoothedHistory course = scene::smoothed_history(scene);
    const auto histories = resampled(scene, course, 20, 1);
    ASSERT_EQ(histories.size(), 20U);
    const double expected = uncertainty > 0.0 ? uncertainty : course.scatter;
    EXPECT_GT(expected, 1e-4);
    EXPECT_NEAR(deviation(histories, scene, course), expected, 0.05 * expected);
    for (const auto& rows : histories) {
      ASSERT_FALSE(rows.empty());
      EXPECT_EQ(rows.front().position, 0.01);  // the notch's end is known
      for (std::size_t k = 0; k < rows.size(); ++k) EXPECT_EQ(rows[k].time, scene.crack.history[k].time);
    }
  }
}

TEST(Resampled, IsTheSameForTheSameSeedAndNothingWhereNothingIsSmoothed) {
  scene::Scene scene = measured(3e-4);
  const history::SmoothedHistory course = scene::smoothed_history(scene);
  EXPECT_EQ(resampled(scene, course, 3, 5), resampled(scene, course, 3, 5));
  EXPECT_NE(resampled(scene, course, 3, 5), resampled(scene, course, 3, 6));
  scene.crack.smoothing = history::Smoothing::none;
  EXPECT_TRUE(resampled(scene, course, 3, 5).empty());
}

TEST(EfficiencyAt, IsStraightBetweenThePointsAndConstantBeyond) {
  const std::vector<EfficiencyPoint> points{{0.1, 0.9}, {0.3, 0.7}};
  EXPECT_EQ(efficiency_at(points, 0.05).efficiency, 0.9);
  EXPECT_NEAR(efficiency_at(points, 0.2).efficiency, 0.8, 1e-12);
  EXPECT_EQ(efficiency_at(points, 0.8).efficiency, 0.7);
}

}  // namespace
}  // namespace rift::experiment
