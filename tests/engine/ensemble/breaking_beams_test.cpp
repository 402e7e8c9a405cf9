#include "engine/ensemble/breaking_beams.hpp"

#include "engine/lattice/loads.hpp"
#include "tests/engine/lattice/hand_made.hpp"
#include "tests/engine/simulation/small_plate.hpp"

#include <cmath>

namespace rift::ensemble {
namespace {

using fracture::CohesiveMaterial;
using fracture::FractureLaw;

/// A notched plate whose beams may all break by themselves.
struct FreePlate {
  simulation::Prepared p = simulation::small_plate({"crack.start=0.008"});
  std::vector<fracture::DamageableBeam> beams = fracture::breakable_beams(p.path, p.lattice, 0.008);

  /// The strength in times of the mean stress under the pre-stress, and the energy of a beam in times of its
  /// elastic energy there.
  CohesiveMaterial material(double strength, double tail) const {
    CohesiveMaterial m{.young_modulus = p.preset.scene.material.young_modulus};
    const double strain = p.pulled / p.lattice.box.height;
    m.strength = strength * strain * m.young_modulus;
    const lattice::Beam& beam = p.lattice.beam.front();
    const double first = beam.length * m.strength / m.young_modulus;
    m.release_rate = tail * 0.5 * beam.axial * first * first / fracture::area_of_beam(p.lattice);
    return m;
  }
  Ensemble ensemble(const std::vector<fracture::LaneScenario>& scenarios,
                    const EnsembleOptions& options = {}) const {
    return Ensemble(p.lattice, beams, p.step.dt, scenarios, options,
                    std::make_shared<BreakingBeams>(p.lattice, p.step.dt));
  }
  int gone(const Ensemble& s, int lane) const {
    int count = 0;
    for (int k = 0; k < static_cast<int>(beams.size()); ++k)
      count += !beams[k].absent && s.factor(k, lane) == 0.0;
    return count;
  }
};

// A beam between two grips, drawn apart: the force follows the law, and what it has taken in the end is the
// energy of breaking it.
TEST(BreakingBeams, OneAloneFollowsTheLawAndTakesItsEnergy) {
  namespace hand_made = lattice::hand_made;
  lattice::Lattice bar = hand_made::chain(2, {0, 1, 0}, {});
  bar.grip = {packing::Grip::bottom, packing::Grip::top};
  const CohesiveMaterial material{.law = FractureLaw::cohesive,
                                  .release_rate = 2.5e-3,
                                  .strength = 0.3,
                                  .young_modulus = 3.0,
                                  .kappa = 0.5};
  const fracture::Softening soft = fracture::softening_of(bar, material).front();
  ASSERT_GT(soft.last, 2.0 * soft.first);
  const double axial = bar.beam.front().axial, dt = 1e-3;
  Ensemble s(bar, {{.beam = 0}}, dt, {{.material = material}}, {}, std::make_shared<BreakingBeams>(bar, dt));
  s.start_from(std::vector<lattice::Vector6>(2, lattice::Vector6::Zero()));
  s.start_crack({});
  s.set_grip_speed(soft.last / 2.0);
  for (int n = 1; n <= 2100; ++n) {
    s.step();
    const double opening = n * dt * soft.last / 2.0;
    if (n % 100 == 0) {
      EXPECT_NEAR(s.grip_force(0), axial * opening * fracture::stiffness_left(soft, opening),
                  1e-11 * axial * soft.first);
    }
    if (n == 1000) {  // it never heals
      const double left = s.factor(0, 0);
      s.set_grip_speed(-soft.last / 2.0);
      for (int back = 0; back < 100; ++back) s.step();
      EXPECT_EQ(s.factor(0, 0), left);
      s.set_grip_speed(soft.last / 2.0);
      for (int forth = 0; forth < 100; ++forth) s.step();
      EXPECT_NEAR(s.factor(0, 0), left, 1e-12);
    }
  }
  EXPECT_EQ(s.factor(0, 0), 0.0);
  EXPECT_NEAR(s.balance(0).fracture / (0.5 * axial * soft.first * soft.last), 1.0, 1e-5);
  EXPECT_NEAR(s.balance(0).work_external / s.balance(0).fracture, 1.0, 1e-12);
}

TEST(BreakingBeams, CloseTheEnergyBalanceUnderTractions) {
  const FreePlate plate;
  lattice::Lattice free = plate.p.lattice;
  std::fill(free.grip.begin(), free.grip.end(), packing::Grip::none);
  const double stress = 0.01 * plate.p.preset.scene.material.young_modulus;
  CohesiveMaterial soft{.release_rate = 1e4, .strength = 1.5 * stress, .young_modulus = 1e10};
  CohesiveMaterial brittle{.law = FractureLaw::snap, .release_rate = 1e4, .young_modulus = 1e10};
  for (const double beta : {1.0, 0.98}) {
    for (const double rise : {0.0, 3e-6}) {
      const std::vector<fracture::LaneScenario> lanes{{.material = soft, .load = {stress, rise}},
                                                      {.material = brittle, .load = {stress, rise}}};
      Ensemble s(free, plate.beams, plate.p.step.dt, lanes, {.threads = 2},
                 std::make_shared<BreakingBeams>(free, plate.p.step.dt));
      s.set_loads(lattice::opposite_tractions(free, 1));
      s.start_from(std::vector<lattice::Vector6>(free.centre.size(), lattice::Vector6::Zero()));
      s.set_beta(beta);
      s.start_crack({});
      double worst = 0.0;
      for (int n = 0; n < 400; ++n) {
        s.step();
        for (int lane = 0; n % 20 == 19 && lane < 2; ++lane)
          worst = std::max(worst, std::abs(s.balance(lane).error));
      }
      EXPECT_LT(worst, 1e-12) << "beta " << beta << ", rise " << rise;
      for (const int lane : {0, 1}) {
        EXPECT_GT(plate.gone(s, lane), 10) << lane;
        EXPECT_GT(s.balance(lane).fracture, 0.0);
        EXPECT_GT(s.balance(lane).work_external, s.balance(lane).fracture);
      }
    }
  }
}

TEST(BreakingBeams, LoseNothingThatIsPressed) {
  const FreePlate plate;
  const CohesiveMaterial material = plate.material(1.2, 4.0);
  std::vector<lattice::Vector6> pressed = plate.p.displacement;
  for (lattice::Vector6& q : pressed) q *= -1.0;
  int gone_when_pulled = 0;
  for (const double sign : {1.0, -1.0}) {
    Ensemble s = plate.ensemble({{.material = material}});
    s.start_from(sign > 0.0 ? plate.p.displacement : pressed);
    s.start_crack({});
    int along_the_load = 0, damaged_while_pressed = 0;
    for (int n = 0; n < 100; ++n) {
      s.step();
      for (const DamageIncrement& d : s.damage()) {
        const lattice::Beam& beam = plate.p.lattice.beam[plate.beams[d.k].beam];
        along_the_load += std::abs(beam.axis.y()) > 0.8;
        const auto& [i, j] = plate.p.lattice.ends[plate.beams[d.k].beam];
        damaged_while_pressed += strain_of(beam, s.motion(i, 0), s.motion(j, 0)).stretch <= 0.0;
      }
    }
    EXPECT_EQ(damaged_while_pressed, 0);
    if (sign > 0.0) {
      EXPECT_GT(along_the_load, 100);
      gone_when_pulled = plate.gone(s, 0);
    } else {
      EXPECT_LE(10 * plate.gone(s, 0), gone_when_pulled);  // across the load it is in tension
    }
  }
}

TEST(BreakingBeams, AreTheSameForAnyThreadsAndWhateverMarchesBesideThem) {
  const FreePlate plate;
  std::vector<fracture::LaneScenario> lanes;
  for (const double strength : {0.9, 1.1, 1.3, 1.5})
    lanes.push_back({.material = plate.material(strength, 3.0)});
  const auto marched = [&](const std::vector<fracture::LaneScenario>& some, int threads,
                           Precision precision) {
    Ensemble s = plate.ensemble(some, {.precision = precision, .threads = threads});
    s.start_from(plate.p.displacement);
    s.start_crack({});
    for (int n = 0; n < 200; ++n) s.step();
    return s;
  };
  for (const Precision precision : {Precision::double_precision, Precision::single_precision}) {
    Ensemble together = marched(lanes, 1, precision), shared_out = marched(lanes, 2, precision);
    EXPECT_GT(plate.gone(together, 0), 20);
    for (const int lane : {0, 2}) {
      Ensemble alone = marched({lanes[lane]}, 1, precision);
      EXPECT_NE(plate.gone(together, 0), plate.gone(together, 2));
      for (int k = 0; k < static_cast<int>(plate.beams.size()); ++k) {
        ASSERT_EQ(together.factor(k, lane), shared_out.factor(k, lane));
        ASSERT_EQ(together.factor(k, lane), alone.factor(k, 0)) << k;
      }
      for (int i = 0; i < static_cast<int>(plate.p.lattice.centre.size()); ++i) {
        ASSERT_EQ(together.motion(i, lane), shared_out.motion(i, lane));
        ASSERT_EQ(together.motion(i, lane), alone.motion(i, 0)) << i;
      }
    }
    EXPECT_LT(std::abs(together.balance(0).error), precision == Precision::double_precision ? 1e-12 : 1e-3);
  }
}

/// The same law, which looks at every beam after every step and leaves all of them to the list of damageable
/// beams.
class EveryBeam : public ReleaseRule {
 public:
  EveryBeam(std::vector<fracture::Softening> beams, double dt) : beam_(std::move(beams)), dt_(dt) {}
  void set_lane(int, const fracture::LaneScenario&) override {}
  void start(int, std::int64_t) override {}
  void predict_damage(const State&, std::int64_t, std::vector<DamageIncrement>&) override {}
  void follow_damage(const State& state, std::vector<DamageIncrement>& increments) override {
    for (int k = 0; k < static_cast<int>(state.damageable().size()); ++k) {
      const double before = state.factor(k, 0);
      const int beam = state.damageable()[k].beam;
      const double after = std::min(before, fracture::stiffness_left(beam_[beam], state.opening(k, 0)));
      if (after == before) continue;
      increments.push_back({.k = k, .lane = 0, .before = before, .after = after});
      increments.back().strain = state.strain_before(beam, 0, dt_);
    }
  }
  void save(NamedNumbers&) const override {}
  void restore(const State&, const NamedNumbers&) override {}

