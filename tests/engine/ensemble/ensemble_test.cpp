#include "engine/ensemble/ensemble.hpp"

#include "engine/reference/plain_simulation.hpp"
#include "tests/engine/simulation/small_plate.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace rift::ensemble {
namespace {

/// Everything at once: four laws, one of two velocities, each lane damped in its own way.
std::vector<fracture::LaneScenario> motley(const simulation::Prepared& p) {
  std::vector<fracture::LaneScenario> lanes = simulation::four_laws(p);
  lanes[1].history = history::history_of(-lanes[1].law.zone_length, {{300.0, 1e-3}, {2100.0, 1.0}});
  lanes[2].alpha_at_surface = 0.01;
  lanes[3].alpha_elsewhere = 0.0;
  return lanes;
}

const std::vector<std::string> damped{"damping.alpha=0.001", "damping.region=all"};

/// Marches with numerical damping and a moving grip.
void march_on(Ensemble& s, int steps) {
  s.set_beta(0.95);
  s.set_grip_speed(1.0);
  for (int n = 0; n < steps; ++n) s.step();
}

void expect_same_bits(CrackedEnsemble& a, int lane_a, CrackedEnsemble& b, int lane_b) {
  ASSERT_FALSE(a.lattice().centre.empty());
  for (int i = 0; i < static_cast<int>(a.lattice().centre.size()); ++i) {
    ASSERT_EQ(a.motion(i, lane_a), b.motion(i, lane_b)) << "element " << i;
    ASSERT_EQ(a.velocity(i, lane_a), b.velocity(i, lane_b)) << "element " << i;
  }
  ASSERT_FALSE(a.damageable().empty());
  for (int k = 0; k < static_cast<int>(a.damageable().size()); ++k) {
    ASSERT_EQ(a.factor(k, lane_a), b.factor(k, lane_b));
    ASSERT_EQ(a.fracture_energy(k, lane_a), b.fracture_energy(k, lane_b));
  }
  const fracture::EnergyBalance mine = a.balance(lane_a), its = b.balance(lane_b);
  for (const auto term :
       {&fracture::EnergyBalance::elastic, &fracture::EnergyBalance::kinetic_translation,
        &fracture::EnergyBalance::kinetic_rotation, &fracture::EnergyBalance::step_correction,
        &fracture::EnergyBalance::damping, &fracture::EnergyBalance::numerical_damping,
        &fracture::EnergyBalance::work_external})
    EXPECT_EQ(mine.*term, its.*term);
  EXPECT_EQ(a.tip(lane_a), b.tip(lane_b));
  EXPECT_GT(mine.fracture, 0.0);
}

void expect_lanes_to_be_their_own_runs(Precision precision, lattice::Kinematics kinematics) {
  const simulation::Prepared p = simulation::small_plate(damped);
  const std::vector<fracture::LaneScenario> lanes = motley(p);
  for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (!is_available(set)) continue;
    const EnsembleOptions options{.kinematics = kinematics, .precision = precision, .instructions = set};
    CrackedEnsemble together = simulation::ready(p, lanes, p.step.dt, options);
    march_on(together, 120);
    for (int lane = 0; lane < 4; ++lane) {
      SCOPED_TRACE(testing::Message() << name_of(set) << " lane " << lane);
      CrackedEnsemble alone = simulation::ready(p, {lanes[lane]}, p.step.dt, options);
      march_on(alone, 120);
      expect_same_bits(together, lane, alone, 0);
    }
    EXPECT_NE(together.motion(5, 0), together.motion(5, 1));
    EXPECT_NE(together.motion(5, 2), together.motion(5, 3));
  }
}

TEST(Lanes, AreBitForBitTheirOwnSingleRuns) {
  expect_lanes_to_be_their_own_runs(Precision::double_precision, lattice::Kinematics::linear);
}
TEST(Lanes, AreTheirOwnSingleRunsInSinglePrecision) {
  expect_lanes_to_be_their_own_runs(Precision::single_precision, lattice::Kinematics::linear);
}
TEST(Lanes, AreTheirOwnSingleRunsWithCorotationalBeams) {
  expect_lanes_to_be_their_own_runs(Precision::double_precision, lattice::Kinematics::corotational);
}

