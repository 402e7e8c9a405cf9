#include "engine/fracture/face_contact.hpp"
#include "tests/engine/lattice/dense.hpp"
#include "tests/engine/lattice/hand_made.hpp"
#include "tests/engine/simulation/small_plate.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace rift::ensemble {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Two elements above each other and the beam between them, which the path y = 1 crosses.
lattice::Lattice pair() {
  lattice::Lattice lattice;
  lattice.centre = {{1.0, 0.5, 0.0}, {1.0, 1.5, 0.0}};
  lattice.radius = {0.5, 0.5};
  lattice.grip = {packing::Grip::none, packing::Grip::none};
  lattice.mass = {1.0, 2.0};
  lattice.inertia = {0.1, 0.2};
  lattice.ends = {{0, 1}};
  lattice.beam = {lattice::hand_made::Rod{}.between(lattice.centre[0], lattice.centre[1])};
  lattice.mean_radius = 0.5;
  lattice.box = {.length = 2.0, .height = 2.0, .thickness = 1.0};
  return lattice;
}

/// The pair thrown, its beam gone after the first step.
CrackedEnsemble thrown(const lattice::Lattice& lattice, std::optional<double> friction,
                       const std::vector<lattice::Vector6>& velocity, double dt,
                       lattice::Kinematics kinematics) {
  const fracture::LaneScenario lane{.history = history::history_of(1.0, {{1e-3, infinity}}),
                                    .law = {fracture::Technique::simple, 1.0, 0.0},
                                    .friction = friction};
  CrackedEnsemble s(lattice, fracture::straight_path(2.0, 1.0), -1.0, dt, {lane},
                    {.kinematics = kinematics, .contact = friction.has_value()});
  s.start_from(std::vector<lattice::Vector6>(2, lattice::Vector6::Zero()));
  s.set_velocities(0, velocity);
  s.start_crack({});
  return s;
}

// A spring between two masses, pressed at the speed v, gives it back after pi (m / k)^1/2 with 1/m = 1/m_i +
// 1/m_j, and pulls at nothing then.
TEST(FaceContact, IsAnElasticImpactOfTheExactDuration) {
  const lattice::Lattice lattice = pair();
  const double k = fracture::face_stiffness(lattice.beam[0]), reduced = 2.0 / 3.0;
  const double duration = std::numbers::pi * std::sqrt(reduced / k), speed = 1e-3;
  std::vector<lattice::Vector6> velocity(2, lattice::Vector6::Zero());
  velocity[0][1] = speed;
  for (const lattice::Kinematics kinematics :
       {lattice::Kinematics::linear, lattice::Kinematics::corotational}) {
    constexpr int steps = 2000;
    CrackedEnsemble s = thrown(lattice, 0.0, velocity, duration / steps, kinematics);
    const auto apart = [&] { return s.velocity(1, 0)[1] - s.velocity(0, 0)[1]; };
    for (int n = 0; n < steps / 2; ++n) s.step();
    EXPECT_NEAR(apart(), 0.0, 1e-3 * speed);
    EXPECT_NEAR(s.motion(0, 0)[1] - s.motion(1, 0)[1], speed * std::sqrt(reduced / k), 1e-5 * speed);
    for (int n = 0; n < steps; ++n) s.step();
    EXPECT_NEAR(apart(), speed, 1e-5 * speed);
    EXPECT_NEAR(s.velocity(0, 0)[1], speed * (1.0 - 2.0 / 1.5), 1e-5 * speed);  // 1 : 2, by momentum
    const fracture::EnergyBalance now = s.balance(0);
    EXPECT_LT(std::abs(now.error), kinematics == lattice::Kinematics::linear ? 1e-13 : 1e-6);
    EXPECT_LT(std::abs(now.contact), 1e-5 * s.balance(0).largest);  // as they part between two steps
    EXPECT_LT(now.elastic, 1e-20);
  }
}

