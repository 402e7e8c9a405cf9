#include "engine/lattice/forces.hpp"

#include "tests/engine/lattice/hand_made.hpp"

#include <gtest/gtest.h>

namespace rift::lattice {
namespace {

using hand_made::Draw;
using hand_made::jumble;
using hand_made::loads_on;
using hand_made::rows_of;

/// The sum over beams of loads_of, in the beams' order.
Eigen::VectorXd summed_loads(const Lattice& lattice, const Eigen::VectorXd& q) {
  Eigen::VectorXd f = Eigen::VectorXd::Zero(q.size());
  for (std::size_t b = 0; b < lattice.beam.size(); ++b) {
    const auto& [i, j] = lattice.ends[b];
    const BeamLoads loads = loads_of(lattice.beam[b], q.segment<6>(6 * i), q.segment<6>(6 * j));
    Vector6 on_i, on_j;
    on_i << loads.force_i, loads.moment_i;
    on_j << -loads.force_i, loads.moment_j;
    f.segment<6>(6 * i) += on_i;
    f.segment<6>(6 * j) += on_j;
  }
  return f;
}

TEST(BeamForces, AreTheSumOfTheBeamsLoads) {
  const Lattice lattice = jumble(4, 11, false);
  Draw draw(12);
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::VectorXd q = draw.state(lattice.centre.size());
    const Eigen::VectorXd expected = summed_loads(lattice, q);
    EXPECT_NEAR((loads_on(lattice, q) - expected).cwiseAbs().maxCoeff(), 0.0,
                1e-14 * expected.cwiseAbs().maxCoeff());
  }
}

TEST(BeamForces, AreAddedToWhatIsThere) {
  const Lattice lattice = jumble(3, 13, false);
  Draw draw(14);
  const Eigen::VectorXd q = draw.state(lattice.centre.size()), before = draw.state(lattice.centre.size());
  const Eigen::VectorXd expected = before + loads_on(lattice, q);
  Eigen::VectorXd f = before;
  add_beam_forces(rows_of(lattice), q.data(), f.data());
  EXPECT_NEAR((f - expected).cwiseAbs().maxCoeff(), 0.0, 1e-14 * expected.cwiseAbs().maxCoeff());
}

TEST(BeamForces, KeepMomentumAndAngularMomentum) {
  const Lattice lattice = jumble(4, 19, false);
  Draw draw(20);
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::VectorXd f = loads_on(lattice, draw.state(lattice.centre.size()));
    // Levers of up to ten, several hundred loads.
    EXPECT_NEAR(hand_made::resultant(lattice, f, 3.0 * draw.vector()).norm(), 0.0, 1e-13 * f.norm());
  }
}

TEST(BeamForces, VanishInARigidMotion) {
  const Lattice lattice = jumble(4, 21, false);
  Draw draw(22);
  const Eigen::Vector3d shift = draw.vector(), turn = draw.vector(), pivot = 2.0 * draw.vector();
  Eigen::VectorXd q(6 * static_cast<long>(lattice.centre.size()));
  for (std::size_t i = 0; i < lattice.centre.size(); ++i)
    q.segment<6>(6 * static_cast<long>(i)) = hand_made::rigid(lattice.centre[i], shift, turn, pivot);
  const double typical = loads_on(lattice, draw.state(lattice.centre.size())).cwiseAbs().maxCoeff();
  EXPECT_NEAR(loads_on(lattice, q).cwiseAbs().maxCoeff(), 0.0, 1e-14 * typical);
}

}  // namespace
}  // namespace rift::lattice
