#include "engine/lattice/forces.hpp"
#include "tests/engine/lattice/dense.hpp"
#include "tests/engine/lattice/hand_made.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>

namespace rift::lattice {
namespace {

using hand_made::all_damped;
using hand_made::damped_everywhere;
using hand_made::Draw;
using hand_made::jumble;
using hand_made::released;

/// Two elements and a beam between them; the masses differ, the inertias as told.
Lattice pair_of(double inertia_j) {
  Lattice lattice = hand_made::chain(2, Eigen::Vector3d(1, 2, -2) / 3.0, {});
  lattice.mass = {1.0, 2.5};
  lattice.inertia = {0.1, inertia_j};
  return lattice;
}

/// A motion of element j that excites one mode, and the frequency of that mode.
struct SingleMode {
  const char* name;
  Lattice lattice;
  Vector6 direction;
  double omega;
};

SingleMode stretching() {
  SingleMode mode{"stretching", pair_of(0.3), Vector6::Zero(), 0.0};
  mode.direction.head<3>() = mode.lattice.beam[0].axis;
  mode.omega = std::sqrt(mode.lattice.beam[0].axial * (1.0 + 1.0 / 2.5));
  return mode;
}

SingleMode twisting() {
  SingleMode mode{"twisting", pair_of(0.3), Vector6::Zero(), 0.0};
  mode.direction.tail<3>() = mode.lattice.beam[0].axis;
  mode.omega = std::sqrt(mode.lattice.beam[0].twist * (1.0 / 0.1 + 1.0 / 0.3));
  return mode;
}

/// Equal inertias turning against each other across the axis: no chord rotation, no shear; the moment is w
/// (theta_j - theta_i) / 2.
SingleMode bending() {
  SingleMode mode{"bending", pair_of(0.1), Vector6::Zero(), 0.0};
  mode.direction.tail<3>() = mode.lattice.beam[0].axis.unitOrthogonal();
  mode.omega = std::sqrt(0.5 * mode.lattice.beam[0].bending * 20.0);
  return mode;
}

/// Calls look(t, distance of the ends along the mode) at steps of 1e-4 / omega, for 8 / omega, from distance
/// 1 at rest.
void release(const SingleMode& mode, double alpha, const std::function<void(double, double)>& look) {
  Eigen::VectorXd start = Eigen::VectorXd::Zero(12);
  start.head<6>() = -0.5 * mode.direction;
  start.tail<6>() = 0.5 * mode.direction;
  auto march = released(mode.lattice, damped_everywhere(mode.lattice, alpha), 1e-4 / mode.omega, start);
  for (int n = 1; n <= 80'000; ++n) {
    march.step();
    look(n * 1e-4, mode.direction.dot(march.motion(march.q, 1) - march.motion(march.q, 0)));
  }
}

TEST(CriticalDamping, ReturnsWithoutOvershoot) {
  // x'' + 2 omega x' + omega^2 x = 0 from rest: (1 + omega t) exp(-omega t), 3e-3 at the end. The damping
  // force trails by half a step, an error of the order of omega dt = 1e-4.
  for (const SingleMode& mode : {stretching(), twisting(), bending()}) {
    double worst = 0.0, least = 1.0;
    release(mode, 1.0, [&](double t, double x) {
      worst = std::max(worst, std::abs(x - (1.0 + t) * std::exp(-t)));
      least = std::min(least, x);
    });
    EXPECT_NEAR(worst, 0.0, 1e-4) << mode.name;
    EXPECT_GT(least, 0.0) << mode.name;
  }
}

TEST(CriticalDamping, IsTheLeastThatDoesSo) {
  // At 0.8 of critical the first overshoot is exp(-pi 0.8 / 0.6) = 1.5 %, at omega t = pi / 0.6 = 5.2.
  for (const SingleMode& mode : {stretching(), twisting(), bending()}) {
    double least = 1.0;
    release(mode, 0.8, [&](double, double x) { least = std::min(least, x); });
    EXPECT_NEAR(least, -std::exp(-std::numbers::pi * 0.8 / 0.6), 1e-4) << mode.name;
  }
}

/// Damping forces on a lattice at the given rates, of one step from rest.
Eigen::VectorXd damping_forces(const Lattice& lattice, const Eigen::VectorXd& rate) {
  ViscousDamping damping = damped_everywhere(lattice, 0.5);
  double work = 0.0;
  Eigen::VectorXd f = Eigen::VectorXd::Zero(rate.size());
  add_damping_forces(damping, rate.data(), nullptr, 0.1, f.data(), work);
  return f;
}

TEST(Damping, LeavesARigidMotionAlone) {
  const Lattice lattice = jumble(3, 31, false);
  Draw draw(32);
  const Eigen::Vector3d shift = draw.vector(), turn = draw.vector(), pivot = 2.0 * draw.vector();
  Eigen::VectorXd rate(6 * static_cast<long>(lattice.centre.size()));
  for (std::size_t i = 0; i < lattice.centre.size(); ++i)
    rate.segment<6>(6 * static_cast<long>(i)) = hand_made::rigid(lattice.centre[i], shift, turn, pivot);
  const double typical = damping_forces(lattice, draw.state(lattice.centre.size())).cwiseAbs().maxCoeff();
  EXPECT_NEAR(damping_forces(lattice, rate).cwiseAbs().maxCoeff(), 0.0, 1e-14 * typical);
}

TEST(Damping, KeepsMomentumAndAngularMomentum) {
  const Lattice lattice = jumble(3, 33, false);
  Draw draw(34);
  const Eigen::VectorXd f = damping_forces(lattice, draw.state(lattice.centre.size()));
  EXPECT_NEAR(hand_made::resultant(lattice, f, 3.0 * draw.vector()).norm(), 0.0, 1e-13 * f.norm());
}

TEST(Damping, OpposesTheRates) {
  const Lattice lattice = jumble(3, 35, false);
  Draw draw(36);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::VectorXd rate = draw.state(lattice.centre.size());
    EXPECT_LT(rate.dot(damping_forces(lattice, rate)), 0.0);
  }
}

TEST(Damping, BooksTheMeanForceOfAStepTimesItsMotion) {
  const Lattice lattice = jumble(3, 37, false);
  Draw draw(38);
  const double dt = 0.1;
  ViscousDamping damping = damped_everywhere(lattice, 0.3);
  double work = 0.0;
  Eigen::VectorXd before = Eigen::VectorXd::Zero(6 * static_cast<long>(lattice.centre.size()));
  double expected = 0.0;
  for (int step = 0; step < 10; ++step) {
    const Eigen::VectorXd rate = draw.state(lattice.centre.size());
    Eigen::VectorXd f = Eigen::VectorXd::Zero(rate.size());
    add_damping_forces(damping, rate.data(), nullptr, dt, f.data(), work);
    expected -= 0.5 * dt * (before + f).dot(rate);
    EXPECT_NEAR(work, expected, 1e-13 * expected) << "step " << step;
    before = f;
  }
}

TEST(Damping, BooksTheEnergyThatTheLatticeLoses) {
  const Lattice lattice = jumble(3, 39, false);
  Draw draw(40);
  const double dt = 0.5 * 2.0 / std::sqrt(hand_made::highest_omega_squared(lattice));
  auto march = released(lattice, damped_everywhere(lattice, 0.05), dt, draw.state(lattice.centre.size()));
  const double at_first = march.evaluate_balance().total();
  for (int step = 0; step < 500; ++step) {
    march.step();
    // The books of model.md §7 close to rounding in every single step, at half of the critical one, too.
    ASSERT_NEAR(march.evaluate_balance().total() + march.viscous_work, at_first, 1e-12 * at_first)
        << "step " << step;
  }
  EXPECT_GT(march.viscous_work, 0.5 * at_first);
}

TEST(Damping, OfASofteningBeamFallsWithItsFactor) {
  const Lattice lattice = jumble(2, 41, false);
  Draw draw(42);
  const Eigen::VectorXd rate = draw.state(lattice.centre.size());
  std::vector<double> factor(lattice.beam.size(), 1.0);
  const auto forces = [&] {
    std::vector<DampedBeam> beams;
    for (int b = 0; b < static_cast<int>(lattice.beam.size());
         ++b)  // the other way round: its place is no beam's number
      beams.push_back(damped_beam(lattice, b, static_cast<int>(factor.size()) - 1 - b, false));
    ViscousDamping damping(beams);
    damping.alpha_elsewhere = 0.4;
    double work = 0.0;
    Eigen::VectorXd f = Eigen::VectorXd::Zero(rate.size());
    add_damping_forces(damping, rate.data(), factor.data(), 0.1, f.data(), work);
    return f;
  };
  const Eigen::VectorXd intact = forces();
  factor.front() = 0.25;  // of the last beam
  Eigen::VectorXd alone = Eigen::VectorXd::Zero(rate.size());
  ViscousDamping last_beam({damped_beam(lattice, static_cast<int>(factor.size()) - 1, -1, false)});
  last_beam.alpha_elsewhere = 0.4;
  double work = 0.0;
  add_damping_forces(last_beam, rate.data(), nullptr, 0.1, alone.data(), work);
  ASSERT_GT(alone.norm(), 1e-3 * intact.norm());
  EXPECT_NEAR((forces() - (intact - 0.75 * alone)).norm(), 0.0, 1e-14 * intact.norm());
  std::fill(factor.begin(), factor.end(), 0.0);
  EXPECT_NEAR(forces().norm(), 0.0, 1e-300);  // a released beam damps no more: products with an exact zero
}

TEST(Damping, TakesItsOwnFractionAtTheCracksSurface) {
  const Lattice lattice = pair_of(0.2);
  Draw draw(43);
  const Eigen::VectorXd rate = draw.state(2);
  const auto force = [&](bool at_surface, double alpha_at_surface, double alpha_elsewhere) {
    ViscousDamping damping({damped_beam(lattice, 0, -1, at_surface)});
    damping.alpha_at_surface = alpha_at_surface;
    damping.alpha_elsewhere = alpha_elsewhere;
    double work = 0.0;
    Eigen::VectorXd f = Eigen::VectorXd::Zero(12);
    add_damping_forces(damping, rate.data(), nullptr, 0.1, f.data(), work);
    return f;
  };
  const Eigen::VectorXd critical = force(false, 0.0, 1.0);
  EXPECT_NEAR((force(true, 0.25, 0.0) - 0.25 * critical).norm(), 0.0, 1e-15 * critical.norm());
  EXPECT_NEAR(force(false, 0.25, 0.0).norm(), 0.0, 1e-300);  // products with an exact zero
  EXPECT_NEAR(force(true, 0.0, 0.25).norm(), 0.0, 1e-300);
}

}  // namespace
}  // namespace rift::lattice