void expect_any_threads_to_give_the_same(Precision precision, lattice::Kinematics kinematics, int scenarios) {
  const simulation::Prepared p = simulation::small_plate(damped);
  std::vector<fracture::LaneScenario> lanes = motley(p);
  lanes.resize(scenarios);
  CrackedEnsemble one =
      simulation::ready(p, lanes, p.step.dt, {.kinematics = kinematics, .precision = precision});
  march_on(one, 120);
  for (const int threads : {2, 3, 5}) {
    CrackedEnsemble several = simulation::ready(
        p, lanes, p.step.dt, {.kinematics = kinematics, .precision = precision, .threads = threads});
    ASSERT_EQ(several.threads(), threads);
    march_on(several, 120);
    for (int lane = 0; lane < scenarios; ++lane) expect_same_bits(one, lane, several, lane);
  }
}

TEST(Threads, GiveTheSameBitsWhateverTheirNumber) {
  expect_any_threads_to_give_the_same(Precision::double_precision, lattice::Kinematics::linear, 1);
  expect_any_threads_to_give_the_same(Precision::double_precision, lattice::Kinematics::linear, 4);
  expect_any_threads_to_give_the_same(Precision::single_precision, lattice::Kinematics::linear, 4);
  expect_any_threads_to_give_the_same(Precision::double_precision, lattice::Kinematics::corotational, 1);
}

// A lane that is put back in the middle of a run does what it would have done from the start.
TEST(Lanes, GoOnWithAnotherScenarioAsIfItWereTheFirst) {
  const simulation::Prepared p = simulation::small_plate(damped);
  const std::vector<fracture::LaneScenario> lanes = motley(p);
  for (const double beta : {1.0, 0.95}) {
    const auto ready_with_beta = [&](const std::vector<fracture::LaneScenario>& scenarios) {
      CrackedEnsemble s = simulation::ready(p, scenarios, p.step.dt);
      s.set_beta(beta);
      return s;
    };
    CrackedEnsemble s = ready_with_beta(lanes);
    for (int n = 0; n < 50; ++n) s.step();
    s.refill(2, lanes[0]);
    EXPECT_EQ(s.steps_done(2), 0);
    for (int n = 0; n < 120; ++n) s.step();
    CrackedEnsemble fresh = ready_with_beta({lanes[0]}), untouched = ready_with_beta({lanes[1]});
    for (int n = 0; n < 120; ++n) fresh.step();
    for (int n = 0; n < 170; ++n) untouched.step();
    expect_same_bits(s, 2, fresh, 0);
    expect_same_bits(s, 1, untouched, 0);
    EXPECT_LT(std::abs(s.balance(2).error), 1e-12);
  }
}

// As a lane is steered again: the beams that were damped before are damped on, with no step's work lost.
TEST(Damping, ThatIsSetAgainGoesOnWhereItWas) {
  const simulation::Prepared p = simulation::small_plate(damped);
  CrackedEnsemble once = simulation::ready(p, motley(p), p.step.dt);
  CrackedEnsemble again = simulation::ready(p, motley(p), p.step.dt);
  for (int n = 0; n < 120; ++n) {
    if (n % 10 == 7) again.damp(p.damped);
    once.step(), again.step();
  }
  for (int lane = 0; lane < 3; ++lane) {
    for (int i = 0; i < static_cast<int>(p.lattice.centre.size()); ++i)
      ASSERT_EQ(once.motion(i, lane), again.motion(i, lane)) << "element " << i;
    const double damping = once.balance(lane).damping;
    EXPECT_GT(damping, 0.0);
    EXPECT_NEAR(again.balance(lane).damping, damping, 1e-12 * damping);
    EXPECT_LT(std::abs(again.balance(lane).error), 1e-12);
  }
}

