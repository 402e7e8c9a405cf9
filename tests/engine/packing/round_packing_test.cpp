#include "engine/packing/packing.hpp"
#include "engine/packing/specimen.hpp"
#include "engine/packing/structure.hpp"
#include "tests/expectations.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace rift::packing {
namespace {

PackingRequest request(Shape shape, int elements = 600) {
  Box box{1.0, 1.0, 1.0, shape};
  if (shape == Shape::cylinder) box.height = 2.0;
  return {.box = box, .elements = elements, .radius_spread = 0.125, .coordination = 6.0, .seed = 3};
}

/// Root mean square of the net forces over the mean contact force, every pair tried.
double unbalance(const Packing& packing, const Box& box) {
  const std::size_t n = packing.radius.size();
  std::vector<Eigen::Vector3d> net(n);
  double pressed = 0.0, count = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < n; ++i) net[i] = wall_push(box, packing.centre[i], packing.radius[i]);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const Eigen::Vector3d d = minimum_image(box, packing.centre[i], packing.centre[j]);
      const double overlap = packing.radius[i] + packing.radius[j] - d.norm();
      if (overlap <= 0.0) continue;
      net[i] -= overlap * d.normalized(), net[j] += overlap * d.normalized();
      pressed += overlap, count += 1.0;
    }
  for (const auto& f : net) squares += f.squaredNorm() / static_cast<double>(n);
  return std::sqrt(squares) / (pressed / count);
}

TEST(BulkPacking, FillsEveryShapeToItsCoordination) {
  for (const Shape shape : {Shape::cylinder, Shape::sphere, Shape::periodic}) {
    const PackingRequest r = request(shape);
    const Packing packing = pack(r);
    ASSERT_EQ(packing.radius.size(), 600u);
    const PackingStatistics s = statistics(packing, r.box);
    EXPECT_GE(s.coordination, 6.0);
    EXPECT_LT(s.coordination, 6.0 + 0.015 + 2.0 / 600.0);
    EXPECT_GT(s.solid_fraction, 0.58) << static_cast<int>(shape);
    EXPECT_LT(s.solid_fraction, 0.66);
    EXPECT_LT(s.mean_overlap, 0.02);
    EXPECT_LT(unbalance(packing, r.box), 0.05) << static_cast<int>(shape);
    for (const auto& p : not_empty(packing.centre)) EXPECT_TRUE(contains(r.box, p));
  }
}

TEST(BulkPacking, IsTheSameWithAnyThreads) {
  for (const Shape shape : {Shape::cylinder, Shape::periodic}) {
    const Packing one = pack(request(shape), {}, 1), two = pack(request(shape), {}, 2);
    EXPECT_EQ(one.centre, two.centre);
    EXPECT_EQ(one.radius, two.radius);
  }
}

TEST(BulkPacking, HasTheSolidFractionAskedFor) {
  PackingRequest r = request(Shape::block);
  r.solid_fraction = 0.64;
  EXPECT_NEAR(statistics(pack(r), r.box).solid_fraction, 0.64, 1e-12);
}

std::string refusal(const PackingRequest& r) {
  try {
    pack(r);
  } catch (const PackingError& error) {
    return error.what();
  }
  return "packed";
}

TEST(BulkPacking, RefusesSolidFractionsThatAreLooseOrTooDense) {
  PackingRequest r = request(Shape::periodic);
  r.solid_fraction = 0.5;
  EXPECT_EQ(refusal(r),
            "a solid fraction of 0.5 is too low: elements carry load only where they are in contact, from "
            "about 0.63 on");
  r.solid_fraction = 0.79;
  EXPECT_NE(refusal(r).find("a solid fraction of 0.79 is out of reach: it takes a mean overlap of "),
            std::string::npos);
}

TEST(BulkPacking, DrawsLogNormalRadii) {
  PackingRequest r = request(Shape::periodic, 4000);
  r.radii = Radii::log_normal, r.radius_spread = 0.2;
  const Packing packing = pack(r);
  double mean = 0.0, square = 0.0, cube = 0.0;
  for (double radius : packing.radius) mean += std::log(radius) / 4000.0;
  for (double radius : packing.radius) {
    const double d = std::log(radius) - mean;
    square += d * d / 4000.0, cube += d * d * d / 4000.0;
  }
  EXPECT_NEAR(std::sqrt(square), 0.2,
              0.2 * 4.0 / std::sqrt(2.0 * 4000.0));  // four deviations of the estimate
  EXPECT_NEAR(cube / std::pow(0.2, 3.0), 0.0, 4.0 * std::sqrt(6.0 / 4000.0));  // ln r is not skewed
}

