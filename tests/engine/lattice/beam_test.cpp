#include "engine/lattice/beam.hpp"

#include "tests/engine/lattice/dense.hpp"
#include "tests/engine/lattice/hand_made.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace rift::lattice {
namespace {

using hand_made::chain;
using hand_made::dense_stiffness;
using hand_made::Draw;
using hand_made::Rod;

using Vector12 = Eigen::Matrix<double, 12, 1>;

struct RandomBeam {
  Rod rod;
  Eigen::Vector3d span;
  Beam beam;
};

RandomBeam random_beam(Draw& draw) {
  const Rod rod{
      .radius = draw.between(0.1, 0.5), .young = draw.between(0.5, 2.0), .poisson = draw.between(0, 0.45)};
  const Eigen::Vector3d span = draw.between(0.5, 2.0) * draw.vector().normalized();
  return {rod, span, make_beam(span, rod.radius, rod.young, rod.poisson)};
}

double energy_at(const Beam& beam, const Vector12& q) {
  return energy_of(beam, strain_of(beam, q.head<6>(), q.tail<6>()));
}

/// The Euler-Bernoulli matrix of any textbook (Przemieniecki 1968, eq. 5.116, no shear), in the local frame x
/// along the beam, then rotated: no algebra in common with the closed form.
Matrix12 textbook_stiffness(const Rod& rod, const Eigen::Vector3d& span) {
  const double l = span.norm(), E = rod.young, I = rod.second_moment();
  const double stretch = E * rod.area() / l, twist = rod.shear() * 2.0 * I / l;
  const double shear = 12 * E * I / (l * l * l), mixed = 6 * E * I / (l * l), near = 4 * E * I / l,
               far = 2 * E * I / l;
  Matrix12 k = Matrix12::Zero();
  const auto set = [&](int row, int column, double value) { k(row, column) = k(column, row) = value; };
  set(0, 0, stretch), set(6, 6, stretch), set(0, 6, -stretch);
  set(3, 3, twist), set(9, 9, twist), set(3, 9, -twist);
  set(1, 1, shear), set(1, 5, mixed), set(1, 7, -shear), set(1, 11, mixed);  // in the plane x-y
  set(5, 5, near), set(5, 7, -mixed), set(5, 11, far);
  set(7, 7, shear), set(7, 11, -mixed), set(11, 11, near);
  set(2, 2, shear), set(2, 4, -mixed), set(2, 8, -shear), set(2, 10, -mixed);  // in the plane x-z
  set(4, 4, near), set(4, 8, mixed), set(4, 10, far);
  set(8, 8, shear), set(8, 10, mixed), set(10, 10, near);

  const Eigen::Vector3d x = span / l, y = x.unitOrthogonal();
  Eigen::Matrix3d to_global;
  to_global << x, y, x.cross(y);
  Matrix12 rotation = Matrix12::Zero();
  for (int block = 0; block < 4; ++block) rotation.block<3, 3>(3 * block, 3 * block) = to_global;
  return rotation * k * rotation.transpose();
}

TEST(BeamLoads, AreMinusTheGradientOfTheEnergy) {
  Draw draw(1);
  for (int trial = 0; trial < 200; ++trial) {
    const RandomBeam b = random_beam(draw);
    Vector12 q;
    q << draw.motion(), draw.motion();
    const BeamLoads loads = loads_of(b.beam, q.head<6>(), q.tail<6>());
    Vector12 given;
    given << loads.force_i, loads.moment_i, -loads.force_i, loads.moment_j;
    // U is quadratic: a central difference over any width is exact but for rounding, some 1e-16 of energies
    // that reach the beam's stiffness times the square of a motion of order one.
    const double largest = stiffness_of(b.beam).cwiseAbs().maxCoeff();
    for (int c = 0; c < 12; ++c) {
      const Vector12 width = Vector12::Unit(c);
      const double slope = 0.5 * (energy_at(b.beam, q + width) - energy_at(b.beam, q - width));
      EXPECT_NEAR(given[c], -slope, 3e-14 * largest) << "component " << c;
    }
  }
}

TEST(BeamStiffness, IsTheTextbookEulerBernoulliMatrix) {
  Draw draw(2);
  for (int trial = 0; trial < 200; ++trial) {
    const RandomBeam b = random_beam(draw);
    const Matrix12 given = stiffness_of(b.beam), expected = textbook_stiffness(b.rod, b.span);
    // A dozen roundings in the closed form and as many in turning the textbook's frame.
    EXPECT_NEAR((given - expected).cwiseAbs().maxCoeff(), 0.0, 1e-14 * expected.cwiseAbs().maxCoeff());
  }
}

TEST(BeamEnergy, IsHalfOfTheTextbooksQuadraticForm) {
  Draw draw(3);
  for (int trial = 0; trial < 200; ++trial) {
    const RandomBeam b = random_beam(draw);
    Vector12 q;
    q << draw.motion(), draw.motion();
    const Matrix12 k = textbook_stiffness(b.rod, b.span);
    const double expected = 0.5 * q.dot(k * q);
    EXPECT_NEAR(energy_at(b.beam, q), expected, 1e-14 * k.cwiseAbs().maxCoeff() * q.squaredNorm());
  }
}

TEST(BeamEnergy, OfTwoStatesIsTheSymmetricBilinearForm) {
  Draw draw(4);
  for (int trial = 0; trial < 200; ++trial) {
    const RandomBeam b = random_beam(draw);
    Vector12 p, q;
    p << draw.motion(), draw.motion();
    q << draw.motion(), draw.motion();
    const BeamStrain at_p = strain_of(b.beam, p.head<6>(), p.tail<6>()),
                     at_q = strain_of(b.beam, q.head<6>(), q.tail<6>());
    const Matrix12 k = textbook_stiffness(b.rod, b.span);
    const double rounding = 1e-14 * k.cwiseAbs().maxCoeff() * p.norm() * q.norm();
    EXPECT_NEAR(bilinear_energy(b.beam, at_p, at_q), 0.5 * p.dot(k * q), rounding);
    EXPECT_NEAR(bilinear_energy(b.beam, at_p, at_q), bilinear_energy(b.beam, at_q, at_p), 0.01 * rounding);
  }
}

TEST(BeamLoads, CarryNoAngularMomentum) {
  Draw draw(5);
  for (int trial = 0; trial < 200; ++trial) {
    const RandomBeam b = random_beam(draw);
    const BeamLoads loads = loads_of(b.beam, draw.motion(), draw.motion());
    const Eigen::Vector3d about_i = loads.moment_i + loads.moment_j + b.span.cross(-loads.force_i);
    const double scale = loads.moment_i.norm() + loads.moment_j.norm() + b.span.norm() * loads.force_i.norm();
    ASSERT_GT(scale, 1e-4);
    EXPECT_NEAR(about_i.norm(), 0.0, 1e-14 * scale);
  }
}

TEST(BeamLoads, VanishInARigidMotion) {
  Draw draw(6);
  for (int trial = 0; trial < 200; ++trial) {
    const RandomBeam b = random_beam(draw);
    const Eigen::Vector3d at_i = 3.0 * draw.vector(), pivot = 3.0 * draw.vector(), shift = draw.vector(),
                          turn = draw.vector();
    const Vector6 q_i = hand_made::rigid(at_i, shift, turn, pivot),
                  q_j = hand_made::rigid(at_i + b.span, shift, turn, pivot);
    const BeamLoads loads = loads_of(b.beam, q_i, q_j);
    // What is left is the rounding of displacements of up to ten.
    const double rounding = 1e-14 * stiffness_of(b.beam).cwiseAbs().maxCoeff();
    EXPECT_NEAR(loads.force_i.norm(), 0.0, rounding);
    EXPECT_NEAR(loads.moment_i.norm(), 0.0, rounding);
    EXPECT_NEAR(loads.moment_j.norm(), 0.0, rounding);
    EXPECT_NEAR(energy_of(b.beam, strain_of(b.beam, q_i, q_j)), 0.0, rounding * 1e-13);
  }
}

/// Displacements of a chain of collinear beams, clamped at its first element, under loads on its last one.
Eigen::VectorXd clamped_chain(const Lattice& lattice, const Vector6& tip_load) {
  const Eigen::MatrixXd k = dense_stiffness(lattice);
  const long free = k.rows() - 6;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(free);
  load.tail<6>() = tip_load;
  return hand_made::solution_of(k.bottomRightCorner(free, free), load);
}

struct Cantilever {
  Rod rod{.radius = 0.15, .young = 7.0, .poisson = 0.3};
  int beams = 25;
  Eigen::Vector3d along = Eigen::Vector3d(2, -1, 0.5).normalized();
  Eigen::Vector3d across = along.cross(Eigen::Vector3d(0.3, 0.2, 1.0)).normalized();
  Lattice lattice = chain(beams + 1, 0.4 * along, rod);
  double length = 0.4 * beams;
  // Nodal values of cubic beams are exact: what is left is rounding times the condition of a chain, beams^4
  // / 10.
  double tolerance = 1e-10;
};

TEST(BeamChain, BendsAsACantilever) {
  const Cantilever c;
  const double force = 1e-3, EI = c.rod.young * c.rod.second_moment();
  Vector6 load;
  load << force * c.across, Eigen::Vector3d::Zero();
  const Eigen::VectorXd q = clamped_chain(c.lattice, load);
  const double deflection = force * std::pow(c.length, 3) / (3 * EI),
               slope = force * c.length * c.length / (2 * EI);
  const Eigen::Vector3d tip = q.segment<3>(q.size() - 6), turn = q.tail<3>();
  EXPECT_NEAR((tip - deflection * c.across).norm(), 0.0, c.tolerance * deflection);
  EXPECT_NEAR((turn - slope * c.along.cross(c.across)).norm(), 0.0, c.tolerance * slope);
}

TEST(BeamChain, StretchesAsABar) {
  const Cantilever c;
  Vector6 load;
  load << 0.01 * c.along, Eigen::Vector3d::Zero();
  const Eigen::VectorXd q = clamped_chain(c.lattice, load);
  const double elongation = 0.01 * c.length / (c.rod.young * c.rod.area());
  EXPECT_NEAR((q.segment<3>(q.size() - 6) - elongation * c.along).norm(), 0.0, c.tolerance * elongation);
}

TEST(BeamChain, TwistsAsAShaft) {
  const Cantilever c;
  Vector6 load;
  load << Eigen::Vector3d::Zero(), 0.01 * c.along;
  const Eigen::VectorXd q = clamped_chain(c.lattice, load);
  const double angle = 0.01 * c.length / (c.rod.shear() * 2.0 * c.rod.second_moment());
  EXPECT_NEAR((q.tail<3>() - angle * c.along).norm(), 0.0, c.tolerance * angle);
}

TEST(BeamChain, VibratesAsABarClampedAtBothEnds) {
  const Rod rod{.radius = 0.2, .young = 3.0, .poisson = 0.25};
  const int beams = 30;
  Lattice bar = chain(beams + 1, Eigen::Vector3d(0, 1, 0), rod);
  const long free = 6 * (beams - 1);
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(free, free);
  for (long k = 0; k < free; ++k) mass(k, k) = (k % 6 < 3) ? bar.mass[1] : bar.inertia[1];
  const Eigen::MatrixXd k = dense_stiffness(bar).block(6, 6, free, free);
  const double omega = std::sqrt(hand_made::modes_of(k, mass).value[0]);
  // beta L = 4.730041 of cos cosh = 1; rotary inertia and lumped masses lower it by less than 1e-3.
  const double beta = 4.730041 / beams;
  const double expected = beta * beta * std::sqrt(rod.young * rod.second_moment() / rod.area());
  EXPECT_NEAR(omega / expected, 1.0, 1e-3);
}

}  // namespace
}  // namespace rift::lattice