/// Looked at now and then, with changes right after a look, against the same run that nobody looks at.
void expect_looks_to_leave_no_trace(const simulation::Prepared& p, const EnsembleOptions& options,
                                    int scenarios, bool dissipates) {
  std::vector<fracture::LaneScenario> lanes = motley(p);
  lanes.resize(scenarios);
  CrackedEnsemble seen = simulation::ready(p, lanes, p.step.dt, options),
                  unseen = simulation::ready(p, lanes, p.step.dt, options);
  fracture::LaneScenario other = lanes[0];
  other.alpha_at_surface *= 2.0;
  for (int n = 0; n < 120; ++n) {
    for (CrackedEnsemble* s : {&seen, &unseen}) {
      if (n == 40) s->steer(0, other);
      if (n == 60) s->refill(scenarios - 1, lanes[0]);
      if (n == 20 && dissipates) s->set_grip_speed(1.0);
      if (n == 80 && dissipates) s->set_grip_speed(0.5);
      if (n == 70 && dissipates) s->set_beta(0.95);
      s->step();
    }
    if (n % 3 == 0 || n % 10 == 9) seen.balance(0);
    if (n % 20 == 19) seen.velocity(3, 0);
  }
  for (int lane = 0; lane < scenarios; ++lane) expect_same_bits(seen, lane, unseen, lane);
}

TEST(Energies, LeaveNoTraceInTheStepThatTheyShareTheirForcesWith) {
  for (const bool dissipates : {false, true}) {
    const simulation::Prepared p = simulation::small_plate(dissipates ? damped : std::vector<std::string>{});
    for (const lattice::Kinematics kinematics :
         {lattice::Kinematics::linear, lattice::Kinematics::corotational})
      for (const Precision precision : {Precision::double_precision, Precision::single_precision})
        for (const int scenarios : {1, 4}) {
          SCOPED_TRACE(testing::Message()
                       << "dissipates " << dissipates << ", corotational "
                       << (kinematics == lattice::Kinematics::corotational) << ", single "
                       << (precision == Precision::single_precision) << ", lanes " << scenarios);
          expect_looks_to_leave_no_trace(p, {.kinematics = kinematics, .precision = precision, .threads = 2},
                                         scenarios, dissipates);
        }
  }
}

// The elastic energy of linear beams is half the work of the forces of the walk; here it is that of each
// beam.
TEST(Energies, OfTheWalkAreThoseOfTheBeamsOneByOne) {
  const simulation::Prepared p = simulation::small_plate({"crack.start=6 mm"});  // behind a notch
  CrackedEnsemble s = simulation::ready(p, simulation::four_laws(p), p.step.dt);
  s.set_grip_speed(5.0);
  for (int n = 0; n < 150; ++n) s.step();
  for (int lane = 0; lane < 4; ++lane) {
    double elastic = 0.0;
    for (const double energy : s.elastic_by_element(lane)) elastic += energy;
    EXPECT_GT(s.balance(lane).fracture, 0.0);
    // The static solve leaves forces of 1e-12 of the load.
    EXPECT_NEAR(s.balance(lane).elastic / elastic, 1.0, 1e-12);
  }
}

// The kernels sum and round in another order than the plain path; 200 steps let that grow to some hundred
// roundings.
TEST(Ensemble, MarchesAsThePlainPathDoes) {
  const simulation::Prepared p = simulation::small_plate(damped);
  for (const fracture::LaneScenario& lane : not_empty(motley(p))) {
    reference::PlainSimulation plain(p.lattice, fracture::damageable_beams(p.path, p.lattice, 0.0), p.step.dt,
                                     lane);
    plain.start_from(p.displacement);
    plain.start_crack(p.damped);
    plain.beta = 0.95;
    plain.set_grip_speed(1.0);
    for (int n = 0; n < 200; ++n) plain.step();
    CrackedEnsemble s = simulation::ready(p, {lane}, p.step.dt);
    march_on(s, 200);
    double fastest = 0.0;
    for (std::size_t k = 0; k < plain.v.size(); k += 6) fastest = std::max(fastest, std::abs(plain.v[k]));
    ASSERT_FALSE(p.lattice.centre.empty());
    for (int i = 0; i < static_cast<int>(p.lattice.centre.size()); ++i) {
      EXPECT_NEAR((s.motion(i, 0) - plain.motion(plain.q, i)).head<3>().norm() / 0.6e-3, 0.0, 1e-11);
      EXPECT_NEAR((s.velocity(i, 0) - plain.motion(plain.v, i)).head<3>().norm() / fastest, 0.0, 1e-9);
    }
    const fracture::EnergyBalance mine = s.balance(0), its = plain.evaluate_balance();
    for (const auto term :
         {&fracture::EnergyBalance::elastic, &fracture::EnergyBalance::kinetic_translation,
          &fracture::EnergyBalance::kinetic_rotation, &fracture::EnergyBalance::step_correction,
          &fracture::EnergyBalance::fracture, &fracture::EnergyBalance::damping,
          &fracture::EnergyBalance::numerical_damping, &fracture::EnergyBalance::work_external})
      EXPECT_NEAR(mine.*term, its.*term, 1e-9 * its.largest);
  }
}