TEST(Contacts, GoThroughTheFacesOfAPeriodicBoxOnce) {
  const PackingRequest r = request(Shape::periodic, 300);
  const Packing packing = pack(r);
  std::vector<std::array<int, 2>> tried;
  int through = 0;
  for (int i = 0; i < 300; ++i)
    for (int j = i + 1; j < 300; ++j) {
      const double reach = packing.radius[i] + packing.radius[j];
      if (minimum_image(r.box, packing.centre[i], packing.centre[j]).norm() > reach) continue;
      tried.push_back({i, j});
      through += (packing.centre[i] - packing.centre[j]).norm() > reach;
    }
  EXPECT_GT(through, 50);
  EXPECT_EQ(contacts(packing, r.box, 1.0), tried);
}

TEST(FreeSpecimen, IsWhatHangsTogether) {
  // Two pairs and a loner in a periodic box; the larger cluster, of three, stays.
  const Box box{10.0, 10.0, 10.0, Shape::periodic};
  const Packing packing{.centre = {{1, 1, 1}, {2.9, 1, 1}, {9.2, 1, 1}, {5, 5, 5}, {6.9, 5, 5}, {8, 8, 8}},
                        .radius = {1, 1, 1, 1, 1, 0.2}};
  const Specimen specimen = make_free_specimen(packing, box, 1.0);
  EXPECT_EQ(specimen.centre.size(), 3u);
  EXPECT_EQ(specimen.rattlers, 3);
  using Pairs = std::vector<std::array<int, 2>>;
  EXPECT_EQ(specimen.beam, (Pairs{{0, 1}, {0, 2}}));
}

TEST(FreeSpecimen, NeedsALoadPathFromBottomToTop) {
  const Packing packing{.centre = {{1, 1, 1}, {2.9, 1, 1}, {1, 8, 1}}, .radius = {1, 1, 1}};
  EXPECT_THROW(make_free_specimen(packing, {4, 9, 4}, 1.0), PackingError);
}

/// Unit cubes' corners, 6 x 6 x 6, touching.
Packing cubic() {
  Packing packing;
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y)
      for (int z = 0; z < 6; ++z)
        packing.centre.emplace_back(x + 0.5, y + 0.5, z + 0.5), packing.radius.push_back(0.5000001);
  return packing;
}

TEST(PackingStructure, OfACubicLatticeIsKnown) {
  const PackingStructure s = structure_of(cubic(), {6, 6, 6, Shape::periodic});
  EXPECT_EQ(s.coordination, (std::vector<int>{0, 0, 0, 0, 0, 0, 216}));
  EXPECT_LT((s.fabric - Eigen::Matrix3d::Identity() / 3.0).norm(), 1e-12);
  EXPECT_NEAR(s.fabric_deviation, 0.0, 1e-12);
  // Nothing nearer than one but by the overlap: 6 neighbours of 215 lie in the class below 1, where points at
  // random have 4/3 pi (1 - 0.95^3) / 216, counted with a scatter of 1.6 %.
  EXPECT_EQ(s.pair_correlation[18], 0.0);
  const double random = 4.0 / 3.0 * std::numbers::pi * (1.0 - std::pow(0.95, 3.0)) / 216.0;
  EXPECT_NEAR(s.pair_correlation[19] / (6.0 / 215.0 / random), 1.0, 4 * 0.016);
}

TEST(PackingStructure, WithinWallsIsThatOfPointsAtRandomInTheSameSpace) {
  for (const Shape shape : {Shape::block, Shape::cylinder, Shape::sphere}) {
    const PackingRequest r = request(shape, 1000);
    const PackingStructure s = structure_of(pack(r), r.box);
    double mean = 0.0;
    for (std::size_t k = 30; k < s.pair_correlation.size(); ++k) mean += s.pair_correlation[k] / 20.0;
    EXPECT_NEAR(mean, 1.0, 0.1) << static_cast<int>(shape);  // points of the box around: 1.3 to 1.9
    EXPECT_EQ(s.pair_correlation[10], 0.0);
  }
}

}  // namespace
}  // namespace rift::packing
