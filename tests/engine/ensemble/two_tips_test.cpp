#include "engine/lattice/statics.hpp"
#include "tests/engine/ensemble/cracked_ensemble.hpp"
#include "tests/engine/lattice/hand_made.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace rift::ensemble {
namespace {

constexpr int columns = 16, rows = 8;

int mirrored(int element) { return (columns - 1 - element / rows) * rows + element % rows; }

/// A square lattice with both diagonals, its own mirror image about x = 8; the crack runs between its rows.
lattice::Lattice symmetric_plate() {
  lattice::Lattice lattice;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      lattice.centre.emplace_back(0.5 + i, 0.5 + j, 0.0);
      lattice.grip.push_back(j == 0          ? packing::Grip::bottom
                             : j == rows - 1 ? packing::Grip::top
                                             : packing::Grip::none);
    }
  const int n = static_cast<int>(lattice.centre.size());
  lattice.mass.assign(n, 1.0);
  lattice.inertia.assign(n, 0.2);
  for (int a = 0; a < n; ++a)
    for (int b = a + 1; b < n; ++b) {
      if ((lattice.centre[b] - lattice.centre[a]).norm() > 1.5) continue;
      lattice.ends.push_back({a, b});
      lattice.beam.push_back(lattice::hand_made::Rod{}.between(lattice.centre[a], lattice.centre[b]));
    }
  lattice.mean_radius = 0.5;
  lattice.box = {.length = columns, .height = rows, .thickness = 1.0};
  return lattice;
}

/// By reflection in x: displacements along x and rotations about y and z turn round.
lattice::Vector6 reflected(const lattice::Vector6& motion) {
  lattice::Vector6 m = motion;
  for (int c : {0, 4, 5}) m[c] = -m[c];
  return m;
}

TEST(TwoTips, ReleaseASymmetricLatticeSymmetrically) {
  const lattice::Lattice lattice = symmetric_plate();
  const std::vector<lattice::Vector6> base =
      lattice::stretched_at_rest(lattice, std::vector<char>(lattice.beam.size(), 1), 0.1);
  const fracture::LaneScenario lane{
      .history = history::history_of(-2.0, {{0.3, std::numeric_limits<double>::infinity()}}),
      .law = {fracture::Technique::progressive, 1.0, 2.0}};
  constexpr double no_notch = -1.0;  // two diagonals cross in the very middle
  CrackedEnsemble s(lattice, fracture::straight_path(columns, 4.0, 2), no_notch, 0.2, {lane});
  s.start_from(base);
  s.start_crack({});
  for (int step = 0; step < 80; ++step) s.step();
  EXPECT_NEAR(s.tip(0), 2.8, 1e-12);

  int gone = 0, softened = 0;
  ASSERT_FALSE(s.damageable().empty());
  for (int k = 0; k < static_cast<int>(s.damageable().size()); ++k) {
    EXPECT_EQ(s.factor(k, 0), fracture::stiffness_left(lane.law, s.tip(0), s.damageable()[k].position));
    gone += s.factor(k, 0) == 0.0 ? 1 : 0;
    softened += s.factor(k, 0) > 0.0 && s.factor(k, 0) < 1.0 ? 1 : 0;
  }
  // Up to 2.8 from the middle: uprights at 0.5, 1.5, 2.5 on either side, pairs of diagonals at 0, 1, 2.
  EXPECT_EQ(gone, 2 * 3 + 2 * (1 + 2 + 2));
  // Up to 4.8: uprights at 3.5, 4.5, pairs of diagonals at 3, 4.
  EXPECT_EQ(softened, 2 * 2 + 2 * (2 + 2));

  double moved = 0.0;
  ASSERT_FALSE(lattice.centre.empty());
  for (int i = 0; i < static_cast<int>(lattice.centre.size()); ++i) {
    moved = std::max(moved, (s.motion(i, 0) - base[i]).norm());
    // 0.1 by solves true to 1e-13, marched 80 steps
    EXPECT_LT((s.motion(i, 0) - reflected(s.motion(mirrored(i), 0))).norm(), 1e-10) << i;
  }
  EXPECT_GT(moved, 0.01);
  EXPECT_LT(std::abs(s.balance(0).error), 1e-12);
}

}  // namespace
}  // namespace rift::ensemble
