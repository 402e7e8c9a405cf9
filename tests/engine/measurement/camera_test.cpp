#include "engine/measurement/camera.hpp"

#include "tests/engine/lattice/hand_made.hpp"

#include <gtest/gtest.h>

namespace rift::measurement {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

std::vector<Eigen::Vector2d> plate_of_elements() {
  lattice::hand_made::Draw draw(5);
  std::vector<Eigen::Vector2d> at;
  for (int i = 0; i < 4000; ++i) {
    const double x = draw.between(0, 2), y = draw.between(0, 1);
    at.emplace_back(x, y);
  }
  return at;
}

/// A crack along y = 0.5 from x = 0 on.
double parted_at_half(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  if ((a.y() >= 0.5) == (b.y() >= 0.5)) return never;
  return a.x() + (0.5 - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
}

TEST(Camera, ReadsALinearFieldExactlyEverywhere) {
  const auto at = plate_of_elements();
  const Grid grid = grid_over(2, 1, 0.1);
  const Camera camera(at, grid.point, 0.1, parted_at_half);
  const auto seen =
      camera.see(-1.0, [&](int i) { return Eigen::Vector3d(2.0 * at[i].y(), 3.0 - at[i].x(), 4.0); });
  ASSERT_EQ(seen.size(), 200U);
  for (std::size_t p = 0; p < seen.size(); ++p) {
    ASSERT_TRUE(seen[p]) << p;
    EXPECT_NEAR(seen[p]->u.x(), 2.0 * grid.point[p].y(), 1e-12);
    EXPECT_NEAR(seen[p]->u.y(), 3.0 - grid.point[p].x(), 1e-12);
    EXPECT_NEAR(seen[p]->strain_xy(), 0.5, 1e-11);
    EXPECT_NEAR(seen[p]->strain_yy(), 0.0, 1e-11);
  }
}

// The faces move apart by a jump that no subset may smear, behind the tip and nowhere else.
TEST(Camera, LooksAtOneFaceOfTheCrackOnly) {
  const auto at = plate_of_elements();
  const Grid grid = grid_over(2, 1, 0.1);
  const Camera camera(at, grid.point, 0.1, parted_at_half);
  const double tip = 1.0;
  const auto seen =
      camera.see(tip, [&](int i) { return Eigen::Vector3d(0, at[i].y() >= 0.5 ? 1.0 : -1.0, 0); });
  int smeared = 0;
  ASSERT_FALSE(seen.empty());
  for (std::size_t p = 0; p < seen.size(); ++p) {
    ASSERT_TRUE(seen[p]) << p;
    const Eigen::Vector2d& point = grid.point[p];
    const double own = point.y() >= 0.5 ? 1.0 : -1.0;
    if (point.x() < tip - 0.1 || std::abs(point.y() - 0.5) > 0.1)
      EXPECT_NEAR(seen[p]->u.y(), own, 1e-12) << point.transpose();
    else if (point.x() > tip + 0.1)
      smeared += std::abs(seen[p]->u.y() - own) > 0.05;
  }
  EXPECT_EQ(smeared, 18);  // ahead of the tip the two rows beside the line see both sides
}

TEST(Camera, ShowsNothingWhereASubsetHasLostItsHold) {
  const auto at = plate_of_elements();
  const Camera camera(at, {{0.5, 0.5}}, 0.1, [](const auto&, const auto&) { return 1.0; });
  const auto still = [](int) { return Eigen::Vector3d(1, 1, 1); };
  EXPECT_TRUE(camera.see(0.99, still)[0]);
  EXPECT_FALSE(camera.see(1.0, still)[0]);
}

TEST(GridOver, HasEqualCellsWhoseMiddlesAreItsPoints) {
  const Grid grid = grid_over(10, 4, 1.1);
  EXPECT_EQ(grid.columns, 9);
  EXPECT_EQ(grid.rows, 4);
  ASSERT_EQ(grid.point.size(), 36U);
  EXPECT_NEAR(grid.point.front().x(), 10.0 / 18, 1e-12);
  EXPECT_NEAR(grid.point.back().x(), 10 - 10.0 / 18, 1e-12);
  EXPECT_NEAR(grid.point[9].y(), 1.5, 1e-12);
  EXPECT_EQ(grid_over(1, 1, 50).point.size(), 1U);
}

}  // namespace
}  // namespace rift::measurement
