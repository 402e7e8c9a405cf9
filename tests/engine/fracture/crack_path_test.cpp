#include "engine/fracture/crack_path.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <random>

namespace rift::fracture {
namespace {

using Point = Eigen::Vector2d;

CrackPath path_of(std::vector<Point> points) { return {std::move(points)}; }

/// The path rises at right angles, then goes on: all coordinates below are exact.
CrackPath stair() { return path_of({{0.0, 1.0}, {2.0, 1.0}, {2.0, 3.0}, {5.0, 3.0}}); }

/// By another way than the sides of triangles: p + t (q - p) = a + u (b - a) solved for t and u.
std::optional<double> crossing_by_equations(const CrackPath& path, const Point& a, const Point& b) {
  double behind = 0.0;
  for (std::size_t k = 0; k + 1 < path.point.size(); ++k) {
    const Point along = path.point[k + 1] - path.point[k];
    Eigen::Matrix2d m;
    m << along, a - b;
    const Point tu = m.fullPivLu().solve(a - path.point[k]);
    if (tu.minCoeff() >= 0.0 && tu.maxCoeff() < 1.0) return behind + tu[0] * along.norm();
    behind += along.norm();
  }
  return std::nullopt;
}

/// Random points with the occasional path that turns back on itself.
struct RandomPoints {
  std::mt19937_64 generator{7};
  std::uniform_real_distribution<double> coordinate{0.0, 1.0};
  Point point() { return {coordinate(generator), coordinate(generator)}; }
  CrackPath path() {
    CrackPath p;
    const auto count = 2 + generator() % 5;
    for (std::uint64_t k = 0; k < count; ++k) p.point.push_back(point());
    return p;
  }
};

TEST(FirstCrossing, IsTheArcLengthWhereThePathMeetsTheSegment) {
  const CrackPath path = straight_path(10.0, 1.0);
  const auto upright = first_crossing(path, {3.0, 0.0}, {3.0, 2.0});
  const auto slanted = first_crossing(path, {8.0, 1.5}, {4.0, 0.5});
  ASSERT_TRUE(upright && slanted);
  EXPECT_DOUBLE_EQ(*upright, 3.0);
  EXPECT_DOUBLE_EQ(*slanted, 6.0);
}

TEST(FirstCrossing, IsNoneBesideBeforeAndBeyondThePath) {
  const CrackPath path = straight_path(10.0, 1.0);
  EXPECT_FALSE(first_crossing(path, {3.0, 1.1}, {4.0, 2.0}));
  EXPECT_FALSE(first_crossing(path, {3.0, 0.9}, {4.0, 0.0}));
  EXPECT_FALSE(first_crossing(path, {-0.1, 0.0}, {-0.1, 2.0}));
  EXPECT_FALSE(first_crossing(path, {10.1, 0.0}, {10.1, 2.0}));
}

TEST(FirstCrossing, CountsArcLengthRoundAKink) {
  const auto on_the_rise = first_crossing(stair(), {1.0, 2.5}, {3.0, 2.5});
  const auto on_the_last = first_crossing(stair(), {4.0, 2.0}, {4.0, 4.0});
  ASSERT_TRUE(on_the_rise && on_the_last);
  EXPECT_DOUBLE_EQ(*on_the_rise, 2.0 + 1.5);
  EXPECT_DOUBLE_EQ(*on_the_last, 2.0 + 2.0 + 2.0);
}

TEST(FirstCrossing, OfASegmentThatIsCrossedTwiceIsTheEarlierOne) {
  const auto s = first_crossing(stair(), {1.5, 0.5}, {2.5, 2.0});  // y = 1 at x = 1.8333, x = 2 at y = 1.25
  ASSERT_TRUE(s);
  EXPECT_NEAR(*s, 1.5 + 1.0 / 3.0, 1e-15);  // rounding of the division
  const auto reversed = first_crossing(stair(), {2.5, 2.0}, {1.5, 0.5});
  ASSERT_TRUE(reversed);
  EXPECT_NEAR(*reversed, *s, 1e-15);
}

// A chain that goes from one side to the other through an element exactly on the path is cut once, not twice
// and not never, whichever end of a beam comes first.
TEST(FirstCrossing, CutsAChainThroughAPointOnThePathOnce) {
  struct Chain {
    CrackPath path;
    Point left, on, right;
  };
  const std::vector<Chain> chains{{straight_path(10.0, 1.0), {3.25, 1.5}, {3.0, 1.0}, {2.5, 0.25}},
                                  {straight_path(10.0, 1.0), {3.0, 1.5}, {3.0, 1.0}, {3.0, 0.5}},
                                  {stair(), {1.0, 1.5}, {1.5, 1.0}, {1.5, 0.0}},
                                  {stair(), {1.5, 2.5}, {2.0, 2.25}, {3.0, 2.0}},
                                  {stair(), {4.0, 3.5}, {4.0, 3.0}, {3.0, 2.5}}};
  for (const Chain& c : chains) {
    const auto cuts = [&](const Point& a, const Point& b) {
      EXPECT_EQ(first_crossing(c.path, a, b).has_value(), first_crossing(c.path, b, a).has_value());
      return first_crossing(c.path, a, b) ? 1 : 0;
    };
    EXPECT_EQ(cuts(c.left, c.on) + cuts(c.on, c.right), 1) << c.on.transpose();
    EXPECT_EQ(cuts(c.left, c.on), 0) << "a point on the path counts to its left";
  }
}

// Random numbers never meet an end of a segment, so the two methods need not agree on what is half-open.
TEST(FirstCrossing, AgreesWithTheEquationsOfTheTwoLines) {
  RandomPoints random;
  int crossed = 0, passed = 0;
  for (int k = 0; k < 20000; ++k) {
    const CrackPath path = random.path();
    const Point a = random.point(), b = random.point();
    const auto expected = crossing_by_equations(path, a, b), found = first_crossing(path, a, b);
    ASSERT_EQ(found.has_value(), expected.has_value()) << "case " << k;
    ++(found ? crossed : passed);
    // Rounding over the sine of the angle between the lines, in 20,000 cases seldom below 1e-4.
    if (found) {
      ASSERT_NEAR(*found, *expected, 1e-10) << "case " << k;
    }
  }
  EXPECT_GT(crossed, 2000);
  EXPECT_GT(passed, 2000);
}

TEST(DistanceTo, IsThatOfTheFootOrOfTheNearerEnd) {
  const CrackPath path = straight_path(10.0, 1.0);
  EXPECT_DOUBLE_EQ(distance_to(path, {4.0, 3.5}), 2.5);
  EXPECT_DOUBLE_EQ(distance_to(path, {4.0, 0.0}), 1.0);
  EXPECT_DOUBLE_EQ(distance_to(path, {-3.0, 5.0}), 5.0);
  EXPECT_DOUBLE_EQ(distance_to(path, {13.0, -3.0}), 5.0);
  EXPECT_NEAR(distance_to(path, {7.0, 1.0}), 0.0, 1e-15);  // on the path: rounding
}

TEST(DistanceTo, IsTheLeastOverAllPointsOfThePath) {
  constexpr int points = 2000;
  RandomPoints random;
  for (int k = 0; k < 100; ++k) {
    const CrackPath path = random.path();
    const Point p = random.point();
    double least = 10.0;
    for (std::size_t s = 0; s + 1 < path.point.size(); ++s)
      for (int n = 0; n <= points; ++n) {
        const double t = static_cast<double>(n) / points;
        least = std::min(least, (path.point[s] * (1.0 - t) + path.point[s + 1] * t - p).norm());
      }
    const double distance = distance_to(path, p);
    EXPECT_LE(distance, least + 1e-15);
    EXPECT_NEAR(distance, least, 1.5 * length_of(path) / points);  // no further apart than the points
  }
}

lattice::Lattice lattice_of(const std::vector<std::array<Point, 2>>& beams) {
  lattice::Lattice lattice;
  for (const auto& [a, b] : beams) {
    const int next = static_cast<int>(lattice.centre.size());
    lattice.centre.emplace_back(a.x(), a.y(), 0.3 * next);
    lattice.centre.emplace_back(b.x(), b.y(), -0.2 * next);
    lattice.ends.push_back({next, next + 1});
  }
  return lattice;
}

TEST(Crossings, ComeInTheOrderTheCrackMeetsThem) {
  const lattice::Lattice lattice = lattice_of({{Point(7, 0), Point(7, 2)},
                                               {Point(4, 0), Point(5, 0.5)},  // not crossed
                                               {Point(3, 2), Point(3, 0)},
                                               {Point(7, 2), Point(7, 0)},  // as far as the first
                                               {Point(1, 0), Point(2, 2)}});
  const std::vector<Crossing> met = crossings(straight_path(10.0, 1.0), lattice);
  ASSERT_EQ(met.size(), 4U);
  const std::vector<int> beams{4, 2, 0, 3};
  const std::vector<double> positions{1.5, 3.0, 7.0, 7.0};
  for (std::size_t k = 0; k < met.size(); ++k) {
    EXPECT_EQ(met[k].beam, beams[k]);
    EXPECT_DOUBLE_EQ(met[k].position, positions[k]);
  }
}

TEST(Crossings, OfTwoTipsAreCountedFromTheMiddleOfThePath) {
  const lattice::Lattice lattice = lattice_of({{Point(9, 0), Point(9, 2)},
                                               {Point(1, 2), Point(1, 0)},
                                               {Point(3, 0), Point(4, 2)},  // at 3.5
                                               {Point(5.5, 0), Point(5.5, 2)}});
  const std::vector<Crossing> met = crossings(straight_path(10.0, 1.0, 2), lattice);
  ASSERT_EQ(met.size(), 4U);
  const std::vector<int> beams{3, 2, 0, 1};
  const std::vector<double> positions{0.5, 1.5, 4.0, 4.0};
  for (std::size_t k = 0; k < met.size(); ++k) {
    EXPECT_EQ(met[k].beam, beams[k]);
    EXPECT_DOUBLE_EQ(met[k].position, positions[k]);
  }
}

TEST(Crossings, OfTwoTipsAreCountedFromTheMiddleRoundAKink) {
  CrackPath path = stair();  // 7 long
  path.tips = 2;
  const std::vector<Crossing> met =
      crossings(path, lattice_of({{Point(1, 2.5), Point(3, 2.5)}, {Point(1, 0), Point(1, 2)}}));
  ASSERT_EQ(met.size(), 2U);
  EXPECT_EQ(met[0].beam, 0);
  EXPECT_DOUBLE_EQ(met[0].position, 0.0);
  EXPECT_DOUBLE_EQ(met[1].position, 2.5);
}

/// Two elements above the path and two below, joined by three beams: 0-2 from (1, 0) to (4, 1.5), 1-2 and
/// 1-3.
lattice::Lattice zigzag() {
  lattice::Lattice lattice;
  for (const Point& at : {Point(1, 0), Point(6, 0.5), Point(4, 1.5), Point(8, 2)})
    lattice.centre.emplace_back(at.x(), at.y(), 0.0);
  lattice.ends = {{0, 2}, {1, 2}, {1, 3}};
  return lattice;
}

std::vector<double> positions_by(ReleaseOrder order, int tips) {
  CrackPath path = straight_path(10.0, 1.0, tips);
  path.order = order;
  std::vector<double> of_beam(3, -1.0);
  for (const Crossing& c : crossings(path, zigzag())) of_beam[c.beam] = c.position;
  return of_beam;
}

TEST(ReleaseOrder, IsWhereThePathCrossesWhereTheMiddleIsOrWhereTheFirstElementIs) {
  EXPECT_DOUBLE_EQ(positions_by(ReleaseOrder::crossing, 1)[0], 3.0);
  EXPECT_EQ(positions_by(ReleaseOrder::middle, 1), (std::vector{2.5, 5.0, 7.0}));
  EXPECT_EQ(positions_by(ReleaseOrder::node, 1), (std::vector{1.0, 4.0, 6.0}));
}

TEST(ReleaseOrder, OfTwoTipsIsCountedFromTheMiddle) {
  EXPECT_EQ(positions_by(ReleaseOrder::middle, 2), (std::vector{2.5, 0.0, 2.0}));
  EXPECT_EQ(positions_by(ReleaseOrder::node, 2), (std::vector{1.0, 1.0, 1.0}));
}

TEST(NearestArc, IsCountedAlongThePathRoundItsCorners) {
  EXPECT_DOUBLE_EQ(nearest_arc(stair(), {1.5, 0.0}), 1.5);
  EXPECT_DOUBLE_EQ(nearest_arc(stair(), {2.5, 2.0}), 3.0);
  EXPECT_DOUBLE_EQ(nearest_arc(stair(), {9.0, 3.0}), 7.0);
}

TEST(CrackPath, HasTheNormalOfThePieceThatIsCrossed) {
  const CrackPath path{{{0, 0}, {1, 0}, {2, 1}}, 1};
  EXPECT_NEAR((normal_between(path, {0.5, -1}, {0.5, 1}) - Eigen::Vector2d(0, 1)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((normal_between(path, {0.5, 1}, {0.6, -1}) - Eigen::Vector2d(0, -1)).norm(), 0.0, 1e-15);
  const Eigen::Vector2d slanted = Eigen::Vector2d(-1, 1).normalized();
  EXPECT_NEAR((normal_between(path, {1.5, 0.2}, {1.5, 0.9}) - slanted).norm(), 0.0, 1e-15);
  EXPECT_NEAR((normal_between(path, {1.2, 0.6}, {1.9, 0.5}) + slanted).norm(), 0.0, 1e-15);
}

}  // namespace
}  // namespace rift::fracture
