#include "tests/engine/simulation/small_plate.hpp"

#include <cmath>

namespace rift::ensemble {
namespace {

/// Steps to the end of the crack's way, looking at the books now and then: the worst residual of each lane.
std::vector<double> worst_residuals(CrackedEnsemble& s, double end, double grip_speed) {
  std::vector<double> worst(s.scenarios(), 0.0);
  s.set_grip_speed(grip_speed);
  for (int n = 0; s.tip(0) < end; ++n) {
    if (n == 100) s.set_grip_speed(0.5 * grip_speed);
    s.step();
    if (n % 20 != 0) continue;
    for (int lane = 0; lane < s.scenarios(); ++lane)
      worst[lane] = std::max(worst[lane], std::abs(s.balance(lane).error));
  }
  return worst;
}

/// What is switched on beside the crack.
struct Extras {
  const char* name;
  std::vector<std::string> damping;
  double beta = 1.0, grip_speed = 0.0;
};

const std::vector<std::string> at_surface{"damping.alpha=0.001", "damping.region=surface"};
const std::vector<std::string> everywhere{"damping.alpha=0.01", "damping.region=all"};

void expect_closed_books(const Extras& extras) {
  const simulation::Prepared p = simulation::small_plate(extras.damping);
  for (const double fraction : {0.17, 0.5, 0.9}) {
    CrackedEnsemble s = simulation::ready(p, simulation::four_laws(p), fraction * p.step.critical);
    s.set_beta(extras.beta);
    const auto worst = worst_residuals(s, p.lane[0].crack_end, extras.grip_speed);
    for (int lane = 0; lane < 4; ++lane) {
      SCOPED_TRACE(testing::Message() << extras.name << ", " << fraction << " of critical, law " << lane);
      // Issue: 1e-10. What is left is rounding, some 1e-16 a step; 1e-13 would still show a term of the wrong
      // kind, which misses by 5e-4 and more   [model.md §7].
      EXPECT_LT(worst[lane], 1e-13);
      const fracture::EnergyBalance end = s.balance(lane);
      EXPECT_GT(end.fracture, 0.05 * s.balance(lane).largest);
      EXPECT_EQ(end.damping > 1e-6 * s.balance(lane).largest, !extras.damping.empty());
      EXPECT_EQ(end.numerical_damping > 1e-6 * s.balance(lane).largest, extras.beta < 1.0);
      EXPECT_EQ(std::abs(end.work_external) > 1e-6 * s.balance(lane).largest, extras.grip_speed != 0.0);
    }
  }
}

TEST(Books, CloseWithoutAnyDamping) { expect_closed_books({"undamped", {}}); }
TEST(Books, CloseWithDampingAtTheSurface) { expect_closed_books({"at the surface", at_surface}); }
TEST(Books, CloseWithDampingEverywhere) { expect_closed_books({"everywhere", everywhere}); }
TEST(Books, CloseWithNumericalDamping) { expect_closed_books({"beta", {}, 0.9}); }
TEST(Books, CloseWithAMovingGrip) { expect_closed_books({"grip", {}, 1.0, 5.0}); }
TEST(Books, CloseWithAllOfItTogether) { expect_closed_books({"all", everywhere, 0.9, 5.0}); }

// The elements of the grips turn, and what their rotation holds and loses is in the balance like any other.
TEST(Books, CloseWithGripsThatLetTheirElementsTurn) {
  expect_closed_books({"turning grips",
                       {"loading.grip_rotation=free", "damping.alpha=0.01", "damping.region=all"},
                       0.9,
                       5.0});
}

TEST(Books, CloseInEveryRowOfARampedRun) {
  const simulation::Prepared p =
      simulation::small_plate({"loading.method=ramp", "loading.ramp_steps=800", "loading.hold_steps=800",
                               "damping.alpha=0.001", "damping.region=surface"});
  const simulation::RunResult result = simulation::march(p, {});
  EXPECT_EQ(result.outcome, simulation::Outcome::finished) << result.lane[0].where;
  EXPECT_LT(result.lane[0].worst_residual, 1e-13);
  EXPECT_GT(result.lane[0].samples.back().work_external_j, 0.0);
  EXPECT_GT(result.lane[0].samples.back().numerical_damping_j, 0.0);
}

// Nothing is booked as the remainder: an error of one beam's booking shows in full.
TEST(Books, OpenByExactlyWhatOneBeamBooksTooMuch) {
  const simulation::Prepared p = simulation::small_plate();
  CrackedEnsemble s = simulation::ready(p);
  while (s.tip(0) < p.lane[0].crack_end) s.step();
  const double before = s.balance(0).error;
  const NamedNumbers right = s.state();
  for (const int beam : {3, static_cast<int>(s.damageable().size()) / 2}) {
    NamedNumbers wrong = right;
    wrong["booked"][static_cast<std::size_t>(beam)] += 1e-3 * s.balance(0).largest;
    s.restore(wrong);
    // 1e-15: one rounding of the sum of the energies, which is of the order of the largest.
    EXPECT_NEAR(s.balance(0).error - before, 1e-3, 1e-15);
    s.restore(right);
  }
}

// What the plate holds grows while it is pulled and falls while it cracks; the largest stays.
TEST(Books, NoteTheLargestEnergySoFar) {
  const simulation::Prepared p = simulation::small_plate();
  CrackedEnsemble s = simulation::ready(p);
  s.set_grip_speed(10.0);
  double largest = s.balance(0).total();
  const double start = largest;
  while (s.tip(0) < p.lane[0].crack_end) {
    s.step();
    const fracture::EnergyBalance now = s.balance(0);
    largest = std::max(largest, now.total());
    ASSERT_EQ(now.largest, largest);
    if (s.tip(0) > 0.5 * p.lane[0].crack_end) s.set_grip_speed(0.0);
  }
  EXPECT_GT(largest, start);
  EXPECT_LT(s.balance(0).total(), 0.9 * largest);
}

TEST(Books, AreReadFromTheStateAndChangeNothing) {
  const simulation::Prepared p = simulation::small_plate();
  CrackedEnsemble read = simulation::ready(p), unread = simulation::ready(p);
  for (int n = 0; n < 100; ++n) {
    read.step();
    read.balance(0);
    unread.step();
  }
  ASSERT_FALSE(p.lattice.centre.empty());
  for (int i = 0; i < static_cast<int>(p.lattice.centre.size()); ++i) {
    ASSERT_EQ(read.motion(i, 0), unread.motion(i, 0));
    ASSERT_EQ(read.velocity(i, 0), unread.velocity(i, 0));
  }
}

}  // namespace
}  // namespace rift::ensemble