// So the critical step of the sound lattice holds: a beam less its contact, stuck, resists every motion.
TEST(FaceContact, IsNowhereStifferThanTheBeam) {
  lattice::hand_made::Draw draw(5);
  for (int n = 0; n < 20; ++n) {
    const lattice::Beam beam = lattice::make_beam(draw.vector(), draw.between(0.05, 0.5) * 0.1, 3.0, 0.25);
    Eigen::Matrix<double, 3, 12> gap;
    for (int c = 0; c < 12; ++c) {
      lattice::Vector6 q[2] = {lattice::Vector6::Zero(), lattice::Vector6::Zero()};
      q[c / 6][c % 6] = 1.0;
      gap.col(c) = fracture::face_gap(beam, q[0], q[1]);
    }
    const lattice::Matrix12 beyond =
        lattice::stiffness_of(beam) - fracture::face_stiffness(beam) * gap.transpose() * gap;
    const Eigen::VectorXd mode =
        lattice::hand_made::modes_of(beyond, Eigen::MatrixXd::Identity(12, 12)).value;
    EXPECT_GT(mode[0], -1e-12 * mode[11]);
  }
}

TEST(FaceContact, LetsFacesPassThroughEachOtherWithoutIt) {
  const lattice::Lattice lattice = pair();
  std::vector<lattice::Vector6> velocity(2, lattice::Vector6::Zero());
  velocity[0][1] = 1e-3;
  CrackedEnsemble s = thrown(lattice, std::nullopt, velocity, 0.01, lattice::Kinematics::linear);
  for (int n = 0; n < 1000; ++n) s.step();
  EXPECT_NEAR(s.velocity(0, 0)[1], 1e-3, 1e-5);
  EXPECT_GT(s.motion(0, 0)[1], 5e-3);
}

// mu N holds against sliding: impulses along and across are as mu to 1 while the faces slide, and turn both
// elements.
TEST(FaceContact, SlidesByCoulombsLaw) {
  const lattice::Lattice lattice = pair();
  std::vector<lattice::Vector6> velocity(2, lattice::Vector6::Zero());
  velocity[0][1] = 1e-4;
  velocity[0][0] = 1e-1;  // far faster than it can be held
  constexpr double mu = 0.4;
  CrackedEnsemble s = thrown(lattice, mu, velocity, 0.002, lattice::Kinematics::linear);
  for (int n = 0; n < 10000; ++n) s.step();
  const lattice::Vector6 a = s.velocity(0, 0), b = s.velocity(1, 0);
  const double across = b[0] * 2.0, along = b[1] * 2.0;  // impulses on the second, of mass 2
  EXPECT_GT(along, 1e-4);
  EXPECT_NEAR(across / along, mu, 0.01 * mu);
  EXPECT_NEAR(a[0] + 2.0 * b[0], 1e-1, 1e-12);
  EXPECT_NEAR(0.1 * a[5], 0.5 * across, 1e-3 * across);  // lever: half the beam
  EXPECT_NEAR(0.2 * b[5], 0.5 * across, 1e-3 * across);
  const fracture::EnergyBalance now = s.balance(0);
  EXPECT_LT(std::abs(now.error), 1e-13);
  // What friction took is the kinetic energy that is missing; the beam's own share went as it broke.
  EXPECT_NEAR(now.contact + now.fracture, 0.5e-2 + 0.5e-8 - now.kinetic_translation - now.kinetic_rotation,
              1e-9 * 0.5e-2);
  EXPECT_GT(now.contact, 0.9 * mu * along * 0.1 * 0.95);
}

/// Pressed together and sheared: friction holds some of the faces and lets others slide.
const std::vector<std::string> pressed{"loading.displacement=-0.6 mm", "loading.shear=-2",
                                       "crack.friction=0.3", "crack.end=24 mm"};

std::vector<fracture::LaneScenario> four_frictions(const simulation::Prepared& p) {
  std::vector<fracture::LaneScenario> lanes = simulation::four_laws(p);
  lanes[0].friction = 0.3, lanes[1].friction = 0.0, lanes[2].friction = 5.0, lanes[3].friction = {};
  return lanes;
}

std::vector<std::string> with(std::vector<std::string> some, const std::vector<std::string>& more) {
  some.insert(some.end(), more.begin(), more.end());
  return some;
}

