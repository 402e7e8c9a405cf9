#include "engine/ensemble/ensemble.hpp"
#include "tests/engine/lattice/hand_made.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rift::lattice {
namespace {

using hand_made::chain;
using hand_made::Rod;

/// A bar of beams along x, held at both ends, that nothing damages.
struct Bar {
  Rod rod;
  Lattice lattice;
  ensemble::Ensemble simulation;

  Bar(int elements, double dt)
      : lattice(held_chain(elements, rod)), simulation(lattice, {}, dt, {fracture::LaneScenario{}}) {}
  Bar(const Bar&) = delete;

  static Lattice held_chain(int elements, const Rod& rod) {
    Lattice bar = chain(elements, Eigen::Vector3d::UnitX(), rod);
    bar.grip.front() = packing::Grip::bottom;
    bar.grip.back() = packing::Grip::top;
    return bar;
  }
  /// Starts component c of all elements from rest at shape(k).
  template <typename Shape>
  void start(int c, const Shape& shape) {
    std::vector<Vector6> q(lattice.centre.size(), Vector6::Zero());
    for (std::size_t k = 0; k < q.size(); ++k) q[k][c] = shape(static_cast<double>(k));
    simulation.release_from(q);
  }
  double at(int element, int c) const { return simulation.motion(element, 0)[c]; }
};

/// A wave runs along the bar in displacement or rotation about it: component, and speed of long waves.
struct Branch {
  int component;
  double speed;
};

// Density is 1: sqrt(E / rho) and sqrt(G / rho) of a bar with its own masses.
const Branch branches[] = {{0, std::sqrt(Rod{}.young)}, {3, std::sqrt(Rod{}.shear())}};

TEST(WaveInABar, StandsAtTheFrequencyOfTheDispersionRelation) {
  const int beams = 40, steps = 1000;
  const double dt = 0.4;
  for (const Branch& branch : branches)
    for (const int half_waves : {1, 7, 20, 39}) {
      Bar bar(beams + 1, dt);
      const double kappa = std::numbers::pi * half_waves / beams;  // spacing 1
      bar.start(branch.component, [&](double k) { return 1e-3 * std::sin(kappa * k); });
      // omega = 2 c sin(kappa / 2) of the chain, and sin(Omega dt / 2) = omega dt / 2 of the time step.
      const double omega = 2.0 * branch.speed * std::sin(0.5 * kappa);
      const double Omega = 2.0 / dt * std::asin(0.5 * omega * dt);
      for (int n = 0; n < steps; ++n) bar.simulation.step();
      const double expected = 1e-3 * std::cos(Omega * dt * steps);
      for (int k = 0; k <= beams; ++k)  // rounding grows with the steps, some 1e-15 of the amplitude each
        EXPECT_NEAR(bar.at(k, branch.component), expected * std::sin(kappa * k), 1e-12)
            << half_waves << " half waves at element " << k;
    }
}

TEST(WaveInABar, TravelsAtTheBarsSpeed) {
  const int middle = 600, width = 30, steps = 500;
  for (const Branch& branch : branches) {
    const double dt = 0.5 / branch.speed;  // half of critical
    Bar bar(2 * middle + 1, dt);
    bar.start(branch.component,
              [&](double k) { return 1e-3 * std::exp(-0.5 * std::pow((k - middle) / width, 2)); });
    for (int n = 0; n < steps; ++n) bar.simulation.step();
    double sum = 0.0, moment = 0.0;
    for (int k = middle; k <= 2 * middle; ++k) {
      sum += bar.at(k, branch.component);
      moment += bar.at(k, branch.component) * (k - middle);
    }
    // Two equal pulses leave the middle. Waves as long as these lag by (kappa^2 / 24) = 5e-5 and less.
    EXPECT_NEAR(moment / sum / (branch.speed * dt * steps), 1.0, 1e-3);
    EXPECT_NEAR(bar.at(middle + steps / 2, branch.component), 0.5e-3, 0.5e-5);
  }
}

}  // namespace
}  // namespace rift::lattice