TEST(Momentum, OfAFreePlateStaysWhereItIsWhileItCracksAndIsDamped) {
  const simulation::Prepared p = simulation::small_plate({"damping.alpha=0.01", "damping.region=all"});
  lattice::Lattice free = p.lattice;
  free.grip.assign(free.grip.size(), packing::Grip::none);
  for (const fracture::LaneScenario& law : not_empty(simulation::four_laws(p))) {
    CrackedEnsemble s(free, p.path, 0.0, p.step.dt, {law});
    s.release_from(p.displacement);  // stretched and let go
    s.start_crack(p.damped);
    for (int n = 0; n < 200; ++n) s.step();
    Eigen::Vector3d linear = Eigen::Vector3d::Zero(), angular = linear;
    double size = 0.0, turning = 0.0;
    for (int i = 0; i < static_cast<int>(free.centre.size()); ++i) {
      const lattice::Vector6 v = s.velocity(i, 0);
      const Eigen::Vector3d momentum = free.mass[i] * v.head<3>();
      linear += momentum;
      angular += free.centre[i].cross(momentum) + free.inertia[i] * v.tail<3>();
      size += momentum.norm();
      turning += free.centre[i].cross(momentum).norm();
    }
    EXPECT_GT(s.balance(0).fracture, 0.0);
    // Rounding of 200 steps over 2,000 beams, against the sum of the sizes.
    EXPECT_NEAR(linear.norm() / size, 0.0, 1e-12);
    EXPECT_NEAR(angular.norm() / turning, 0.0, 1e-12);
  }
}

TEST(Release, OfABeamIsAtTheFirstStepWithTheTipAtItsCrossing) {
  const simulation::Prepared p = simulation::small_plate({"crack.technique=simple"});
  CrackedEnsemble s = simulation::ready(p);
  ASSERT_GT(s.damageable().size(), 50U);
  for (int n = 0; n < 150; ++n) {
    s.step();
    for (int k = 0; k < static_cast<int>(s.damageable().size()); ++k)
      ASSERT_EQ(s.factor(k, 0), s.tip(0) >= s.damageable()[k].position ? 0.0 : 1.0)
          << "step " << n << ", beam " << k;
  }
  EXPECT_EQ(s.factor(10, 0), 0.0);
  EXPECT_EQ(s.factor(static_cast<int>(s.damageable().size()) - 1, 0), 1.0);
}

TEST(Release, OfADamagedBeamFollowsItsLawAtEveryStep) {
  const simulation::Prepared p =
      simulation::small_plate({"crack.relaxation=quadratic", "crack.damage_zone_ratio=3"});
  CrackedEnsemble s = simulation::ready(p);
  int partly = 0;
  for (int n = 0; n < 150; ++n) {
    s.step();
    ASSERT_FALSE(s.damageable().empty());
    for (int k = 0; k < static_cast<int>(s.damageable().size()); ++k) {
      ASSERT_EQ(s.factor(k, 0),
                fracture::stiffness_left(p.lane[0].scenario.law, s.tip(0), s.damageable()[k].position));
      partly += s.factor(k, 0) > 0.0 && s.factor(k, 0) < 1.0 ? 1 : 0;
    }
  }
  EXPECT_GT(partly, 500);
}

