#include "engine/lattice/beam.hpp"

#include <Eigen/Geometry>

#include <cmath>
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

namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// n and its inverse length, and what the strains are made of.
struct Directors {
  Vector3d n, t_i, t_j, p;
  double p0, length, stretch;
};

Directors directors_of(const Beam& beam, const Pose& i, const Pose& j) {
  const Vector3d du = j.u - i.u, chord = beam.length * beam.axis + du;
  Directors d;
  d.length = chord.norm();
  d.n = chord / d.length;
  d.stretch = du.dot(chord + beam.length * beam.axis) / (d.length + beam.length);
  d.t_i = i.turn * beam.axis;
  d.t_j = j.turn * beam.axis;
  const Quaterniond relative = j.turn * i.turn.conjugate();
  d.p0 = relative.w();
  d.p = relative.vec();
  return d;
}

BeamStrain strain_in(const Directors& d) {
  return {.stretch = d.stretch,
          .twist = 2.0 * d.n.dot(d.p),
          .bend_i = d.n.cross(d.t_i),
          .bend_j = d.n.cross(d.t_j)};
}

}  // namespace

Pose pose_of(const Vector6& motion) {
  const Vector3d theta = motion.tail<3>();
  const double half = 0.5 * theta.norm();
  const double sinc = half < 1e-6 ? 1.0 - half * half / 6.0 : std::sin(half) / half;
  const Vector3d v = 0.5 * sinc * theta;
  return {motion.head<3>(), Quaterniond(std::cos(half), v.x(), v.y(), v.z())};
}

Vector6 motion_of(const Pose& pose) {
  const double sign = pose.turn.w() < 0.0 ? -1.0 : 1.0;
  const Vector3d v = sign * pose.turn.vec();
  const double s = v.norm(), half = std::atan2(s, sign * pose.turn.w());
  Vector6 motion;
  motion << pose.u, (s < 1e-9 ? 2.0 : 2.0 * half / s) * v;
  return motion;
}

BeamStrain strain_of(const Beam& beam, const Pose& i, const Pose& j) {
  return strain_in(directors_of(beam, i, j));
}

BeamLoads loads_of(const Beam& beam, const Pose& i, const Pose& j) {
  const Directors d = directors_of(beam, i, j);
  const BeamStrain e = strain_in(d);
  const Vector3d g_i = beam.bending * (2.0 * e.bend_i + e.bend_j),
                 g_j = beam.bending * (2.0 * e.bend_j + e.bend_i);
  const double torque = beam.twist * e.twist;
  const Vector3d h = d.t_i.cross(g_i) + d.t_j.cross(g_j) + 2.0 * torque * d.p;
  return {.force_i = beam.axial * e.stretch * d.n + (h - d.n * d.n.dot(h)) / d.length,
          .moment_i = torque * (d.p0 * d.n + d.n.cross(d.p)) - d.t_i.cross(g_i.cross(d.n)),
          .moment_j = -torque * (d.p0 * d.n - d.n.cross(d.p)) - d.t_j.cross(g_j.cross(d.n))};
}

Matrix12 tangent_of(const Beam& beam, const Pose& i, const Pose& j) {
  constexpr double turn = 1e-5;  // rounding 1e-16 / 1e-5 beside a truncation of 1e-10
  const double shift = turn * beam.length;
  Matrix12 k;
  for (int c = 0; c < 12; ++c) {
    const double size = c % 6 < 3 ? shift : turn;
    Eigen::Matrix<double, 12, 1> side[2];
    for (const int s : {0, 1}) {
      Pose pose[2] = {i, j};
      Pose& end = pose[c / 6];
      Vector6 small = Vector6::Zero();
      small[c % 6] = s == 0 ? -size : size;
      const Pose moved = pose_of(small);
      end.u += moved.u;
      end.turn = moved.turn * end.turn;
      const BeamLoads loads = loads_of(beam, pose[0], pose[1]);
      side[s] << -loads.force_i, -loads.moment_i, loads.force_i, -loads.moment_j;
    }
    k.col(c) = (side[1] - side[0]) / (2.0 * size);
  }
  return k;
}

}  // namespace rift::lattice