TEST(FaceContact, ClosesTheBooks) {
  for (const auto& damping :
       std::vector<std::vector<std::string>>{{},
                                             {"damping.alpha=0.001", "damping.region=surface"},
                                             {"damping.alpha=0.01", "damping.region=all"}})
    for (const double beta : {1.0, 0.9}) {
      const simulation::Prepared p = simulation::small_plate(with(pressed, damping));
      CrackedEnsemble s = simulation::ready(p, four_frictions(p), p.step.dt, {.contact = true});
      s.set_beta(beta);
      if (beta < 1.0) s.set_grip_speed(-2.0);
      std::vector<double> worst(4, 0.0);
      for (int n = 0; s.tip(0) < p.lane[0].crack_end; ++n) {
        s.step();
        for (int lane = 0; lane < 4 && n % 20 == 0; ++lane)
          worst[lane] = std::max(worst[lane], std::abs(s.balance(lane).error));
      }
      for (int lane = 0; lane < 4; ++lane)
        EXPECT_LT(worst[lane], 1e-13) << lane << ' ' << beta << ' ' << damping.size();
      const double most = s.balance(0).largest;
      EXPECT_GT(s.balance(0).contact, 1e-3 * most);
      EXPECT_EQ(s.balance(3).contact, 0.0);
    }
}

// Corotational beams: the forces are the energy's gradient, so that faces without friction take nothing in
// the mean; the limit is that of all corotational books.
TEST(FaceContact, ClosesTheBooksOfCorotationalBeams) {
  const simulation::Prepared p = simulation::small_plate(
      with(pressed, {"solver.kinematics=corotational", "loading.displacement=-0.06 mm"}));
  CrackedEnsemble s = simulation::ready(p, four_frictions(p), p.step.dt,
                                        {.kinematics = lattice::Kinematics::corotational, .contact = true});
  std::vector<double> worst(4, 0.0);
  for (int n = 0; s.tip(0) < p.lane[0].crack_end; ++n) {
    s.step();
    for (int lane = 0; lane < 4 && n % 20 == 0; ++lane)
      worst[lane] = std::max(worst[lane], std::abs(s.balance(lane).error));
  }
  for (int lane = 0; lane < 4; ++lane) EXPECT_LT(worst[lane], 1e-4) << lane;
  const double taken = s.balance(0).contact;
  EXPECT_GT(taken, 1e-3 * s.balance(0).largest);
  EXPECT_LT(std::abs(s.balance(1).contact), 0.05 * taken);
}

// Coulomb's law on every pair of faces, and what the books say friction took against the slip times the
// force, (1 - s) k/2 (e_n + e_{n+1}).(slip_{n+1} - slip_n), summed here beam by beam.
TEST(FaceContact, BooksTheWorkOfFriction) {
  const simulation::Prepared p = simulation::small_plate(with(pressed, {"crack.technique=simple"}));
  constexpr double mu = 0.3;
  CrackedEnsemble s = simulation::ready(p, {p.lane[0].scenario}, p.step.dt, {.contact = true});
  const int count = static_cast<int>(s.damageable().size());
  std::vector<Eigen::Vector3d> slip(count, Eigen::Vector3d::Zero()), held = slip;
  double taken = 0.0, before = s.balance(0).contact, booked = 0.0;
  int sliding = 0, sticking = 0;
  for (int n = 0; n < 600; ++n) {
    std::vector<Eigen::Vector3d> at;
    std::vector<char> parted;
    for (int k = 0; k < count; ++k) at.push_back(s.gap(k, 0)), parted.push_back(s.factor(k, 0) == 0.0);
    s.step();  // the slips are those at the strains above now
    for (int k = 0; k < count; ++k) {
      const Eigen::Vector3d m = s.normal(k);
      const double open = m.dot(at[k]),
                   stiffness = fracture::face_stiffness(p.lattice.beam[s.damageable()[k].beam]);
      const Eigen::Vector3d along_face = at[k] - open * m;
      if (!parted[k]) {  // what the beam held beyond mu N slips as it breaks
        slip[k] = along_face - fracture::face_contact(at[k], m, Eigen::Vector3d::Zero(), mu).sliding;
        continue;
      }
      const Eigen::Vector3d e = along_face - s.slip(k, 0);
      const double across = stiffness * e.norm(), along = -stiffness * std::min(open, 0.0);
      ASSERT_LE(across, mu * along * (1.0 + 1e-12) + 1e-12);
      (across > 0.999 * mu * along ? sliding : sticking) += along > 0.0;
      taken += 0.5 * stiffness * (e + held[k]).dot(s.slip(k, 0) - slip[k]);
      slip[k] = s.slip(k, 0), held[k] = e;
    }
  }
  booked = s.balance(0).contact - before;
  EXPECT_GT(sliding, 1000);
  EXPECT_GT(sticking, 1000);
  EXPECT_GT(booked, 0.0);
  EXPECT_NEAR(booked, taken, 0.02 * taken);  // what is left: faces that meet and part between two steps
}

