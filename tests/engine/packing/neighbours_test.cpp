#include "engine/packing/neighbours.hpp"

#include "tests/engine/lattice/hand_made.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift::packing {
namespace {

using lattice::hand_made::Draw;
using Pairs = std::vector<std::array<int, 2>>;
using Points = std::vector<Eigen::Vector3d>;

Pairs brute_force(const Points& points, const std::vector<double>& reach) {
  Pairs pairs;
  const int n = static_cast<int>(points.size());
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j)
      if ((points[j] - points[i]).norm() <= reach[i] + reach[j]) pairs.push_back({i, j});
  return pairs;
}

TEST(Neighbours, AreThoseOfBruteForceInOrder) {
  struct Cloud {
    Eigen::Vector3d size;
    double least, most;  // reach
  };
  const Cloud clouds[] = {
      {{1, 1, 1}, 0.05, 0.08}, {{10, 1, 0.1}, 0.02, 0.2}, {{5, 5, 0}, 0.1, 0.3},
      {{9, 0, 0}, 0.001, 0.1}, {{1, 1, 1}, 2.0, 3.0},     {{1e3, 1e3, 1e3}, 0.01, 20.0},
  };
  Draw draw(101);
  for (const Cloud& cloud : clouds) {
    Points points;
    std::vector<double> reach;
    for (int i = 0; i < 500; ++i) {
      points.emplace_back(cloud.size.cwiseProduct(draw.vector()));
      reach.push_back(draw.between(cloud.least, cloud.most));
    }
    const Pairs expected = brute_force(points, reach);
    ASSERT_FALSE(expected.empty());
    EXPECT_EQ(pairs_within_reach(points, reach), expected);
  }
}

TEST(Neighbours, ReachExactlySoFar) {
  const double just_more = std::nextafter(1.0, 2.0);
  const Pairs joined = {{0, 1}};
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d e = Eigen::Vector3d::Unit(axis);
    EXPECT_EQ(pairs_within_reach({0.0 * e, 1.0 * e}, {0.25, 0.75}), joined);
    EXPECT_EQ(pairs_within_reach({1.0 * e, 0.0 * e}, {0.25, 0.75}), joined);
    EXPECT_EQ(pairs_within_reach({0.0 * e, just_more * e}, {0.25, 0.75}), Pairs{});
  }
}

TEST(Neighbours, OnceEachWhereManyPointsCoincide) {
  const Pairs pairs = pairs_within_reach(Points(4, Eigen::Vector3d(1, 2, 3)), std::vector<double>(4, 0.5));
  EXPECT_EQ(pairs, (Pairs{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}));
}

TEST(Neighbours, OfOnePointOrNoneAreNone) {
  EXPECT_EQ(pairs_within_reach({}, {}), Pairs{});
  EXPECT_EQ(pairs_within_reach({Eigen::Vector3d(1, 2, 3)}, {0.5}), Pairs{});
}

TEST(ColumnOrder, TakesEveryPointOnceColumnByColumnAndUpwards) {
  Draw draw(102);
  Points points;
  for (int i = 0; i < 1000; ++i) points.emplace_back(5.0 * draw.vector());
  const double cell = 0.7;
  const std::vector<int> order = column_order(points, cell);
  std::vector<int> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(sorted[i], i);
  int columns = 1;
  ASSERT_GT(order.size(), 1U);
  for (std::size_t k = 1; k < order.size(); ++k) {
    const Eigen::Vector3d &here = points[order[k]], &before = points[order[k - 1]];
    const double column = std::floor(here.x() / cell), column_before = std::floor(before.x() / cell);
    EXPECT_GE(column, column_before);
    if (column > column_before) {
      ++columns;
    } else {
      EXPECT_GE(here.y(), before.y());
    }
  }
  EXPECT_EQ(columns, 16);  // -5 to 5 in columns of 0.7 with an edge at 0
}

TEST(ColumnOrder, OfOnePointOrNone) {
  EXPECT_EQ(column_order({}, 1.0), std::vector<int>{});
  EXPECT_EQ(column_order({Eigen::Vector3d(-1, 2, 3)}, 1.0), std::vector<int>{0});
}

}  // namespace
}  // namespace rift::packing
