#include "engine/packing/packing.hpp"

#include "engine/base/interrupted.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rift::packing {
namespace {

/// A piece of the paper's plate, a twentieth of its elements.
PackingRequest plate_piece() {
  return {.box = {.length = 25e-3, .height = 16e-3, .thickness = 2e-3},
          .elements = 1000,
          .radius_spread = 0.125,
          .coordination = 6.0,
          .seed = 7};
}

PackingRequest small_box() {
  return {.box = {.length = 5.0, .height = 6.0, .thickness = 7.0},
          .elements = 300,
          .radius_spread = 0.1,
          .coordination = 6.0,
          .seed = 1};
}

/// Overlaps weighed by hand, every pair tried: unit stiffness between spheres, and a wall that pushes as the
/// sphere's mirror image behind it would.
struct Balance {
  int contacts = 0;
  double mean_force = 0;    // of the contacts between spheres
  double rms_net = 0;       // of the forces left on the spheres
  double mean_overlap = 0;  // of r_i + r_j
};

Balance weigh(const Packing& packing, const Box& box) {
  const int n = static_cast<int>(packing.radius.size());
  const Eigen::Vector3d size(box.length, box.height, box.thickness);
  std::vector<Eigen::Vector3d> net(n, Eigen::Vector3d::Zero());
  Balance balance;
  const auto overlap_force = [](const Eigen::Vector3d& at, double r, const Eigen::Vector3d& other,
                                double r_other) {
    const double distance = (at - other).norm();
    return Eigen::Vector3d((at - other) / distance * std::max(0.0, r + r_other - distance));
  };
  for (int i = 0; i < n; ++i) {
    const Eigen::Vector3d& p = packing.centre[i];
    const double r = packing.radius[i];
    for (int j = i + 1; j < n; ++j) {
      const Eigen::Vector3d f = overlap_force(p, r, packing.centre[j], packing.radius[j]);
      if (f.isZero(0.0)) continue;
      net[i] += f, net[j] -= f;
      ++balance.contacts;
      balance.mean_force += f.norm();
      balance.mean_overlap += f.norm() / (r + packing.radius[j]);
    }
    for (int c = 0; c < 3; ++c)
      for (const double wall : {0.0, size[c]}) {
        Eigen::Vector3d image = p;
        image[c] = 2.0 * wall - p[c];
        net[i] += overlap_force(p, r, image, r);
      }
  }
  for (const auto& f : net) balance.rms_net += f.squaredNorm();
  balance.rms_net = std::sqrt(balance.rms_net / n);
  balance.mean_force /= balance.contacts;
  balance.mean_overlap /= balance.contacts;
  return balance;
}

TEST(Packing, RestsAtTheCoordinationAskedFor) {
  for (const double coordination : {6.0, 5.5}) {
    PackingRequest request = plate_piece();
    request.coordination = coordination;
    const Packing packing = pack(request);
    ASSERT_EQ(packing.radius.size(), 1000u);
    const Balance balance = weigh(packing, request.box);
    const double z = 2.0 * balance.contacts / 1000.0;
    EXPECT_GE(z, coordination);
    EXPECT_LE(z, coordination + 0.02);
    // Converged to 1e-6 of the mean contact force; what the packing's own units round is far below.
    EXPECT_LT(balance.rms_net, 1.001e-6 * balance.mean_force);
    EXPECT_GT(balance.mean_overlap, 0.0);
    EXPECT_LE(balance.mean_overlap, 0.04);
  }
}

TEST(Packing, FillsItsBoxWithSpheresInside) {
  const PackingRequest request = plate_piece();
  const Packing packing = pack(request);
  const Eigen::Array3d size(request.box.length, request.box.height, request.box.thickness);
  double solid = 0.0, deepest = 0.0;
  Eigen::Array3d low = size, high = Eigen::Array3d::Zero();
  ASSERT_FALSE(packing.radius.empty());
  for (std::size_t i = 0; i < packing.radius.size(); ++i) {
    const Eigen::Array3d p = packing.centre[i].array();
    ASSERT_TRUE((p > 0.0).all() && (p < size).all()) << "element " << i;
    const double r = packing.radius[i];
    low = low.min(p - r), high = high.max(p + r);
    deepest = std::max({deepest, (r - p).maxCoeff() / r, (r - (size - p)).maxCoeff() / r});
    solid += 4.0 / 3.0 * std::numbers::pi * r * r * r;
  }
  // Every wall is touched, and pressed as little as the spheres press each other (some per cent of a radius).
  EXPECT_TRUE((low < 0.0).all() && (high > size).all());
  EXPECT_LT(deepest, 0.3);
  EXPECT_GT(solid / request.box.volume(), 0.59);
  EXPECT_LT(solid / request.box.volume(), 0.66);
}

TEST(Packing, HasRadiiUniformWithinTheSpread) {
  const Packing packing = pack(plate_piece());
  std::vector<double> shape = packing.radius;
  std::sort(shape.begin(), shape.end());
  const double mean = 0.5 * (shape.front() + shape.back());
  double distance = 0.0;  // of Kolmogorov and Smirnov
  for (std::size_t k = 0; k < shape.size(); ++k) {
    const double uniform = (shape[k] / mean - 0.875) / 0.25, step = static_cast<double>(k) / 1000.0;
    distance = std::max({distance, std::abs(uniform - step), std::abs(uniform - step - 1e-3)});
  }
  EXPECT_LT(distance, 1.95 / std::sqrt(1000.0));  // one seed in a thousand would fail, by chance
  EXPECT_NEAR(shape.back() / shape.front(), 1.125 / 0.875, 0.01);
  // Size and place know nothing of each other: the mean radius of the left half is that of the right one.
  double left = 0.0, right = 0.0, count_left = 0.0, count_right = 0.0;
  for (std::size_t i = 0; i < packing.radius.size(); ++i) {
    const bool is_left = packing.centre[i].x() < 12.5e-3;
    (is_left ? left : right) += packing.radius[i];
    (is_left ? count_left : count_right) += 1.0;
  }
  // The standard error of the difference is 0.072 mean x sqrt(2 / 500) = 0.0046 mean.
  EXPECT_NEAR(left / count_left / mean, right / count_right / mean, 4 * 0.0046);
  EXPECT_NEAR(count_left / 1000.0, 0.5, 0.03);
}

TEST(Packing, OfOneSeedHasTheSameBits) {
  const Packing once = pack(small_box()), again = pack(small_box());
  EXPECT_EQ(once.radius, again.radius);
  EXPECT_EQ(once.centre, again.centre);
}

TEST(Packing, OfAnotherSeedIsAnother) {
  PackingRequest other = small_box();
  other.seed = 2;
  const Packing a = pack(small_box()), b = pack(other);
  double nearest = 1e300;  // of the first element's twin in the other packing
  for (const auto& p : b.centre) nearest = std::min(nearest, (p - a.centre[0]).norm());
  EXPECT_GT(nearest, 1e-3 * a.radius[0]);
  EXPECT_NE(a.radius, b.radius);
}

TEST(Packing, IsTheSameInAnyUnit) {
  PackingRequest thousandfold = small_box();
  thousandfold.box = {.length = 5e3, .height = 6e3, .thickness = 7e3};
  const Packing a = pack(small_box()), b = pack(thousandfold);
  // The walk to the minimum amplifies roundings, so it is the outcome that agrees, not the places.
  EXPECT_NEAR(statistics(b, thousandfold.box).mean_radius / statistics(a, small_box().box).mean_radius, 1e3,
              5.0);
}

TEST(Packing, RefusesACoordinationOutOfReach) {
  PackingRequest request = small_box();
  request.coordination = 9.0;
  try {
    pack(request);
    FAIL() << "packed";
  } catch (const PackingError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find("a coordination of 9 is out of reach: at a mean overlap of 4."), 0u) << message;
    EXPECT_NE(message.find(" % of r_i + r_j, of which 4 % is the limit, it is "), std::string::npos)
        << message;
    ASSERT_TRUE(error.nearest);
    EXPECT_GT(*error.nearest, 5.0);
    EXPECT_LT(*error.nearest, 9.0);
  }
}

