#include "engine/lattice/statics.hpp"

#include "engine/lattice/lattice.hpp"
#include "tests/engine/lattice/dense.hpp"
#include "tests/engine/lattice/hand_made.hpp"
#include "tests/engine/packing/packed_once.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

namespace rift::lattice {
namespace {

using hand_made::chain;
using hand_made::jumble;
using hand_made::loads_on;
using hand_made::Rod;

std::vector<char> all_of(const Lattice& lattice) { return std::vector<char>(lattice.beam.size(), 1); }

Eigen::VectorXd stacked(const std::vector<Vector6>& q) {
  Eigen::VectorXd all(6 * static_cast<long>(q.size()));
  for (std::size_t i = 0; i < q.size(); ++i) all.segment<6>(6 * static_cast<long>(i)) = q[i];
  return all;
}

/// Elements in a column along y at uneven distances, the outermost ones in the grips.
Lattice uneven_column() {
  const std::vector<double> height = {0.0, 1.0, 1.7, 3.2, 4.0, 4.9, 6.0};
  const Rod rod;
  Lattice column = chain(static_cast<int>(height.size()), Eigen::Vector3d::UnitY(), rod);
  for (std::size_t k = 0; k < height.size(); ++k) column.centre[k].y() = height[k];
  for (std::size_t b = 0; b < column.beam.size(); ++b)
    column.beam[b] = rod.between(column.centre[b], column.centre[b + 1]);
  column.grip.front() = packing::Grip::bottom;
  column.grip.back() = packing::Grip::top;
  return column;
}

/// A plate cut from the paper's: 600 elements.
const Lattice& packed_plate() {
  static const Lattice plate = [] {
    const packing::Box box{.length = 12e-3, .height = 20e-3, .thickness = 2e-3};
    const packing::Packing packing = packing::packed_once(
        {.box = box, .elements = 600, .radius_spread = 0.125, .coordination = 6.0, .seed = 3});
    return make_lattice(packing::make_plate(packing, box, 1.0), bulk_micro_material, 667.0);
  }();
  return plate;
}

/// Answers "go on" so many times.
struct Patience {
  int left;
  std::vector<double> told = {};
  bool operator()(double done) { return told.push_back(done), left-- > 0; }
};

TEST(Statics, StopsBetweenTwoRoundsOfASolutionWhenToldTo) {
  const Lattice& plate = packed_plate();
  for (const auto solve : {stretched_at_rest, stretched_at_rest_corotational}) {
    Patience patience{10};
    EXPECT_THROW(solve(plate, all_of(plate), 1e-4, std::ref(patience), 0), base::Interrupted);
    EXPECT_EQ(patience.told.size(), 11u);
  }
}

TEST(Statics, TellsHowManyDigitsAreDoneAndTheResultIsTheSame) {
  const Lattice& plate = packed_plate();
  Patience patience{1'000'000};
  const auto told = stretched_at_rest(plate, all_of(plate), 1e-4, std::ref(patience));
  EXPECT_EQ(stacked(told), stacked(stretched_at_rest(plate, all_of(plate), 1e-4)));
  ASSERT_GT(patience.told.size(), 20u);
  EXPECT_TRUE(std::is_sorted(patience.told.begin(), patience.told.end()));
  EXPECT_EQ(patience.told.front(), 0.0);
  EXPECT_GT(patience.told.back(), 0.9);
}

TEST(Statics, StretchesAColumnEvenly) {
  const Lattice column = uneven_column();
  const std::vector<Vector6> q = stretched_at_rest(column, all_of(column), 0.03);
  ASSERT_FALSE(q.empty());
  for (std::size_t i = 0; i < q.size(); ++i) {
    Vector6 expected = Vector6::Zero();
    expected[1] = 0.03 * column.centre[i].y() / 6.0;
    EXPECT_NEAR((q[i] - expected).norm(), 0.0, 1e-12) << "element " << i;
  }
  const Rod rod;
  const Eigen::VectorXd f = loads_on(column, stacked(q));
  EXPECT_NEAR(f[1], rod.young * rod.area() * 0.03 / 6.0, 1e-12);  // pulls the bottom grip up
}

TEST(Statics, AgreesWithDenseElimination) {
  const Lattice lattice = jumble(4, 91, true);
  const Eigen::MatrixXd k = hand_made::dense_stiffness(lattice);
  std::vector<int> free;
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(k.rows());
  for (int i = 0; i < static_cast<int>(lattice.grip.size()); ++i) {
    if (lattice.grip[i] == packing::Grip::top) expected[6 * i + 1] = 0.7;
    if (lattice.grip[i] == packing::Grip::none)
      for (int c = 0; c < 6; ++c) free.push_back(6 * i + c);
  }
  const Eigen::VectorXd load = (-k * expected)(free);
  const Eigen::MatrixXd k_free = k(free, free);
  expected(free) = hand_made::solution_of(k_free, load);
  const Eigen::VectorXd given = stacked(stretched_at_rest(lattice, all_of(lattice), 0.7));
  // The iteration stops at a residual of 1e-12; the condition of this block is some hundreds.
  EXPECT_NEAR((given - expected).cwiseAbs().maxCoeff(), 0.0, 1e-10);
}

TEST(Statics, HasTheSameBitsForAnyNumberOfThreads) {
  const Lattice block = jumble(14, 92, true);
  for (const auto solve : {stretched_at_rest, stretched_at_rest_corotational}) {
    const Eigen::VectorXd alone = stacked(solve(block, all_of(block), 0.01, {}, 1));
    for (const int threads : {2, 3})
      EXPECT_EQ(stacked(solve(block, all_of(block), 0.01, {}, threads)), alone) << threads;
  }
}

TEST(Statics, LeavesNoForceOnAFreeElement) {
  const Lattice& plate = packed_plate();
  const Eigen::VectorXd f = loads_on(plate, stacked(stretched_at_rest(plate, all_of(plate), 1e-4)));
  double pull = 0.0, free_force = 0.0, free_moment = 0.0;
  for (std::size_t i = 0; i < plate.grip.size(); ++i) {
    const Vector6 on = f.segment<6>(6 * static_cast<long>(i));
    if (plate.grip[i] == packing::Grip::top) pull -= on[1];
    if (plate.grip[i] != packing::Grip::none) continue;
    free_force = std::max(free_force, on.head<3>().norm());
    free_moment = std::max(free_moment, on.tail<3>().norm());
  }
  ASSERT_GT(pull, 0.0);
  EXPECT_NEAR(free_force, 0.0, 1e-10 * pull);
  EXPECT_NEAR(free_moment, 0.0, 1e-10 * pull * plate.mean_radius);
}

// Grips that leave rotations free hold the displacements as before, and no moment is left on their elements.
TEST(Statics, LeavesNoMomentOnElementsThatAGripLetsTurn) {
  Lattice plate = packed_plate();
  const std::vector<Vector6> held = stretched_at_rest(plate, all_of(plate), 1e-4);
  plate.grips_turn = true;
  const std::vector<Vector6> q = stretched_at_rest(plate, all_of(plate), 1e-4);
  const Eigen::VectorXd f = loads_on(plate, stacked(q));
  double pull = 0.0, left = 0.0, turned = 0.0;
  for (std::size_t i = 0; i < plate.grip.size(); ++i) {
    const Vector6 on = f.segment<6>(6 * static_cast<long>(i));
    left = std::max(left, on.tail<3>().norm() / plate.mean_radius);
    if (!plate.is_gripped(i)) {
      left = std::max(left, on.head<3>().norm());
      continue;
    }
    if (plate.grip[i] == packing::Grip::top) pull -= on[1];
    EXPECT_EQ(q[i].head<3>(), held[i].head<3>());
    turned = std::max(turned, q[i].tail<3>().norm());
  }
  ASSERT_GT(pull, 0.0);
  EXPECT_NEAR(left, 0.0, 1e-10 * pull);
  EXPECT_GT(turned, 1e-4);  // [rad], of a strain of 0.005
}

TEST(Statics, LeavesNoMomentOnTurningGripsWithCorotationalBeams) {
  Lattice plate = packed_plate();
  plate.grips_turn = true;
  const std::vector<Vector6> q = stretched_at_rest_corotational(plate, all_of(plate), 1e-3);
  std::vector<Vector6> f(q.size(), Vector6::Zero());
  for (std::size_t b = 0; b < plate.beam.size(); ++b) {
    const auto& [i, j] = plate.ends[b];
    const BeamLoads l = loads_of(plate.beam[b], pose_of(q[i]), pose_of(q[j]));
    f[i].head<3>() += l.force_i, f[i].tail<3>() += l.moment_i;
    f[j].head<3>() -= l.force_i, f[j].tail<3>() += l.moment_j;
  }
  double pull = 0.0, left = 0.0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    if (plate.grip[i] == packing::Grip::top) pull -= f[i][1];
    left = std::max(left, f[i].tail<3>().norm() / plate.mean_radius);
    if (!plate.is_gripped(i)) left = std::max(left, f[i].head<3>().norm());
  }
  ASSERT_GT(pull, 0.0);
  EXPECT_NEAR(left, 0.0, 1e-9 * pull);
}

TEST(Statics, HoldsTheGripsInAllSixDegreesOfFreedom) {
  const Lattice& plate = packed_plate();
  const std::vector<Vector6> q = stretched_at_rest(plate, all_of(plate), 1e-4);
  Vector6 lifted = Vector6::Zero();
  lifted[1] = 1e-4;
  int held = 0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (plate.grip[i] == packing::Grip::none) continue;
    ++held;
    const Vector6 prescribed = (plate.grip[i] == packing::Grip::top) ? lifted : Vector6::Zero();
    EXPECT_NEAR((q[i] - prescribed).norm(), 0.0, 1e-300) << "element " << i;  // set, not computed
  }
  EXPECT_GT(held, 20);
}

