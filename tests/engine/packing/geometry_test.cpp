#include "engine/packing/geometry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rift::packing {
namespace {

const Box cylinder{2.0, 5.0, 2.0, Shape::cylinder}, sphere{2.0, 2.0, 2.0, Shape::sphere},
    periodic{2.0, 3.0, 4.0, Shape::periodic};

TEST(Walls, HoldTheVolumeOfTheirShape) {
  EXPECT_DOUBLE_EQ(cylinder.volume(), 5.0 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(sphere.volume(), 4.0 / 3.0 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(periodic.volume(), 24.0);
  EXPECT_DOUBLE_EQ(cylinder.section(1), std::numbers::pi);
}

TEST(Walls, HoldWhatLiesWithinThem) {
  EXPECT_TRUE(contains(cylinder, {1.9, 4.9, 1.0}));
  EXPECT_FALSE(contains(cylinder, {1.9, 4.9, 1.9}));  // in the box around, outside the round wall
  EXPECT_FALSE(contains(cylinder, {1.0, 5.1, 1.0}));
  EXPECT_FALSE(contains(sphere, {1.8, 1.8, 1.0}));
  EXPECT_TRUE(contains(periodic, {1.9, 2.9, 3.9}));
}

TEST(Boundary, HasTheElementsThatLieWithinSoManyRadiiOfIt) {
  const std::vector<Eigen::Vector3d> centre{{0.1, 2.0, 1.0}, {1.0, 4.8, 1.0}, {1.9, 0.3, 1.0}};
  const std::vector<double> radius{0.2, 0.2, 0.2};
  const auto at = [&](Boundary b) { return elements_at(cylinder, b, centre, radius, 1.3); };
  EXPECT_EQ(at(Boundary::left), std::vector{0});
  EXPECT_EQ(at(Boundary::right), std::vector{2});
  EXPECT_EQ(at(Boundary::top), std::vector{1});
  EXPECT_TRUE(at(Boundary::bottom).empty());
  EXPECT_EQ(ends_of_axis(1), (std::array{Boundary::bottom, Boundary::top}));
  EXPECT_DOUBLE_EQ(depth_below(cylinder, Boundary::front, centre[0]), 1.0);
}

/// Sum of the squared overlaps with the walls, by the shapes' own words.
double overlap_energy(const Box& box, const Eigen::Vector3d& p, double r) {
  const auto squared = [](double overlap) { return overlap > 0.0 ? overlap * overlap : 0.0; };
  const double radius = 0.5 * box.length;
  if (box.shape == Shape::sphere) return squared((p - Eigen::Vector3d::Constant(radius)).norm() + r - radius);
  return squared(std::hypot(p.x() - radius, p.z() - radius) + r - radius) + squared(r - p.y()) +
         squared(r - (box.height - p.y()));
}

TEST(Walls, PushAsTheGradientOfTheOverlapsSquared) {
  constexpr double h = 1e-6, r = 0.5;
  for (const Box& box : {cylinder, sphere})
    for (const Eigen::Vector3d& p : {Eigen::Vector3d(1.6, 0.4, 1.3), Eigen::Vector3d(0.5, 1.2, 0.7)}) {
      const Eigen::Vector3d push = wall_push(box, p, r);
      EXPECT_GT(push.norm(), 0.01);
      for (int c = 0; c < 3; ++c) {
        const Eigen::Vector3d d = h * Eigen::Vector3d::Unit(c);
        const double slope = (overlap_energy(box, p + d, r) - overlap_energy(box, p - d, r)) / (2.0 * h);
        EXPECT_NEAR(push[c], -slope, 1e-8);
        const Eigen::Vector3d change = (wall_push(box, p + d, r) - wall_push(box, p - d, r)) / (2.0 * h);
        EXPECT_LT((wall_stiffness(box, p, r).col(c) + change).norm(), 1e-7);
      }
    }
}

TEST(Walls, ThatAreNotThereDoNotPush) {
  EXPECT_TRUE(wall_push(periodic, {0.0, 0.0, 0.0}, 0.5).isZero(0.0));
  EXPECT_TRUE(wall_stiffness(periodic, {0.0, 0.0, 0.0}, 0.5).isZero(0.0));
}

TEST(Walls, OfAPeriodicBoxAreCrossedByTheShortestWay) {
  const Eigen::Vector3d way = minimum_image(periodic, {0.1, 2.9, 1.0}, {1.9, 0.1, 1.5});
  EXPECT_LT((way - Eigen::Vector3d(-0.2, 0.2, 0.5)).norm(), 1e-15);
  EXPECT_DOUBLE_EQ(minimum_image(cylinder, {0.1, 0.0, 0.0}, {1.9, 0.0, 0.0}).x(), 1.8);
}

}  // namespace
}  // namespace rift::packing
