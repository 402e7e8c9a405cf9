#include "engine/lattice/beam.hpp"
#include "tests/engine/lattice/hand_made.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rift::lattice {
namespace {

using hand_made::Draw;
using hand_made::Rod;

/// A beam and two poses that bend, twist and stretch it, all of order one.
struct Case {
  Beam beam;
  Pose i, j;
};

Pose any_pose(Draw& draw, double size) { return pose_of(size * draw.motion()); }

Case any_case(Draw& draw, double size) {
  const Rod rod{.radius = draw.between(0.1, 0.4)};
  return {rod.between(Eigen::Vector3d::Zero(), draw.vector() + Eigen::Vector3d(1.5, 0, 0)),
          any_pose(draw, size), any_pose(draw, size)};
}

double energy(const Case& c) { return energy_of(c.beam, strain_of(c.beam, c.i, c.j)); }

/// The element at `from`, centre unloaded, moved with a rigid body.
Pose carried(const Pose& pose, const Eigen::Vector3d& from, const Eigen::Quaterniond& turn,
             const Eigen::Vector3d& shift) {
  return {turn * (from + pose.u) + shift - from, turn * pose.turn};
}

/// The case carried along by a finite rigid motion; i sits at the origin.
Case carried(const Case& c, const Eigen::Quaterniond& turn, const Eigen::Vector3d& shift) {
  return {c.beam, carried(c.i, Eigen::Vector3d::Zero(), turn, shift),
          carried(c.j, c.beam.length * c.beam.axis, turn, shift)};
}

Eigen::Quaterniond any_turn(Draw& draw) { return pose_of(3.0 * draw.motion()).turn; }

TEST(CorotationalBeam, FeelsNoFiniteRigidMotion) {
  Draw draw(51);
  for (int trial = 0; trial < 50; ++trial) {
    const Case straight{any_case(draw, 0.0).beam, Pose{}, Pose{}};
    const Case c = carried(straight, any_turn(draw), draw.vector());
    const BeamLoads l = loads_of(c.beam, c.i, c.j);
    EXPECT_NEAR(energy(c), 0.0, 1e-28);  // squares of roundings
    EXPECT_NEAR(l.force_i.norm() + l.moment_i.norm() + l.moment_j.norm(), 0.0, 1e-13);
  }
}

TEST(CorotationalBeam, TurnsItsLoadsWithARigidMotion) {
  Draw draw(52);
  for (int trial = 0; trial < 50; ++trial) {
    const Case c = any_case(draw, 0.5);
    const Eigen::Quaterniond turn = any_turn(draw);
    const Case moved = carried(c, turn, draw.vector());
    const BeamLoads before = loads_of(c.beam, c.i, c.j), after = loads_of(moved.beam, moved.i, moved.j);
    EXPECT_NEAR(energy(moved), energy(c), 1e-13);
    EXPECT_NEAR((after.force_i - turn * before.force_i).norm(), 0.0, 1e-12);
    EXPECT_NEAR((after.moment_i - turn * before.moment_i).norm(), 0.0, 1e-12);
    EXPECT_NEAR((after.moment_j - turn * before.moment_j).norm(), 0.0, 1e-12);
  }
}

// Work of the loads in small motions of either end, turning about the axes of space, against the energy by
// central differences: 1e-5 for the step, so 1e-10 of truncation and 1e-11 of rounding.
TEST(CorotationalBeam, HasTheExactGradientOfItsEnergy) {
  Draw draw(53);
  for (int trial = 0; trial < 30; ++trial) {
    const Case c = any_case(draw, 0.8);
    const BeamLoads l = loads_of(c.beam, c.i, c.j);
    Eigen::Matrix<double, 12, 1> load;
    load << l.force_i, l.moment_i, -l.force_i, l.moment_j;
    for (int k = 0; k < 12; ++k) {
      const double h = 1e-5;
      double side[2];
      for (const int s : {0, 1}) {
        Case moved = c;
        Pose& end = k < 6 ? moved.i : moved.j;
        Vector6 small = Vector6::Zero();
        small[k % 6] = s == 0 ? -h : h;
        end.u += small.head<3>();
        end.turn = pose_of(small).turn * end.turn;
        side[s] = energy(moved);
      }
      EXPECT_NEAR(load[k], -(side[1] - side[0]) / (2.0 * h), 1e-8) << "motion " << k;
    }
  }
}

TEST(CorotationalBeam, KeepsMomentumAndAngularMomentum) {
  Draw draw(54);
  for (int trial = 0; trial < 50; ++trial) {
    const Case c = any_case(draw, 0.8);
    const BeamLoads l = loads_of(c.beam, c.i, c.j);
    const Eigen::Vector3d chord = c.beam.length * c.beam.axis + c.j.u - c.i.u;
    EXPECT_NEAR((l.moment_i + l.moment_j - chord.cross(l.force_i)).norm(), 0.0, 1e-13);
  }
}

TEST(CorotationalBeam, IsTheLinearOneForSmallMotions) {
  Draw draw(55);
  for (int trial = 0; trial < 20; ++trial) {
    const Case c = any_case(draw, 0.0);
    const Vector6 qi = draw.motion(), qj = draw.motion();
    double last = 0.0;
    for (const double size : {1e-3, 1e-4}) {
      const BeamLoads l = loads_of(c.beam, pose_of(size * qi), pose_of(size * qj)),
                      linear = loads_of(c.beam, size * qi, size * qj);
      const double off = (l.force_i - linear.force_i).norm() + (l.moment_i - linear.moment_i).norm() +
                         (l.moment_j - linear.moment_j).norm();
      if (last > 0.0) {
        EXPECT_NEAR(last / off, 100.0, 5.0);  // what differs is of second order
      }
      last = off;
    }
  }
}

TEST(CorotationalBeam, HasTheTangentOfItsLoads) {
  Draw draw(56);
  const Case straight{any_case(draw, 0.0).beam, Pose{}, Pose{}};
  const Matrix12 k = stiffness_of(straight.beam);
  EXPECT_NEAR((tangent_of(straight.beam, Pose{}, Pose{}) - k).norm() / k.norm(), 0.0, 1e-9);
}

TEST(Pose, ComesBackFromItsMotion) {
  Draw draw(57);
  for (const double size : {1e-12, 1e-3, 1.0, 1.7}) {
    const Vector6 motion = size * draw.motion();
    EXPECT_NEAR((motion_of(pose_of(motion)) - motion).norm(), 0.0, 1e-15 + 1e-14 * size);
  }
}

}  // namespace
}  // namespace rift::lattice