TEST(Statics, IsLinearInTheDisplacement) {
  const Lattice& plate = packed_plate();
  const Eigen::VectorXd once = stacked(stretched_at_rest(plate, all_of(plate), 1e-4)),
                        thrice = stacked(stretched_at_rest(plate, all_of(plate), -3e-4));
  EXPECT_NEAR((thrice + 3.0 * once).norm(), 0.0, 1e-9 * thrice.norm());
}

TEST(Statics, OfAnUnevenPullIsThatOfTheEvenOneAndOfItsTilt) {
  const Lattice& plate = packed_plate();
  const auto pulled = [&](double tilt) { return stretched_at_rest(plate, all_of(plate), {1e-4, tilt}); };
  const std::vector<Vector6> tilted = pulled(0.4);
  int pulled_elements = 0;
  for (std::size_t i = 0; i < tilted.size(); ++i) {
    if (plate.grip[i] != packing::Grip::top) continue;
    ++pulled_elements;
    EXPECT_NEAR(tilted[i][1], 1e-4 * (0.6 + 0.8 * plate.centre[i].x() / plate.box.length), 1e-18);
    EXPECT_EQ(tilted[i].tail<5>().norm(), std::abs(tilted[i][1]));
  }
  EXPECT_GT(pulled_elements, 10);
  const Eigen::VectorXd even = stacked(pulled(0.0)), once = stacked(pulled(0.2)) - even,
                        twice = stacked(tilted) - even;
  EXPECT_GT(once.norm(), 0.01 * even.norm());
  EXPECT_NEAR((twice - 2.0 * once).norm(), 0.0, 1e-9 * even.norm());
}