// With the linear law a step takes v dt / L_CZM of a beam, no beam more than that; also behind a notch, whose
// tip begins L_CZM short of it.
TEST(Release, DamagesNoBeamInOneJump) {
  for (const std::string start : {"crack.start=0", "crack.start=0.006"}) {
    const simulation::Prepared p = simulation::small_plate({start, "crack.damage_zone_ratio=2"});
    CrackedEnsemble s = simulation::ready(p);
    std::vector<double> before(s.damageable().size(), 1.0);
    for (std::size_t k = 0; k < before.size(); ++k) before[k] = s.factor(static_cast<int>(k), 0);
    const double most = s.dt() * 1100.0 / p.lane[0].scenario.law.zone_length;
    ASSERT_LT(most, 0.2);
    double largest = 0.0;
    for (int n = 0; n < 150; ++n) {
      s.step();
      for (int k = 0; k < static_cast<int>(s.damageable().size()); ++k) {
        largest = std::max(largest, before[k] - s.factor(k, 0));
        before[k] = s.factor(k, 0);
      }
    }
    EXPECT_LE(largest, most * (1.0 + 1e-9));
    EXPECT_GT(largest, 0.9 * most);
  }
}

// The pre-stress, which has no notch to cut then, leaves such beams whole, too.
TEST(Notch, WithoutLengthCutsNoBeamThatIsCrossedAtItsEnd) {
  const simulation::Prepared p = simulation::small_plate({});
  const Eigen::Vector2d from = p.lattice.centre[p.lattice.centre.size() / 2].head<2>();
  const fracture::CrackPath path{{from, from + Eigen::Vector2d(10e-3, 0.0)}};  // from an element's centre on
  const auto at_its_end = [](const fracture::Crossing& crossing) { return crossing.position == 0.0; };
  const std::vector<fracture::Crossing> met = fracture::crossings(path, p.lattice);
  ASSERT_GT(std::count_if(met.begin(), met.end(), at_its_end), 0);
  for (const auto& [notch, left] : {std::pair{0.0, 1.0}, std::pair{1e-6, 0.0}}) {
    CrackedEnsemble s(p.lattice, path, notch, p.step.dt, {p.lane[0].scenario});
    s.start_from(p.displacement);
    for (std::size_t k = 0; k < met.size(); ++k)
      if (at_its_end(met[k])) {
        EXPECT_EQ(s.factor(static_cast<int>(k), 0), left) << "notch of " << notch;
      }
  }
}

TEST(Release, LeavesARunAtRestWhileThereIsNothingToRelease) {
  const simulation::Prepared p = simulation::small_plate();
  CrackedEnsemble s(p.lattice, p.path, 0.0, p.step.dt, {p.lane[0].scenario});
  s.start_from(p.displacement);  // and no crack
  const double stored = s.balance(0).elastic;
  for (int n = 0; n < 50; ++n) s.step();
  const fracture::EnergyBalance e = s.balance(0);
  // The static solve leaves forces of 1e-12 of the load: energies of the square of it.
  EXPECT_NEAR(e.kinetic_translation / stored, 0.0, 1e-18);
  EXPECT_NEAR(e.elastic / stored, 1.0, 1e-10);
}

TEST(Grip, MovesTheTopAloneAndOnlyAlongY) {
  const simulation::Prepared p = simulation::small_plate();
  CrackedEnsemble s(p.lattice, p.path, 0.0, p.step.dt, {p.lane[0].scenario});
  s.start_from(p.displacement);
  s.set_grip_speed(3.0);
  for (int n = 0; n < 40; ++n) s.step();
  s.set_grip_speed(0.0);
  for (int n = 0; n < 10; ++n) s.step();
  int top = 0, bottom = 0;
  ASSERT_FALSE(p.lattice.grip.empty());
  for (int i = 0; i < static_cast<int>(p.lattice.grip.size()); ++i) {
    if (p.lattice.grip[i] == packing::Grip::none) continue;
    const bool is_top = p.lattice.grip[i] == packing::Grip::top;
    ++(is_top ? top : bottom);
    lattice::Vector6 expected = lattice::Vector6::Zero();
    if (is_top) expected[1] = 0.6e-3 + 40 * 3.0 * p.step.dt;
    EXPECT_NEAR((s.motion(i, 0) - expected).norm(), 0.0, 1e-15);  // rounding of 40 sums
  }
  EXPECT_GT(top, 10);
  EXPECT_GT(bottom, 10);
}

}  // namespace
}  // namespace rift::ensemble