 private:
  std::vector<fracture::Softening> beam_;
  double dt_;
};

// What is left in the walk and what the walk notes is what looking at every beam gives, from a strained base
// state and from one at rest.
TEST(BreakingBeams, InTheWalkAreThoseOfALookAtEveryBeam) {
  const FreePlate plate;
  const CohesiveMaterial material = plate.material(1.1, 3.0);
  lattice::Lattice free = plate.p.lattice;
  std::fill(free.grip.begin(), free.grip.end(), packing::Grip::none);
  const double stress = 0.5 * material.strength;
  for (const bool strained : {true, false}) {
    const lattice::Lattice& lattice = strained ? plate.p.lattice : free;
    const std::vector<lattice::Vector6> rest(lattice.centre.size(), lattice::Vector6::Zero());
    const auto marched = [&](const fracture::LaneScenario& scenario, std::shared_ptr<ReleaseRule> rule) {
      Ensemble s(lattice, plate.beams, plate.p.step.dt, {scenario}, {.threads = 2}, std::move(rule));
      if (!strained) s.set_loads(lattice::opposite_tractions(free, 1));
      s.start_from(strained ? plate.p.displacement : rest);
      s.start_crack({});
      for (int n = 0; n < 150; ++n) s.step();
      return s;
    };
    const lattice::StepLoad load{strained ? 0.0 : stress, 0.0};
    Ensemble walked = marched({.material = material, .load = load},
                              std::make_shared<BreakingBeams>(lattice, plate.p.step.dt));
    Ensemble listed =
        marched({.load = load},
                std::make_shared<EveryBeam>(fracture::softening_of(lattice, material), plate.p.step.dt));
    EXPECT_GT(plate.gone(walked, 0), 5) << strained;
    for (int k = 0; k < static_cast<int>(plate.beams.size()); ++k)
      ASSERT_NEAR(walked.factor(k, 0), listed.factor(k, 0), 1e-9) << k << ", strained " << strained;
    const fracture::EnergyBalance a = walked.balance(0), b = listed.balance(0);
    EXPECT_NEAR(a.elastic, b.elastic, 1e-10 * b.largest);
    EXPECT_NEAR(a.fracture, b.fracture, 1e-10 * b.largest);
    EXPECT_NEAR(a.kinetic_translation, b.kinetic_translation, 1e-10 * b.largest);
  }
}

TEST(BreakingBeams, GoOnFromWhereTheyWere) {
  const FreePlate plate;
  const fracture::LaneScenario lane{.material = plate.material(1.1, 3.0)};
  Ensemble whole = plate.ensemble({lane});
  whole.start_from(plate.p.displacement);
  whole.start_crack({});
  for (int n = 0; n < 80; ++n) whole.step();
  EXPECT_GT(plate.gone(whole, 0), 5);
  Ensemble second = plate.ensemble({lane});
  second.start_from(plate.p.displacement);
  second.start_crack({});
  second.restore(whole.state());
  for (int n = 0; n < 80; ++n) whole.step(), second.step();
  for (int k = 0; k < static_cast<int>(plate.beams.size()); ++k) {
    ASSERT_EQ(whole.factor(k, 0), second.factor(k, 0));
    ASSERT_EQ(whole.fracture_energy(k, 0), second.fracture_energy(k, 0));
  }
  EXPECT_EQ(whole.balance(0).error, second.balance(0).error);
}

}  // namespace
}  // namespace rift::ensemble