TEST(Packing, TellsHowFarItIs) {
  std::vector<double> told;
  pack(small_box(), [&](double done) {
    told.push_back(done);
    return true;
  });
  ASSERT_GT(told.size(), 10u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_GE(told.front(), 0.0);
  EXPECT_LE(told.back(), 1.0);
  EXPECT_GT(told.back(), told.front());
}

TEST(Packing, StopsWhenToldTo) {
  for (const int patience : {0, 5, 20}) {
    int asked = 0;
    try {
      pack(small_box(), [&](double) { return asked++ < patience; });
      FAIL() << "went on";
    } catch (const base::Interrupted& stop) {
      EXPECT_STREQ(stop.what(), "stopped while packing");
    }
    EXPECT_EQ(asked, patience + 1);
  }
}

TEST(Packing, ListsElementsInRowsThatFollowEachOther) {
  const Packing packing = pack(plate_piece());
  double furthest_step = 0.0;
  for (std::size_t k = 1; k < packing.centre.size(); ++k)
    furthest_step = std::max(furthest_step, packing.centre[k - 1].x() - packing.centre[k].x());
  EXPECT_LT(furthest_step, 2.1 * packing.radius[0] * 1.15);  // never back by more than a column's width
}

/// Four unit spheres: 0 and 1 overlap by 10 %, 1 and 2 just touch, 3 is 5 % away from 2.
Packing row() {
  return {.centre = {{1.0, 1.0, 1.0}, {2.8, 1.0, 1.0}, {4.8, 1.0, 1.0}, {6.9, 1.0, 1.0}},
          .radius = {1.0, 1.0, 1.0, 1.0}};
}

TEST(Contacts, ReachAsFarAsTheirTolerance) {
  using Pairs = std::vector<std::array<int, 2>>;
  Packing packing = row();
  EXPECT_EQ(contacts(packing, {}, 0.95), (Pairs{{0, 1}}));
  EXPECT_EQ(contacts(packing, {}, 1.001), (Pairs{{0, 1}, {1, 2}}));
  EXPECT_EQ(contacts(packing, {}, 1.049), (Pairs{{0, 1}, {1, 2}}));
  EXPECT_EQ(contacts(packing, {}, 1.051), (Pairs{{0, 1}, {1, 2}, {2, 3}}));
  packing.radius[3] = 1.2;
  EXPECT_EQ(contacts(packing, {}, 1.001), (Pairs{{0, 1}, {1, 2}, {2, 3}}));
}

TEST(PackingStatistics, AreThoseOfARowCountedByHand) {
  Packing packing = row();
  packing.centre.pop_back(), packing.radius.pop_back();
  packing.centre[2].x() -= 0.1;  // overlaps by 5 %
  const PackingStatistics s = statistics(packing, {.length = 10.0, .height = 2.0, .thickness = 4.0});
  EXPECT_NEAR(s.coordination, 4.0 / 3.0, 1e-15);
  EXPECT_NEAR(s.mean_overlap, 0.5 * (0.1 + 0.05), 1e-15);
  EXPECT_NEAR(s.mean_radius, 1.0, 1e-15);
  EXPECT_NEAR(s.solid_fraction, 3.0 * 4.0 / 3.0 * std::numbers::pi / 80.0, 1e-15);
}

TEST(PackingStatistics, OfSpheresApartAreOfNoOverlap) {
  const PackingStatistics s = statistics({.centre = {{1, 1, 1}, {5, 1, 1}}, .radius = {1, 0.5}},
                                         {.length = 8, .height = 2, .thickness = 2});
  EXPECT_NEAR(s.coordination, 0.0, 1e-300);
  EXPECT_NEAR(s.mean_overlap, 0.0, 1e-300);
  EXPECT_NEAR(s.mean_radius, 0.75, 1e-15);
  EXPECT_NEAR(s.solid_fraction, 4.0 / 3.0 * std::numbers::pi * (1.0 + 0.125) / 32.0, 1e-15);
}

}  // namespace
}  // namespace rift::packing
