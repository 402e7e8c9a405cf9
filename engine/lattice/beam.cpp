#include "engine/lattice/beam.hpp"

#include <Eigen/Geometry>

#include <numbers>

namespace rift::lattice {

Beam make_beam(const Eigen::Vector3d& span, double section_radius, double young_modulus,
               double poisson_ratio) {
  const double l = span.norm(), r2 = section_radius * section_radius;
  const double S = std::numbers::pi * r2, I = 0.25 * std::numbers::pi * r2 * r2;
  const double G = young_modulus / (2.0 * (1.0 + poisson_ratio));
  return {.axis = span / l,
          .length = l,
          .axial = young_modulus * S / l,
          .bending = 2.0 * young_modulus * I / l,
          .twist = G * 2.0 * I / l};
}

BeamStrain strain_of(const Beam& beam, const Vector6& q_i, const Vector6& q_j) {
  const Eigen::Vector3d& n = beam.axis;
  const Eigen::Vector3d du = q_j.head<3>() - q_i.head<3>();
  const Eigen::Vector3d chord = n.cross(du) / beam.length;
  const auto across = [&](const Eigen::Vector3d& a) -> Eigen::Vector3d { return a - n * n.dot(a); };
  return {.stretch = n.dot(du),
          .twist = n.dot(q_j.tail<3>() - q_i.tail<3>()),
          .bend_i = across(q_i.tail<3>() - chord),
          .bend_j = across(q_j.tail<3>() - chord)};
}

double bilinear_energy(const Beam& beam, const BeamStrain& a, const BeamStrain& b) {
  const double bending = a.bend_i.dot(b.bend_i) + a.bend_j.dot(b.bend_j) +
                         0.5 * (a.bend_i.dot(b.bend_j) + a.bend_j.dot(b.bend_i));
  return 0.5 * beam.axial * a.stretch * b.stretch + 0.5 * beam.twist * a.twist * b.twist +
         beam.bending * bending;
}

BeamLoads loads_of(const Beam& beam, const Vector6& q_i, const Vector6& q_j) {
  const BeamStrain e = strain_of(beam, q_i, q_j);
  const Eigen::Vector3d& n = beam.axis;
  const Eigen::Vector3d s = e.bend_i + e.bend_j;
  const double w = beam.bending;
  return {.force_i = beam.axial * e.stretch * n - (3.0 * w / beam.length) * s.cross(n),
          .moment_i = -w * (s + e.bend_i) + beam.twist * e.twist * n,
          .moment_j = -w * (s + e.bend_j) - beam.twist * e.twist * n};
}

Matrix12 stiffness_of(const Beam& beam) {
  Matrix12 k;
  for (int c = 0; c < 12; ++c) {
    Vector6 q[2] = {Vector6::Zero(), Vector6::Zero()};
    q[c / 6][c % 6] = 1.0;
    const BeamLoads loads = loads_of(beam, q[0], q[1]);
    k.col(c) << -loads.force_i, -loads.moment_i, loads.force_i, -loads.moment_j;
  }
  return k;
}

}  // namespace rift::lattice
