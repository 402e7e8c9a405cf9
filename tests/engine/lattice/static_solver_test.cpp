#include "engine/lattice/static_solver.hpp"

#include "engine/lattice/forces.hpp"
#include "engine/lattice/statics.hpp"
#include "tests/engine/lattice/dense.hpp"
#include "tests/engine/lattice/hand_made.hpp"

#include <gtest/gtest.h>

namespace rift::lattice {
namespace {

using hand_made::Draw;
using hand_made::jumble;

/// A free lattice whose first element is tied, in the unknowns u and theta; all coordinates above 0.
StaticRows<BeamRow> tied_block(const Lattice& lattice) {
  StaticRows<BeamRow> system;
  for (const Eigen::Vector3d& centre : lattice.centre) system.centre.emplace_back(centre.array() + 1.0);
  system.mean_radius = 1.0;
  system.row = hand_made::rows_of(lattice);
  system.tie = Vector6::Ones();
  return system;
}

Eigen::MatrixXd dense_of(const Lattice& lattice) {
  Eigen::MatrixXd k = hand_made::dense_stiffness(lattice);
  for (int c = 0; c < 6; ++c) k(c, c) += 1.0;
  return k;
}

/// The lower triangle of a beam's stiffness over u_j - u_i, theta_i and theta_j, by its 12 x 12 matrix.
StiffnessRow stiffness_row(const Lattice& lattice, int beam) {
  const Matrix12 k = stiffness_of(lattice.beam[beam]);
  const std::array<int, 9> at{6, 7, 8, 3, 4, 5, 9, 10, 11};
  StiffnessRow row{.i = lattice.ends[beam][0], .j = lattice.ends[beam][1], .k = {}};
  for (int r = 0, n = 0; r < 9; ++r)
    for (int c = 0; c <= r; ++c) row.k[n++] = k(at[r], at[c]);
  return row;
}

TEST(Shares, GiveEachElementTheSameBitsHoweverManyThereAre) {
  const Lattice lattice = jumble(5, 101, false);
  const Eigen::VectorXd q = Draw(102).state(lattice.centre.size()),
                        expected = hand_made::loads_on(lattice, q);
  for (const std::vector<int>& ends : {std::vector{125}, {60, 125}, {1, 2, 50, 51, 125}}) {
    Eigen::VectorXd f = Eigen::VectorXd::Zero(q.size());
    for (const Share<BeamRow>& share : shared_out(ends, hand_made::rows_of(lattice)))
      add_loads(share, q.data(), f.data());
    EXPECT_EQ(f, expected) << ends.size();
  }
}

TEST(StiffnessRow, DoesWhatTheBeamDoes) {
  const Lattice lattice = jumble(3, 103, false);
  const Eigen::VectorXd q = Draw(104).state(lattice.centre.size()),
                        expected = hand_made::loads_on(lattice, q);
  std::vector<StiffnessRow> rows;
  for (int b = 0; b < static_cast<int>(lattice.beam.size()); ++b) rows.push_back(stiffness_row(lattice, b));
  Eigen::VectorXd f = Eigen::VectorXd::Zero(q.size());
  for (const Share<StiffnessRow>& share : shared_out({27}, rows)) add_loads(share, q.data(), f.data());
  EXPECT_NEAR((f - expected).norm(), 0.0, 1e-13 * expected.norm());
}

TEST(DampingRow, DoesWhatTheDampedBeamDoes) {
  const Lattice lattice = jumble(3, 105, false);
  const Eigen::VectorXd rate = Draw(106).state(lattice.centre.size());
  ViscousDamping damping = hand_made::damped_everywhere(lattice, 0.3);
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(rate.size()), f = expected;
  double work = 0.0;
  add_damping_forces(damping, rate.data(), nullptr, 1.0, expected.data(), work);
  std::vector<DampingRow> rows;
  for (const DampedBeam& b : damping.beam)
    rows.push_back({b.i, b.j, b.axis.x(), b.axis.y(), b.axis.z(), 0.3 * b.axial, 0.3 * (b.twist - b.bend),
                    0.3 * b.bend});
  for (const Share<DampingRow>& share : shared_out({27}, rows)) add_loads(share, rate.data(), f.data());
  EXPECT_NEAR((f - expected).norm(), 0.0, 1e-14 * expected.norm());
}

TEST(StaticSolver, AgreesWithDenseElimination) {
  const Lattice lattice = jumble(4, 107, false);
  const Eigen::VectorXd load = Draw(108).state(lattice.centre.size());
  const Eigen::VectorXd expected = hand_made::solution_of(dense_of(lattice), load);
  StaticSolver<BeamRow> solver(tied_block(lattice), 1);
  const Eigen::VectorXd given = solver.solve(load, 1e-13);
  EXPECT_NEAR((given - expected).norm(), 0.0, 1e-11 * expected.norm());  // the condition is some hundreds
  EXPECT_EQ(solver.solve(load, 1e-13), given) << "nothing is left of the solution before";
}

TEST(StaticSolver, HasTheSameBitsForAnyNumberOfThreads) {
  const Lattice lattice = jumble(16, 109, false);
  const Eigen::VectorXd load = Draw(110).state(lattice.centre.size());
  const Eigen::VectorXd alone = StaticSolver<BeamRow>(tied_block(lattice), 1).solve(load, 1e-10);
  for (const int threads : {2, 3})
    EXPECT_EQ(StaticSolver<BeamRow>(tied_block(lattice), threads).solve(load, 1e-10), alone) << threads;
}

TEST(StaticSolver, HasNothingToDoWithoutLoads) {
  const Lattice lattice = jumble(3, 111, false);
  StaticSolver<BeamRow> solver(tied_block(lattice), 1);
  EXPECT_EQ(solver.solve(Eigen::VectorXd::Zero(6 * 27), 1e-13), Eigen::VectorXd::Zero(6 * 27));
  EXPECT_EQ(solver.iterations(), 0);
}

// Long waves are what patches are for: without them 24,000 iterations do not bring this to an end.
TEST(StaticSolver, TakesFewIterationsOfALongBar) {
  const Lattice bar = hand_made::chain(2000, {1.0, 0.0, 0.0}, {});
  StaticSolver<BeamRow> solver(tied_block(bar), 1);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(6 * 2000);
  load[6 * 1999 + 1] = 1.0;
  solver.solve(load, 1e-6);
  EXPECT_LT(solver.iterations(), 200);
}

/// M^-1 r, whole.
Eigen::VectorXd preconditioned(RigidPatches& patches, Blocks& blocks, const Eigen::VectorXd& r) {
  Eigen::VectorXd z(r.size()), p = Eigen::VectorXd::Zero(r.size());
  const double along = patches.solve(blocks, r, z);
  patches.advance(0, blocks.elements(), z, 0.0, p);
  EXPECT_NEAR(along, r.dot(p), 1e-12 * std::abs(along));
  return p;
}

TEST(RigidPatches, AreSymmetricAndPositiveDefinite) {
  const Lattice lattice = jumble(4, 112, false);
  Blocks blocks(64, 1);
  RigidPatches patches(tied_block(lattice), 1.5);
  Draw draw(113);
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::VectorXd a = draw.state(64), b = draw.state(64);
    const Eigen::VectorXd of_a = preconditioned(patches, blocks, a),
                          of_b = preconditioned(patches, blocks, b);
    EXPECT_GT(a.dot(of_a), 0.0);
    EXPECT_NEAR(a.dot(of_b), b.dot(of_a), 1e-12 * of_a.norm() * b.norm());
  }
}

// What they add to the blocks' answer is the rigid motion that leaves no resultant of load and resistance.
TEST(RigidPatches, SolveForTheRigidMotionsOfPatches) {
  const Lattice lattice = jumble(4, 114, false);
  Blocks blocks(64, 1);
  RigidPatches patches(tied_block(lattice), 100.0);  // one patch
  const Eigen::MatrixXd k = dense_of(lattice);
  const Eigen::VectorXd load = Draw(115).state(64);
  Eigen::VectorXd z(load.size()), p = Eigen::VectorXd::Zero(load.size());
  patches.solve(blocks, load, z);
  patches.advance(0, 64, z, 0.0, p);
  const Eigen::VectorXd rigid = p - z, left = load - k * rigid;
  Vector6 resultant = Vector6::Zero();
  for (int i = 0; i < 64; ++i) {
    resultant.head<3>() += left.segment<3>(6 * i);
    resultant.tail<3>() += lattice.centre[i].cross(left.segment<3>(6 * i)) + left.segment<3>(6 * i + 3);
  }
  EXPECT_NEAR(resultant.norm(), 0.0, 1e-10 * load.norm());
}

}  // namespace
}  // namespace rift::lattice
