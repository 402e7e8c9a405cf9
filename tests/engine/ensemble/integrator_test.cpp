#include "engine/ensemble/ensemble.hpp"
#include "tests/engine/lattice/dense.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace rift::ensemble {
namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

/// Eight spheres in a bent and braced chain, its two ends held: all six motions of each are coupled.
packing::Specimen chain() {
  packing::Specimen s;
  s.box = {8e-3, 3e-3, 2e-3};
  for (int k = 0; k < 8; ++k) {
    s.centre.emplace_back(1e-3 * k, 0.4e-3 * (k % 2), 0.3e-3 * (k % 3));
    s.radius.push_back(0.55e-3 + 0.01e-3 * k);
    s.grip.push_back(packing::Grip::none);
    if (k > 0) s.beam.push_back({k - 1, k});
    if (k > 1 && k % 2 == 0) s.beam.push_back({k - 2, k});
  }
  s.grip.front() = packing::Grip::bottom;
  s.grip.back() = packing::Grip::top;
  s.packing.mean_radius = 0.58e-3;
  return s;
}

/// A lattice, and what is known of it exactly: q(t) = sum of modes, each turning at its own frequency.
struct Vibration {
  lattice::Lattice lattice = lattice::make_lattice(chain(), {356e9, 0.3, 0.3}, 667.0);
  Matrix mode;   // columns, over the free elements 1 to 6; mass-normalised
  Vector omega;  // ascending [1/s]
  Vector mass;   // per degree of freedom

  Vibration() {
    const long n = 36;
    mass.resize(n);
    for (int i = 0; i < 6; ++i) {
      mass.segment<3>(6 * i).setConstant(lattice.mass[i + 1]);
      mass.segment<3>(6 * i + 3).setConstant(lattice.inertia[i + 1]);
    }
    const Matrix k = lattice::hand_made::dense_stiffness(lattice);
    const auto modes = lattice::hand_made::modes_of(k.block(6, 6, n, n), mass.asDiagonal().toDenseMatrix());
    mode = modes.vector;
    omega = modes.value.cwiseSqrt();
  }

  double critical() const { return 2.0 / omega[35]; }

  /// At rest in a shape given by its modes' amplitudes; nothing is cracked.
  Ensemble released_from(const Vector& amplitude, double dt) const {
    Ensemble s(lattice, {}, dt, {fracture::LaneScenario{}});
    std::vector<lattice::Vector6> q(8, lattice::Vector6::Zero());
    const Vector shape = mode * amplitude;
    for (int i = 0; i < 6; ++i) q[i + 1] = shape.segment<6>(6 * i);
    s.release_from(q);
    return s;
  }

  Vector modal(const std::function<lattice::Vector6(int element)>& state) const {
    Vector of_all(36);
    for (int i = 0; i < 6; ++i) of_all.segment<6>(6 * i) = state(i + 1);
    return mode.transpose() * mass.cwiseProduct(of_all);
  }
  Vector modal_position(const Ensemble& s) const {
    return modal([&](int i) { return s.motion(i, 0); });
  }
  Vector modal_velocity(Ensemble& s) const {
    return modal([&](int i) { return s.velocity(i, 0); });
  }
};

double distance_after(const Vibration& v, const Vector& amplitude, double time, int steps) {
  Ensemble s = v.released_from(amplitude, time / steps);
  for (int n = 0; n < steps; ++n) s.step();
  const Vector exact = amplitude.cwiseProduct((v.omega * time).array().cos().matrix());
  return (v.modal_position(s) - exact).norm() / amplitude.norm();
}

TEST(Integrator, IsOfSecondOrder) {
  const Vibration v;
  Vector amplitude = Vector::Zero(36);
  amplitude.head(6) << 1.0, -0.7, 0.5, 0.3, -0.2, 0.1;
  const double time = 3.0 * 2.0 * 3.14159 / v.omega[0];
  const int steps = static_cast<int>(std::ceil(time / (0.1 * v.critical())));
  const double coarse = distance_after(v, amplitude, time, steps),
               fine = distance_after(v, amplitude, time, 2 * steps),
               finest = distance_after(v, amplitude, time, 4 * steps);
  EXPECT_GT(finest, 1e-6);  // the error of the method, not of rounding
  // Terms of the fourth order: (omega dt)^2 of the highest mode present, below 1 %.
  EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.02);
  EXPECT_NEAR(std::log2(fine / finest), 2.0, 0.005);
}

