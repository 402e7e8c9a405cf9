#include "engine/measurement/intensity.hpp"

#include "engine/theory/wave_speeds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rift::measurement {
namespace {

constexpr ElasticPlate polymer{3.0, 0.3, 2.0, theory::Plane::stress};
const double own_rayleigh =
    theory::wave_speeds(polymer.young_modulus, polymer.poisson_ratio, polymer.density, polymer.plane).rayleigh;
const Eigen::Vector2d size(0.1, 0.05);
constexpr Ring seen_ring{.inner = 0.003, .outer = 0.012, .beside_faces = 0.001, .zone = 0.0};
const fracture::RateScale scale{.thickness = 0.01, .g_i0 = 2.0, .length = 0.1};

/// Books of a tip that runs at `speed` from x = 0 and releases 1.5 J/m2.
std::vector<results::Sample> samples(double speed) {
  std::vector<results::Sample> rows;
  for (int k = 0; k <= 100; ++k) {
    results::Sample row{.step = k, .time_s = 0.001 * k / speed};
    row.tip_m = 0.001 * k, row.velocity_m_s = speed;
    row.elastic_j = 10.0 - 1.5 * scale.thickness * row.tip_m;
    rows.push_back(row);
  }
  return rows;
}

/// The field of K_I = 0.02, K_II = 0.004 around a tip of the plate that runs along `along`.
SeenField field_around(const Eigen::Vector2d& tip, const Eigen::Vector2d& along, double speed,
                       const std::vector<Eigen::Vector2d>& points) {
  const NearTip near(polymer, speed);
  const Eigen::Vector2d across(-along.y(), along.x());
  SeenField seen;
  for (const Eigen::Vector2d& p : points) {
    const Eigen::Vector2d from(along.dot(p - tip), across.dot(p - tip));
    const Eigen::Vector2d u =
        0.02 * near.displacement(Mode::opening, 1, from) + 0.004 * near.displacement(Mode::sliding, 1, from);
    lattice::PlaneMotion motion;
    motion.u.head<2>() = u.x() * along + u.y() * across;
    seen.motion.emplace_back(motion);
  }
  return seen;
}

IntensityPoint read(const fracture::CrackPath& path, double arc, double speed) {
  const Grid grid = grid_over(size.x(), size.y(), 0.001);
  const Eigen::Vector2d along =
      (fracture::point_on(path, arc) - fracture::point_on(path, arc - 1e-6)).normalized();
  SeenField seen = field_around(fracture::point_on(path, arc), along, speed, grid.point);
  seen.time = arc / speed, seen.tip = arc;
  return IntensityReading(path, size, polymer, own_rayleigh, seen_ring, samples(speed), scale).at(seen, grid.point);
}

TEST(IntensityReading, FindsKInTheAxesOfTheCrack) {
  const double speed = 0.4 * theory::wave_speeds(3.0, 0.3, 2.0, theory::Plane::stress).rayleigh;
  const fracture::CrackPath kinked{{{0.0, 0.015}, {0.02, 0.015}, {0.1, 0.045}}};
  for (const fracture::CrackPath& path : {fracture::straight_path(0.1, 0.025), kinked}) {
    const IntensityPoint point = read(path, 0.055, speed);
    ASSERT_TRUE(point.k);
    EXPECT_NEAR(point.k->opening, 0.02, 1e-4);
    EXPECT_NEAR(point.k->sliding, 0.004, 1e-4);
    EXPECT_NEAR(point.k->ahead, 0.0, 2e-4);
    EXPECT_NEAR(point.over_cr, 0.4, 1e-9);
    EXPECT_NEAR(point.g_id, 1.5, 1e-9);
  }
}

TEST(IntensityReading, StaysOffTheEdgesAndOffABendOfThePath) {
  const double speed = 0.4 * theory::wave_speeds(3.0, 0.3, 2.0, theory::Plane::stress).rayleigh;
  const fracture::CrackPath straight = fracture::straight_path(0.1, 0.025),
                            kinked{{{0.0, 0.01}, {0.05, 0.01}, {0.1, 0.05}}};
  const int all = read(straight, 0.05, speed).k->points, fewer = read(straight, 0.01, speed).k->points;
  EXPECT_LT(fewer, 0.8 * all);
  EXPECT_EQ(read(straight, 0.003, speed).why, NoFit::edge) << "nearer than the ring";
  EXPECT_FALSE(read(straight, 0.0975, speed).k);
  EXPECT_EQ(read(kinked, 0.053, speed).why, NoFit::bend) << "nearer than the ring";
  EXPECT_TRUE(read(kinked, 0.065, speed).k);
}

// The zone lies ahead of where its beams are gone: so does the field's tip.
TEST(IntensityReading, LooksForTheFieldsTipThroughTheDamageZone) {
  const double speed = 0.4 * theory::wave_speeds(3.0, 0.3, 2.0, theory::Plane::stress).rayleigh;
  const Grid grid = grid_over(size.x(), size.y(), 0.001);
  const fracture::CrackPath path = fracture::straight_path(0.1, 0.025);
  SeenField seen = field_around({0.055, 0.025}, {1, 0}, speed, grid.point);
  seen.tip = 0.05, seen.time = 0.05 / speed;
  const auto read_with = [&](double zone) {
    Ring longer = seen_ring;
    longer.zone = zone;
    return IntensityReading(path, size, polymer, own_rayleigh, longer, samples(speed), scale).at(seen, grid.point);
  };
  EXPECT_EQ(read_with(0.0).why, NoFit::tip);
  const IntensityPoint found = read_with(0.006);
  ASSERT_TRUE(found.k);
  EXPECT_NEAR(found.k->ahead, 0.005, 3e-4);
  EXPECT_NEAR(found.k->opening, 0.02, 4e-4);
}

TEST(IntensityReading, OfTwoTipsStaysOffTheOther) {
  const double speed = 0.4 * theory::wave_speeds(3.0, 0.3, 2.0, theory::Plane::stress).rayleigh;
  const Grid grid = grid_over(size.x(), size.y(), 0.001);
  const fracture::CrackPath path = fracture::straight_path(0.1, 0.025, 2);
  for (const double half : {-0.002, 0.001, 0.02}) {
    SeenField seen = field_around({0.05 + half, 0.025}, {1, 0}, speed, grid.point);
    seen.tip = half, seen.time = std::max(half, 0.0) / speed;
    const IntensityPoint point =
        IntensityReading(path, size, polymer, own_rayleigh, seen_ring, samples(speed), scale).at(seen, grid.point);
    EXPECT_EQ(point.k.has_value(), half > 0.01) << half;
    if (!point.k) {
      EXPECT_EQ(point.why, NoFit::other_tip);
    }
  }
}

TEST(IntensityReading, SaysNothingOfATipAsFastAsTheSurfaceWave) {
  const double c_r = theory::wave_speeds(3.0, 0.3, 2.0, theory::Plane::stress).rayleigh;
  const Grid grid = grid_over(size.x(), size.y(), 0.001);
  SeenField seen = field_around({0.05, 0.025}, {1, 0}, 0.9 * c_r, grid.point);
  seen.tip = 0.05, seen.time = 0.05 / c_r;
  const IntensityReading reading(fracture::straight_path(0.1, 0.025), size, polymer, own_rayleigh, seen_ring, samples(c_r),
                                 scale);
  EXPECT_EQ(reading.at(seen, grid.point).why, NoFit::fast);
}

TEST(PartedBy, TellsWhereTheTipMustBeWithOneTipAndWithTwo) {
  const Eigen::Vector2d below(0.06, 0.02), above(0.06, 0.03), far(0.08, 0.03);
  EXPECT_NEAR(parted_by(fracture::straight_path(0.1, 0.025))(below, above), 0.06, 1e-12);
  EXPECT_NEAR(parted_by(fracture::straight_path(0.1, 0.025, 2))(below, above), 0.01, 1e-12);
  EXPECT_EQ(parted_by(fracture::straight_path(0.1, 0.025))(above, far),
            std::numeric_limits<double>::infinity());
  EXPECT_NEAR(arc_of_tip(fracture::straight_path(0.1, 0.025, 2), 0.01), 0.06, 1e-12);
  EXPECT_NEAR(arc_of_tip(fracture::straight_path(0.1, 0.025), 0.01), 0.01, 1e-12);
}

}  // namespace
}  // namespace rift::measurement