// A plate that is pressed stays a plate where its faces touch.
TEST(FaceContact, CarriesAPressedPlate) {
  const simulation::Prepared p =
      simulation::small_plate({"loading.displacement=-0.6 mm", "crack.friction=0"});
  std::vector<fracture::LaneScenario> lanes(3, p.lane[0].scenario);
  lanes[1].friction = 5.0, lanes[2].friction = {};
  CrackedEnsemble s = simulation::ready(p, lanes, p.step.dt, {.contact = true});
  const double start = s.grip_force(0);
  while (s.tip(0) < p.lane[0].crack_end) s.step();
  const auto mean_gap = [&](int lane) {
    double sum = 0.0;
    int count = 0;
    for (int k = 0; k < static_cast<int>(s.damageable().size()); ++k)
      if (s.factor(k, lane) == 0.0) sum += s.normal(k).dot(s.gap(k, lane)), ++count;
    return sum / count;
  };
  // Cut to its half the plate keeps 0.80 of its force where the faces touch, 0.47 where they do not.
  EXPECT_GT(s.grip_force(0) / start, 0.75);
  EXPECT_GT(s.grip_force(1) / start, 0.75);
  EXPECT_LT(s.grip_force(2) / start, 0.5);
  EXPECT_LT(mean_gap(2), 2.0 * mean_gap(0));
  EXPECT_LT(mean_gap(0), 0.0);
}

TEST(FaceContact, IsTheSameBesideOthersAndForAnyThreads) {
  const simulation::Prepared p = simulation::small_plate(pressed);
  const std::vector<fracture::LaneScenario> lanes = four_frictions(p);
  CrackedEnsemble together = simulation::ready(p, lanes, p.step.dt, {.threads = 1, .contact = true});
  CrackedEnsemble threaded = simulation::ready(p, lanes, p.step.dt, {.threads = 3, .contact = true});
  for (int n = 0; n < 400; ++n) together.step(), threaded.step();
  for (int lane = 0; lane < 4; ++lane) {
    CrackedEnsemble alone = simulation::ready(p, {lanes[lane]}, p.step.dt, {.threads = 2, .contact = true});
    for (int n = 0; n < 400; ++n) {
      alone.step();
      if (n % 50 == 0) alone.balance(0);  // looking changes nothing
    }
    ASSERT_FALSE(p.lattice.centre.empty());
    for (int i = 0; i < static_cast<int>(p.lattice.centre.size()); ++i) {
      ASSERT_EQ(together.motion(i, lane), threaded.motion(i, lane));
      ASSERT_EQ(together.motion(i, lane), alone.motion(i, 0)) << lane;
    }
  }
}

TEST(FaceContact, StartsAnewInARefilledLane) {
  const simulation::Prepared p = simulation::small_plate(pressed);
  CrackedEnsemble s =
      simulation::ready(p, {p.lane[0].scenario, p.lane[0].scenario}, p.step.dt, {.contact = true});
  for (int n = 0; n < 300; ++n) s.step();
  std::vector<lattice::Vector6> first;
  for (int i = 0; i < static_cast<int>(p.lattice.centre.size()); ++i) first.push_back(s.motion(i, 1));
  const double contact = s.balance(1).contact;
  s.refill(1, p.lane[0].scenario);
  for (int n = 0; n < 300; ++n) s.step();
  ASSERT_FALSE(first.empty());
  for (int i = 0; i < static_cast<int>(first.size()); ++i) ASSERT_EQ(s.motion(i, 1), first[i]);
  EXPECT_EQ(s.balance(1).contact, contact);
}

}  // namespace
}  // namespace rift::ensemble
