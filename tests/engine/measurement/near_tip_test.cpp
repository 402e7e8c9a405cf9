#include "engine/measurement/near_tip.hpp"

#include "engine/theory/references.hpp"
#include "engine/theory/wave_speeds.hpp"
#include "tests/engine/lattice/hand_made.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rift::measurement {
namespace {

constexpr ElasticPlate plate{3.0, 0.3, 2.0, theory::Plane::stress};
const theory::WaveSpeeds waves = theory::wave_speeds(3.0, 0.3, 2.0, theory::Plane::stress);
constexpr double shear_modulus = 0.5 * 3.0 / 1.3;
constexpr Mode modes[] = {Mode::opening, Mode::sliding};

/// Second derivatives of a component by differences: xx, xy, yy.
std::array<double, 3> second(const NearTip& field, Mode mode, int n, int component,
                             const Eigen::Vector2d& at) {
  constexpr double h = 1e-3;
  const auto u = [&](double x, double y) {
    return field.displacement(mode, n, at + Eigen::Vector2d(x, y))[component];
  };
  return {(u(h, 0) - 2 * u(0, 0) + u(-h, 0)) / (h * h),
          (u(h, h) - u(h, -h) - u(-h, h) + u(-h, -h)) / (4 * h * h),
          (u(0, h) - 2 * u(0, 0) + u(0, -h)) / (h * h)};
}

/// Stress by differences: xx, xy, yy, plane stress.
std::array<double, 3> stress(const NearTip& field, Mode mode, int n, const Eigen::Vector2d& at) {
  constexpr double h = 1e-5;
  const auto slope = [&](const Eigen::Vector2d& way) -> Eigen::Vector2d {
    return (field.displacement(mode, n, at + h * way) - field.displacement(mode, n, at - h * way)) / (2 * h);
  };
  const Eigen::Vector2d by_x = slope({1, 0}), by_y = slope({0, 1});
  const double e = 3.0 / (1.0 - 0.3 * 0.3);
  return {e * (by_x.x() + 0.3 * by_y.y()), shear_modulus * (by_y.x() + by_x.y()),
          e * (by_y.y() + 0.3 * by_x.x())};
}

// c_d^2 grad div u - c_s^2 rot rot u = v^2 u_xx, around any point and for every term.
TEST(NearTip, MovesByTheWaveEquation) {
  for (const double v : {0.2, 0.5, 0.85}) {
    const double speed = v * waves.rayleigh;
    const NearTip field(plate, speed);
    const double d2 = waves.dilatational * waves.dilatational, s2 = waves.shear * waves.shear;
    for (const Mode mode : modes)
      for (int n = 1; n <= 6; ++n)
        for (const Eigen::Vector2d& at :
             {Eigen::Vector2d(0.7, 0.4), Eigen::Vector2d(-0.5, 0.6), Eigen::Vector2d(-0.8, -0.3)}) {
          const auto x = second(field, mode, n, 0, at), y = second(field, mode, n, 1, at);
          const double size = d2 * field.displacement(mode, n, at).norm() / at.squaredNorm();
          EXPECT_NEAR(d2 * (x[0] + y[1]) + s2 * (x[2] - y[1]), speed * speed * x[0], 1e-5 * size)
              << v << ' ' << n;
          EXPECT_NEAR(d2 * (x[1] + y[2]) + s2 * (y[0] - x[1]), speed * speed * y[0], 1e-5 * size)
              << v << ' ' << n;
        }
  }
}

TEST(NearTip, LeavesTheFacesFree) {
  const NearTip field(plate, 0.5 * waves.rayleigh);
  for (const Mode mode : modes)
    for (int n = 1; n <= 6; ++n)
      for (const double y : {1e-9, -1e-9}) {
        const auto beside = stress(field, mode, n, {0.3, 0.6}),
                   at = stress(field, mode, n, {-0.7, y + (y > 0 ? 1e-4 : -1e-4)});
        const double size = std::abs(beside[0]) + std::abs(beside[1]) + std::abs(beside[2]) + 1e-6;
        EXPECT_NEAR(at[1], 0.0, 3e-3 * size) << n;
        EXPECT_NEAR(at[2], 0.0, 3e-3 * size) << n;
      }
}

// What K means: sigma_yy (2 pi r)^1/2 = K_I ahead of the tip, sigma_xy (2 pi r)^1/2 = K_II.
TEST(NearTip, HasUnitStressIntensityAhead) {
  for (const double v : {0.1, 0.5, 0.9}) {
    const NearTip field(plate, v * waves.rayleigh);
    constexpr double r = 0.04;
    const double factor = std::sqrt(2.0 * std::numbers::pi * r);
    EXPECT_NEAR(factor * stress(field, Mode::opening, 1, {r, 0})[2], 1.0, 1e-5);
    EXPECT_NEAR(factor * stress(field, Mode::opening, 1, {r, 0})[1], 0.0, 1e-5);
    EXPECT_NEAR(factor * stress(field, Mode::sliding, 1, {r, 0})[1], 1.0, 1e-5);
    EXPECT_NEAR(factor * stress(field, Mode::sliding, 1, {r, 0})[2], 0.0, 1e-5);
  }
}

// G = A_I K^2 / E', with A_I from the references.
TEST(NearTip, ReleasesWhatTheReferencesSay) {
  for (const double v : {0.1, 0.5, 0.9}) {
    const NearTip field(plate, v * waves.rayleigh);
    const double expected = theory::release_rate_function(v, 0.3, theory::Plane::stress) / 3.0;
    EXPECT_NEAR(field.release_rate(1.0, 0.0), expected, 1e-9 * expected);
  }
  EXPECT_NEAR(NearTip(plate, 0.0).release_rate(0.0, 1.0), 1.0 / 3.0, 2e-3 / 3.0);  // K^2 / E' at rest
}

// Irwin's closure: the stress ahead, K / (2 pi r)^1/2, works on the opening behind, c r^1/2.
TEST(NearTip, ReleasesTheWorkOfClosingIt) {
  for (const double v : {0.2, 0.5, 0.9}) {
    const NearTip field(plate, v * waves.rayleigh);
    const auto jump = [&](Mode mode, int component) {
      return field.displacement(mode, 1, {-1.0, 0.0})[component] -
             field.displacement(mode, 1, {-1.0, -0.0})[component];
    };
    const double per_jump = 0.25 * std::numbers::pi / std::sqrt(2.0 * std::numbers::pi);
    EXPECT_NEAR(field.release_rate(1, 0), per_jump * jump(Mode::opening, 1), 1e-9);
    EXPECT_NEAR(field.release_rate(0, 1), per_jump * jump(Mode::sliding, 0), 1e-9);
  }
}

/// A disc of points, and a field of all terms with noise.
struct Seen {
  std::vector<Eigen::Vector2d> at, moved;
  Seen(const NearTip& field, double k_one, double k_two, double noise) {
    lattice::hand_made::Draw draw(7);
    for (int i = 0; i < 900; ++i) {
      const Eigen::Vector2d p(draw.between(-0.02, 0.02), draw.between(-0.02, 0.02));
      Eigen::Vector2d u = Eigen::Vector2d(1e-3, -2e-3) + 0.01 * Eigen::Vector2d(-p.y(), p.x());
      u += k_one * field.displacement(Mode::opening, 1, p) + k_two * field.displacement(Mode::sliding, 1, p);
      u += 2.0 * k_one * field.displacement(Mode::opening, 2, p) +
           9.0 * k_one * field.displacement(Mode::opening, 3, p);
      at.push_back(p);
      moved.push_back(u + noise * Eigen::Vector2d(draw.between(-1, 1), draw.between(-1, 1)));
    }
  }
};
constexpr IntensityFit ring{0.004, 0.016, 0.001, 6};

TEST(FitIntensity, FindsWhatTheFieldWasMadeOf) {
  for (const double v : {0.0, 0.3, 0.8}) {
    const NearTip field(plate, v * waves.rayleigh);
    const Seen seen(field, 0.02, -0.005, 0.0);
    const auto k = fit_intensity(field, seen.at, seen.moved, ring);
    ASSERT_TRUE(k);
    EXPECT_NEAR(k->opening, 0.02, 1e-8);
    EXPECT_NEAR(k->sliding, -0.005, 1e-8);
    EXPECT_LT(k->misfit, 1e-8);
    EXPECT_NEAR(k->release_rate, field.release_rate(0.02, -0.005), 1e-9);
  }
}

TEST(FitIntensity, ScattersByTheNoiseAndSaysSo) {
  const NearTip field(plate, 0.4 * waves.rayleigh);
  const Seen clean(field, 0.02, 0.0, 0.0);
  double spread = 0.0;
  for (const Eigen::Vector2d& u : clean.moved) spread = std::max(spread, (u - clean.moved[0]).norm());
  const Seen noisy(field, 0.02, 0.0, 0.01 * spread);
  const auto k = fit_intensity(field, noisy.at, noisy.moved, ring);
  ASSERT_TRUE(k);
  EXPECT_NEAR(k->opening, 0.02, 0.1 * 0.02);
  EXPECT_GT(std::abs(k->opening - 0.02), 1e-6);
  EXPECT_GT(k->misfit, 1e-3);
}

TEST(FitIntensity, SaysNothingOfTooFewPoints) {
  const NearTip field(plate, 0.3 * waves.rayleigh);
  Seen seen(field, 0.02, 0.0, 0.0);
  IntensityFit narrow = ring;
  narrow.outer = 0.0045;
  EXPECT_FALSE(fit_intensity(field, seen.at, seen.moved, narrow));
}

TEST(LocateIntensity, FindsTheTipOfTheField) {
  const NearTip field(plate, 0.4 * waves.rayleigh);
  Seen seen(field, 0.02, -0.005, 0.0);
  for (const double ahead : {-0.0023, 0.0, 0.0014}) {
    std::vector<Eigen::Vector2d> from_crack(seen.at);
    for (Eigen::Vector2d& p : from_crack) p.x() += ahead;
    const auto k = locate_intensity(field, from_crack, seen.moved, ring, {0.004, 0.004});
    ASSERT_TRUE(k) << ahead;
    EXPECT_NEAR(k->ahead, ahead, 1e-4);
    EXPECT_NEAR(k->opening, 0.02, 0.01 * 0.02);
    EXPECT_NEAR(k->sliding, -0.005, 0.01 * 0.02);
  }
}

TEST(LocateIntensity, SaysNothingOfATipOutOfReach) {
  const NearTip field(plate, 0.4 * waves.rayleigh);
  Seen seen(field, 0.02, 0.0, 0.0);
  for (Eigen::Vector2d& p : seen.at) p.x() += 0.003;
  EXPECT_FALSE(locate_intensity(field, seen.at, seen.moved, ring, {0.002, 0.002}));
}

}  // namespace
}  // namespace rift::measurement