TEST(Statics, LeavesAFragmentWhereItIs) {
  const Lattice column = uneven_column();
  std::vector<char> present = all_of(column);
  present[2] = present[4] = 0;  // 3 and 4 hang on nothing
  const std::vector<Vector6> q = stretched_at_rest(column, present, 0.03);
  for (int i : {0, 1, 2, 3, 4}) EXPECT_NEAR(q[i].norm(), 0.0, 1e-14) << "element " << i;
  for (int i : {5, 6}) EXPECT_NEAR(q[i][1], 0.03, 1e-12) << "element " << i;  // follows its grip
}

TEST(Statics, HasNothingToSolveWhereAllIsHeld) {
  Lattice column = chain(2, Eigen::Vector3d::UnitY(), {});
  column.grip = {packing::Grip::bottom, packing::Grip::top};
  const std::vector<Vector6> q = stretched_at_rest(column, all_of(column), 0.03);
  EXPECT_NEAR(q[0].norm(), 0.0, 1e-300);
  EXPECT_NEAR(q[1][1], 0.03, 1e-17);
}

std::string message_of(const Lattice& lattice, double displacement) {
  try {
    stretched_at_rest(lattice, all_of(lattice), displacement);
  } catch (const StaticsError& error) {
    return error.what();
  }
  return "no StaticsError";
}

TEST(Statics, RefusesALatticeThatIsNotStable) {
  Lattice column = uneven_column();
  for (Beam& beam : column.beam) beam.axial *= -1.0;
  EXPECT_EQ(message_of(column, 0.03), "the lattice's stiffness is not positive definite");
}

TEST(Statics, SaysHowFarItCameWhereItDoesNotConverge) {
  const std::string message = message_of(uneven_column(), std::numeric_limits<double>::quiet_NaN());
  EXPECT_NE(message.find("the statics did not converge: relative residual "), std::string::npos) << message;
  EXPECT_NE(message.find("(limit 1e-13)"), std::string::npos) << message;
}

}  // namespace
}  // namespace rift::lattice
