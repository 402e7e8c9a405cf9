#include "engine/simulation/simulation.hpp"

#include "tests/engine/simulation/small_plate.hpp"

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace rift {
namespace {

// Different velocities, laws and damping, one step: what a lane does is none of its neighbours' business.
TEST(Lanes, AreBitForBitTheirOwnSingleRuns) {
  const Prepared p = small_plate({"damping.alpha=0.001", "damping.region=all"});
  std::array<LaneScenario, 4> lanes = four_laws(p);
  lanes[1].history = history_of(-lanes[1].law.zone_length, {{300.0, 1e-3}, {2100.0, 1.0}});
  lanes[2].alpha_at_surface = 0.01;
  lanes[3].alpha_elsewhere = 0.0;
  Simulation<4> together = ready<4>(p, lanes, p.step.dt);
  together.beta = 0.95;
  together.set_grip_speed(1.0);
  std::vector<Simulation<1>> alone;
  for (const LaneScenario& lane : lanes) {
    alone.push_back(ready<1>(p, {lane}, p.step.dt));
    alone.back().beta = 0.95;
    alone.back().set_grip_speed(1.0);
  }
  for (int n = 0; n < 200; ++n) {
    together.step();
    for (auto& s : alone) s.step();
  }
  for (int lane = 0; lane < 4; ++lane) {
    const Simulation<1>& s = alone[lane];
    for (int i = 0; i < static_cast<int>(p.lattice.centre.size()); ++i) {
      ASSERT_EQ(together.motion(together.q, i, lane), s.motion(s.q, i, 0)) << "lane " << lane << ", " << i;
      ASSERT_EQ(together.motion(together.v, i, lane), s.motion(s.v, i, 0)) << "lane " << lane << ", " << i;
    }
    for (std::size_t k = 0; k < s.met.size(); ++k) {
      ASSERT_EQ(together.factor[4 * k + lane], s.factor[k]);
      ASSERT_EQ(together.booked[4 * k + lane], s.booked[k]);
    }
    const results::Sample mine = together.sample(lane, results::Phase::fracture),
                          its = alone[lane].sample(0, results::Phase::fracture);
    EXPECT_EQ(mine.elastic_j, its.elastic_j);
    EXPECT_EQ(mine.damping_j, its.damping_j);
    EXPECT_EQ(mine.numerical_damping_j, its.numerical_damping_j);
    EXPECT_EQ(mine.work_external_j, its.work_external_j);
    EXPECT_EQ(mine.tip_m, its.tip_m);
    EXPECT_GT(mine.fracture_j, 0.0);
  }
  EXPECT_NE(alone[0].q, alone[1].q);
  EXPECT_NE(alone[2].q, alone[3].q);
}

TEST(Momentum, OfAFreePlateStaysWhereItIsWhileItCracksAndIsDamped) {
  const Prepared p = small_plate({"damping.alpha=0.01", "damping.region=all"});
  Lattice free = p.lattice;
  free.grip.assign(free.grip.size(), Grip::none);
  for (const LaneScenario& law : four_laws(p)) {
    Simulation<1> s(free, p.path, 0.0, p.step.dt, {law});
    s.start_from(p.displacement);  // stretched and let go
    s.start_crack(p.damped);
    for (int n = 0; n < 200; ++n) s.step();
    Eigen::Vector3d linear = Eigen::Vector3d::Zero(), angular = linear;
    double size = 0.0, turning = 0.0;
    for (int i = 0; i < static_cast<int>(free.centre.size()); ++i) {
      const Vector6 v = s.motion(s.v, i, 0);
      const Eigen::Vector3d momentum = free.mass[i] * v.head<3>();
      linear += momentum;
      angular += free.centre[i].cross(momentum) + free.inertia[i] * v.tail<3>();
      size += momentum.norm();
      turning += free.centre[i].cross(momentum).norm();
    }
    EXPECT_GT(s.sample(0, results::Phase::fracture).fracture_j, 0.0);
    // Rounding of 200 steps over 2,000 beams, against the sum of the sizes.
    EXPECT_NEAR(linear.norm() / size, 0.0, 1e-12);
    EXPECT_NEAR(angular.norm() / turning, 0.0, 1e-12);
  }
}

TEST(Release, OfABeamIsAtTheFirstStepWithTheTipAtItsCrossing) {
  const Prepared p = small_plate({"crack.technique=simple"});
  Simulation<1> s = ready(p);
  ASSERT_GT(s.met.size(), 50U);
  for (int n = 0; n < 150; ++n) {
    s.step();
    for (std::size_t k = 0; k < s.met.size(); ++k)
      ASSERT_EQ(s.factor[k], s.tip(0) >= s.met[k].position ? 0.0 : 1.0) << "step " << n << ", beam " << k;
  }
  EXPECT_EQ(s.factor[10], 0.0);
  EXPECT_EQ(s.factor.back(), 1.0);
}

TEST(Release, OfADamagedBeamFollowsItsLawAtEveryStep) {
  const Prepared p = small_plate({"crack.relaxation=quadratic", "crack.damage_zone_ratio=3"});
  Simulation<1> s = ready(p);
  int partly = 0;
  for (int n = 0; n < 150; ++n) {
    s.step();
    for (std::size_t k = 0; k < s.met.size(); ++k) {
      ASSERT_EQ(s.factor[k], stiffness_left(p.scenario.law, s.tip(0), s.met[k].position));
      partly += s.factor[k] > 0.0 && s.factor[k] < 1.0 ? 1 : 0;
    }
  }
  EXPECT_GT(partly, 500);
}

// With the linear law a step takes v dt / L_CZM of a beam, no beam more than that; also behind a notch, whose
// tip begins L_CZM short of it.
TEST(Release, DamagesNoBeamInOneJump) {
  for (const std::string start : {"crack.start=0", "crack.start=0.006"}) {
    const Prepared p = small_plate({start, "crack.damage_zone_ratio=2"});
    Simulation<1> s = ready(p);
    std::vector<double> before = s.factor;
    const double most = s.dt * 1100.0 / p.scenario.law.zone_length;
    ASSERT_LT(most, 0.2);
    double largest = 0.0;
    for (int n = 0; n < 150; ++n) {
      s.step();
      for (std::size_t k = 0; k < s.met.size(); ++k) largest = std::max(largest, before[k] - s.factor[k]);
      before = s.factor;
    }
    EXPECT_LE(largest, most * (1.0 + 1e-9));
    EXPECT_GT(largest, 0.9 * most);
  }
}

TEST(Release, LeavesARunAtRestWhileThereIsNothingToRelease) {
  const Prepared p = small_plate();
  Simulation<1> s(p.lattice, p.path, 0.0, p.step.dt, {p.scenario});
  s.start_from(p.displacement);  // and no crack
  const double stored = s.energy(0).elastic;
  for (int n = 0; n < 50; ++n) s.step();
  const LatticeEnergy e = s.energy(0);
  // The static solve leaves forces of 1e-12 of the load: energies of the square of it.
  EXPECT_NEAR(e.kinetic_translation / stored, 0.0, 1e-18);
  EXPECT_NEAR(e.elastic / stored, 1.0, 1e-10);
}

TEST(Grip, MovesTheTopAloneAndOnlyAlongY) {
  const Prepared p = small_plate();
  Simulation<1> s(p.lattice, p.path, 0.0, p.step.dt, {p.scenario});
  s.start_from(p.displacement);
  s.set_grip_speed(3.0);
  for (int n = 0; n < 40; ++n) s.step();
  s.set_grip_speed(0.0);
  for (int n = 0; n < 10; ++n) s.step();
  int top = 0, bottom = 0;
  for (int i = 0; i < static_cast<int>(p.lattice.grip.size()); ++i) {
    if (p.lattice.grip[i] == Grip::none) continue;
    const bool is_top = p.lattice.grip[i] == Grip::top;
    ++(is_top ? top : bottom);
    Vector6 expected = Vector6::Zero();
    if (is_top) expected[1] = 0.6e-3 + 40 * 3.0 * p.step.dt;
    EXPECT_NEAR((s.motion(s.q, i, 0) - expected).norm(), 0.0, 1e-15);  // rounding of 40 sums
  }
  EXPECT_GT(top, 10);
  EXPECT_GT(bottom, 10);
}

}  // namespace
}  // namespace rift
