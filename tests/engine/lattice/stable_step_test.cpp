#include "engine/lattice/stable_step.hpp"

#include "tests/engine/lattice/dense.hpp"
#include "tests/engine/lattice/hand_made.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace rift::lattice {
namespace {

using hand_made::chain;
using hand_made::damped_everywhere;
using hand_made::Draw;
using hand_made::highest_omega_squared;
using hand_made::jumble;
using hand_made::largest_of;
using hand_made::released;

// Lanczos stays within 1e-5 below omega_max once settled, and the margin is another 1e-5.
constexpr double margin = 3e-5;

void expect_just_below(double given, double limit) {
  EXPECT_LE(given, limit);
  EXPECT_GE(given, limit * (1.0 - margin));
}

/// Two elements whose highest frequency is of the stretch, the twist or the bending, as their inertias make
/// it.
Lattice pair_of(double mass, double inertia) {
  Lattice lattice = chain(2, Eigen::Vector3d(0.6, 0.0, 0.8), {});
  lattice.mass = {mass, 2.0 * mass};
  lattice.inertia = {inertia, inertia};
  return lattice;
}

TEST(StableStep, OfAStretchingPairIsThatOfItsReducedMass) {
  const Lattice pair = pair_of(1.0, 100.0);
  const double omega = std::sqrt(pair.beam[0].axial * 1.5);
  expect_just_below(stable_step(pair).critical, 2.0 / omega);
}

TEST(StableStep, OfABendingPairIsThatOfItsEndsTurningTogether) {
  const Lattice pair = pair_of(1.0, 1e-3);
  const Beam& beam = pair.beam[0];
  // theta_i = theta_j against the chord: w [[2,1],[1,2]] (1,1) = 3 w (1,1), flexibility 2 (1/m_i + 1/m_j) /
  // l^2 + 1/I.
  const double omega = std::sqrt(3.0 * beam.bending * (2.0 * 1.5 / (beam.length * beam.length) + 1e3));
  ASSERT_GT(omega * omega, beam.axial * 1.5);
  expect_just_below(stable_step(pair).critical, 2.0 / omega);
}

TEST(StableStep, OfAClampedChainIsThatOfItsHighestStandingWave) {
  const int free = 30;
  Lattice bar = chain(free + 2, Eigen::Vector3d(0, 1, 0), {});
  bar.grip.front() = packing::Grip::bottom;
  bar.grip.back() = packing::Grip::top;
  for (double& inertia : bar.inertia) inertia = 100.0;  // the stretch governs: 12 E I / l^3 is 3 % of E S / l
  const double omega =
      2.0 * std::sqrt(bar.beam[0].axial / bar.mass[0]) * std::sin(0.5 * std::numbers::pi * free / (free + 1));
  expect_just_below(stable_step(bar).critical, 2.0 / omega);
}

TEST(StableStep, OfARandomLatticeIsThatOfDenseAlgebra) {
  for (const bool gripped : {false, true})
    for (unsigned seed = 51; seed < 55; ++seed) {
      const Lattice lattice = jumble(4, seed, gripped);
      expect_just_below(stable_step(lattice).critical, 2.0 / std::sqrt(highest_omega_squared(lattice)));
    }
}

// Two elements in grips that let them turn: only the bending of the beam between them is left.
TEST(StableStep, OfElementsThatAGripLetsTurnIsThatOfTheirBending) {
  Lattice pair = pair_of(1.0, 1e-3);
  pair.grip = {packing::Grip::bottom, packing::Grip::top};
  EXPECT_TRUE(std::isinf(stable_step(pair).critical));
  pair.grips_turn = true;
  // theta_i = theta_j: w [[2,1],[1,2]] (1,1) = 3 w (1,1), the chord is held.
  const double bending = std::sqrt(3.0 * pair.beam[0].bending * 1e3),
               twist = std::sqrt(pair.beam[0].twist * 2e3);
  expect_just_below(stable_step(pair).critical, 2.0 / std::max(bending, twist));
  EXPECT_LE(stable_step(pair).element_bound, stable_step(pair).critical * (1.0 + margin));
}

TEST(StableStep, HoldsAndNoLongerOnePercentAboveIt) {
  const Lattice lattice = jumble(4, 56, true);
  const double critical = stable_step(lattice).critical;
  Eigen::VectorXd start = Draw(57).state(lattice.centre.size());
  for (std::size_t i = 0; i < lattice.grip.size(); ++i)
    if (lattice.grip[i] != packing::Grip::none) start.segment<6>(6 * static_cast<long>(i)).setZero();
  const auto largest_after = [&](double dt) {
    auto march = released(lattice, ViscousDamping(), dt, start);
    for (int step = 0; step < 2000; ++step) march.step();
    return largest_of(march.q);
  };
  EXPECT_LT(largest_after(0.999 * critical), 100.0);
  EXPECT_GT(largest_after(1.01 * critical), 1e10);  // grows by e^0.28 a step
}

TEST(StableStep, ElementBoundIsSafeAndNotIdle) {
  for (const bool gripped : {false, true})
    for (unsigned seed = 58; seed < 78; ++seed) {
      const Lattice lattice = jumble(3, seed, gripped);
      const double exact = 2.0 / std::sqrt(highest_omega_squared(lattice));
      const double bound = stable_step(lattice).element_bound;
      EXPECT_LE(bound, exact * (1.0 + 1e-12)) << "seed " << seed;  // the rounding of the dense algebra
      EXPECT_GT(bound, 0.3 * exact) << "seed " << seed;
    }
}

TEST(StableStep, ElementBoundOfASingleBeamIsExact) {
  for (const double inertia : {100.0, 0.02, 1e-3}) {
    Lattice pair = pair_of(1.0, inertia);
    EXPECT_NEAR(stable_step(pair).element_bound * std::sqrt(highest_omega_squared(pair)), 2.0, 1e-12);
    pair.grip[0] = packing::Grip::bottom;
    EXPECT_NEAR(stable_step(pair).element_bound * std::sqrt(highest_omega_squared(pair)), 2.0, 1e-12);
  }
}

TEST(StableStep, IsInfiniteWhereNothingCanVibrate) {
  Lattice held = pair_of(1.0, 1.0);
  held.grip = {packing::Grip::bottom, packing::Grip::top};
  EXPECT_TRUE(std::isinf(stable_step(held).critical));
  EXPECT_TRUE(std::isinf(stable_step(held).element_bound));
  EXPECT_TRUE(
      std::isinf(damped_critical_step(held, damped_everywhere(held, 1.0), stable_step(held).critical)));
}

TEST(DampedCriticalStep, OfASingleModeIsTheTextbooks) {
  const Lattice pair = pair_of(1.0, 100.0);
  const double omega = std::sqrt(pair.beam[0].axial * 1.5), undamped = stable_step(pair).critical;
  for (const double zeta : {1e-4, 0.01, 0.2, 1.0}) {
    const double expected = 2.0 / omega * (std::sqrt(1.0 + zeta * zeta) - zeta);
    const double given = damped_critical_step(pair, damped_everywhere(pair, zeta), undamped);
    EXPECT_NEAR(given / expected, 1.0, margin) << "zeta " << zeta;
  }
}

TEST(CriticalStep, StopsBetweenTwoRoundsWhenToldTo) {
  const Lattice lattice = jumble(4, 58, true);
  const double undamped = stable_step(lattice).critical;
  int asked = 0;
  const base::ProgressCallback told = [&](double) { return ++asked < 5; };
  EXPECT_THROW(stable_step(lattice, told), base::Interrupted);
  EXPECT_EQ(asked, 5);
  asked = 0;
  EXPECT_THROW(damped_critical_step(lattice, damped_everywhere(lattice, 0.3), undamped, told),
               base::Interrupted);
  EXPECT_EQ(asked, 5);
}

TEST(DampedCriticalStep, WithoutDampingIsTheCriticalOne) {
  const Lattice lattice = jumble(3, 79, true);
  const double undamped = stable_step(lattice).critical;
  EXPECT_EQ(damped_critical_step(lattice, ViscousDamping(), undamped), undamped);
  EXPECT_NEAR(damped_critical_step(lattice, damped_everywhere(lattice, 0.0), undamped) / undamped, 1.0,
              margin);
}

/// The rates' part of the forces, 6 N x 6 N, for alpha = 1 everywhere.
Eigen::MatrixXd dense_damping(const Lattice& lattice) {
  const long n = 6 * static_cast<long>(lattice.centre.size());
  Eigen::MatrixXd c(n, n);
  for (long k = 0; k < n; ++k) {
    ViscousDamping damping = damped_everywhere(lattice, 1.0);
    const Eigen::VectorXd rate = Eigen::VectorXd::Unit(n, k);
    Eigen::VectorXd f = Eigen::VectorXd::Zero(n);
    double work = 0.0;
    add_damping_forces(damping, rate.data(), nullptr, 1.0, f.data(), work);
    c.col(k) = -f;
  }
  return c;
}

/// dt of dt^2 lambda_max(M^-1 (K + (2/dt) C)) = 4 by dense algebra and bisection.
double dense_limit(const Lattice& lattice, double alpha) {
  const Eigen::MatrixXd k = hand_made::dense_stiffness(lattice), c = alpha * dense_damping(lattice);
  const Eigen::MatrixXd mass = hand_made::mobility(lattice).cwiseInverse().asDiagonal();
  double low = 0.0, high = 10.0;
  for (int halving = 0; halving < 40; ++halving) {
    const double dt = 0.5 * (low + high);
    const double lambda = hand_made::modes_of(k + 2.0 / dt * c, mass).value.maxCoeff();
    (dt * dt * lambda < 4.0 ? low : high) = dt;
  }
  return low;
}

TEST(DampedCriticalStep, OfARandomLatticeIsThatOfDenseAlgebra) {
  for (const double alpha : {2e-4, 0.03, 0.7}) {
    const Lattice lattice = jumble(2, 83, false);
    const double given =
        damped_critical_step(lattice, damped_everywhere(lattice, alpha), stable_step(lattice).critical);
    EXPECT_NEAR(given / dense_limit(lattice, alpha), 1.0, margin) << alpha;
  }
}

TEST(CriticalStep, HasTheSameBitsForAnyNumberOfThreads) {
  const Lattice lattice = jumble(14, 84, true);
  const auto limits = [&](int threads) {
    const double undamped = stable_step(lattice, {}, threads).critical;
    return std::array{undamped,
                      damped_critical_step(lattice, damped_everywhere(lattice, 0.01), undamped, {}, threads)};
  };
  const auto alone = limits(1);
  EXPECT_LT(alone[1], 0.995 * alone[0]);
  for (const int threads : {2, 3}) EXPECT_EQ(limits(threads), alone) << threads;
}

TEST(DampedCriticalStep, HoldsAndNoLongerTwoPercentAboveIt) {
  const Lattice lattice = jumble(4, 80, false);
  const ViscousDamping damping = damped_everywhere(lattice, 0.3);
  const double limit = damped_critical_step(lattice, damping, stable_step(lattice).critical);
  const Eigen::VectorXd start = Draw(81).state(lattice.centre.size());
  const auto largest_rate_after = [&](double dt) {
    auto march = released(lattice, damping, dt, start);
    for (int step = 0; step < 3000; ++step) march.step();
    return largest_of(march.v);
  };
  const double at_first = 2.0 / limit;  // the fastest that a mode of amplitude one moves
  EXPECT_LT(largest_rate_after(0.999 * limit), at_first);
  EXPECT_GT(largest_rate_after(1.02 * limit), 1e6 * at_first);
}

}  // namespace
}  // namespace rift::lattice
