#include "engine/mechanics/forces.hpp"

#include "tests/engine/mechanics/hand_made.hpp"

#include <gtest/gtest.h>

#include <cstring>

namespace rift {
namespace {

using hand_made::Draw;
using hand_made::jumble;
using hand_made::loads_on;
using hand_made::rows_of;

/// The sum over beams of factor x loads_of, in the beams' order.
Eigen::VectorXd summed_loads(const Lattice& lattice, const Eigen::VectorXd& q,
                             const std::vector<double>& factor) {
  Eigen::VectorXd f = Eigen::VectorXd::Zero(q.size());
  for (std::size_t b = 0; b < lattice.beam.size(); ++b) {
    const auto& [i, j] = lattice.ends[b];
    const BeamLoads loads = loads_of(lattice.beam[b], q.segment<6>(6 * i), q.segment<6>(6 * j));
    Vector6 on_i, on_j;
    on_i << loads.force_i, loads.moment_i;
    on_j << -loads.force_i, loads.moment_j;
    f.segment<6>(6 * i) += factor[b] * on_i;
    f.segment<6>(6 * j) += factor[b] * on_j;
  }
  return f;
}

std::vector<double> random_factors(Draw& draw, std::size_t count) {
  std::vector<double> factor(count);
  for (double& s : factor) s = draw.between(0, 1);
  return factor;
}

TEST(BeamForces, AreTheSumOfTheBeamsLoads) {
  const Lattice lattice = jumble(4, 11, false);
  Draw draw(12);
  const std::vector<double> intact(lattice.beam.size(), 1.0);
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::VectorXd q = draw.state(lattice.centre.size());
    const Eigen::VectorXd expected = summed_loads(lattice, q, intact);
    EXPECT_NEAR((loads_on(lattice, q) - expected).cwiseAbs().maxCoeff(), 0.0,
                1e-14 * expected.cwiseAbs().maxCoeff());
  }
}

TEST(BeamForces, AreAddedToWhatIsThere) {
  const Lattice lattice = jumble(3, 13, false);
  Draw draw(14);
  const Eigen::VectorXd q = draw.state(lattice.centre.size()), before = draw.state(lattice.centre.size());
  const std::vector<double> halved(lattice.beam.size(), 0.5);
  const Eigen::VectorXd expected = before + 1.5 * loads_on(lattice, q);
  Eigen::VectorXd f = before;
  add_beam_forces<1>(rows_of(lattice), q.data(), f.data());
  add_beam_forces<1>(rows_of(lattice), halved.data(), q.data(), f.data());
  EXPECT_NEAR((f - expected).cwiseAbs().maxCoeff(), 0.0, 1e-14 * expected.cwiseAbs().maxCoeff());
}

TEST(BeamForces, ScaleWithEachBeamsFactor) {
  const Lattice lattice = jumble(4, 15, false);
  Draw draw(16);
  const Eigen::VectorXd q = draw.state(lattice.centre.size());
  const std::vector<double> factor = random_factors(draw, lattice.beam.size());
  Eigen::VectorXd f = Eigen::VectorXd::Zero(q.size());
  add_beam_forces<1>(rows_of(lattice), factor.data(), q.data(), f.data());
  const Eigen::VectorXd expected = summed_loads(lattice, q, factor);
  EXPECT_NEAR((f - expected).cwiseAbs().maxCoeff(), 0.0, 1e-14 * expected.cwiseAbs().maxCoeff());
}

TEST(BeamForces, OfFourLanesHaveTheBitsOfOne) {
  const Lattice lattice = jumble(4, 17, false);
  const std::vector<BeamRow> rows = rows_of(lattice);
  const long size = 6 * static_cast<long>(lattice.centre.size());
  Draw draw(18);
  Eigen::MatrixXd q(4, size), f = Eigen::MatrixXd::Zero(4, size);  // column by column: [component][lane]
  Eigen::MatrixXd factor(4, rows.size());
  for (double& c : q.reshaped()) c = draw.between(-1, 1);
  for (double& s : factor.reshaped()) s = draw.between(0, 1);
  Eigen::MatrixXd softened = f;
  add_beam_forces<4>(rows, q.data(), f.data());
  add_beam_forces<4>(rows, factor.data(), q.data(), softened.data());
  for (int lane = 0; lane < 4; ++lane) {
    const Eigen::VectorXd q1 = q.row(lane), factor1 = factor.row(lane);
    Eigen::VectorXd f1 = Eigen::VectorXd::Zero(size), softened1 = f1;
    add_beam_forces<1>(rows, q1.data(), f1.data());
    add_beam_forces<1>(rows, factor1.data(), q1.data(), softened1.data());
    const Eigen::VectorXd f4 = f.row(lane), softened4 = softened.row(lane);
    EXPECT_EQ(std::memcmp(f1.data(), f4.data(), sizeof(double) * size), 0) << "lane " << lane;
    EXPECT_EQ(std::memcmp(softened1.data(), softened4.data(), sizeof(double) * size), 0) << "lane " << lane;
  }
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
}  // namespace rift