/// What a step does to amplitude and speed of one mode; from three states of its history.
Eigen::Matrix2d amplification(const Vibration& v, int mode, double beta, double dt) {
  Vector amplitude = Vector::Zero(36);
  amplitude[mode] = 1.0;
  Ensemble s = v.released_from(amplitude, dt);
  s.set_beta(beta);
  Eigen::Matrix<double, 2, 3> x;
  for (int n = 0; n < 3; ++n) {
    x.col(n) << v.modal_position(s)[mode] * v.omega[mode], v.modal_velocity(s)[mode];
    s.step();
  }
  return x.rightCols<2>() * x.leftCols<2>().inverse();
}

// Eqs. (1) and (2) of the paper for q'' = -omega^2 q with h = (omega dt)^2:
//   determinant 1 + (beta - 1) h / 2, trace 2 - (1 + beta) h / 2   [model.md §3]
// 1e-8: rounding of the force, 1e-16 of the stiffest mode, seen from the softest, some 1e5 softer.
TEST(Integrator, AmplifiesAModeAsTheTheorySays) {
  const Vibration v;
  for (const double beta : {0.9, 1.0, 1.05})
    for (const double fraction : {0.17, 0.5, 0.9})
      for (const int mode : {10, 20, 35}) {
        const double dt = fraction * v.critical(), h = std::pow(v.omega[mode] * dt, 2);
        const Eigen::Matrix2d a = amplification(v, mode, beta, dt);
        EXPECT_NEAR(a.determinant(), 1.0 + (beta - 1.0) * h / 2.0, 1e-8) << beta << ' ' << mode;
        EXPECT_NEAR(a.trace(), 2.0 - (1.0 + beta) * h / 2.0, 1e-8) << beta << ' ' << mode;
      }
}

// |amplification|^2 is the determinant while the mode still oscillates, so K + U grows by it each step, but
// for the swing within a period: two moments half a percent of a period apart are compared over many periods.
TEST(Integrator, DampsBelowOneKeepsAtOneAndGrowsAbove) {
  const Vibration v;
  const double dt = 0.5 * v.critical(), h = std::pow(v.omega[35] * dt, 2);
  const int steps = 300;
  for (const double beta : {0.9, 1.0, 1.05}) {
    Vector amplitude = Vector::Zero(36);
    amplitude[35] = 1.0;
    Ensemble s = v.released_from(amplitude, dt);
    s.set_beta(beta);
    const double before = s.balance(0).total();
    for (int n = 0; n < steps; ++n) s.step();
    const double grown = std::log(s.balance(0).total() / before) / steps;
    const double swing = 0.6 / steps;  // of the energy within a period where beta is not 1, as a rate
    EXPECT_NEAR(grown, std::log(1.0 + (beta - 1.0) * h / 2.0), beta == 1.0 ? 1e-12 : swing) << beta;
    if (beta > 1.0) {
      EXPECT_GT(s.balance(0).total(), 10.0 * before);
    } else if (beta < 1.0) {
      EXPECT_LT(s.balance(0).total(), 0.1 * before);
    }
  }
}

TEST(Integrator, BlowsUpAboveTheCriticalStepAndNotBelow) {
  const Vibration v;
  const auto growth = [&](double fraction) {
    Vector amplitude = Vector::Ones(36);
    Ensemble s = v.released_from(amplitude, fraction * v.critical());
    const double before = s.balance(0).elastic;
    for (int n = 0; n < 400; ++n) s.step();
    return s.balance(0).elastic / before;
  };
  EXPECT_LT(growth(0.999), 10.0);
  EXPECT_GT(growth(1.01), 1e10);  // |lambda| = 1.15 per step for the highest mode
}

}  // namespace
}  // namespace rift::ensemble
