#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace rift::lattice {

using Vector6 = Eigen::Matrix<double, 6, 1>;     // displacement u [m], then rotation theta [rad]
using Matrix12 = Eigen::Matrix<double, 12, 12>;  // element i, then element j

/// Whether beams answer to small motions only, or to rotations of any size.
enum class Kinematics { linear, corotational };

/// An Euler-Bernoulli beam of circular section between elements i and j, clamped to both: since I_y = I_z it
/// needs no local frame but its axis   [model.md §2; paper eqs. (3)-(6)].
struct Beam {
  Eigen::Vector3d axis;  // n, unit, from i to j
  double length;         // l [m], initial
  double axial;          // k_a = E S / l [N/m]
  double bending;        // w = 2 E I / l [N m]
  double twist;          // k_t = G I_0 / l [N m]
};

/// @param[in] span            from the centre of i to that of j [m]
/// @param[in] section_radius  r_b [m]; S = pi r_b^2, I = pi r_b^4 / 4, I_0 = 2 I
/// @param[in] young_modulus   E_mu [Pa]
/// @param[in] poisson_ratio   nu_mu; G = E / (2 (1 + nu))
Beam make_beam(const Eigen::Vector3d& span, double section_radius, double young_modulus,
               double poisson_ratio);

/// How a beam is deformed; linear in the displacements, zero under any small rigid motion.
struct BeamStrain {
  double stretch;                  // n . (u_j - u_i) [m]
  double twist;                    // n . (theta_j - theta_i) [rad]
  Eigen::Vector3d bend_i, bend_j;  // alpha_i, alpha_j across the axis [rad]: end rotations less the chord's
};

BeamStrain strain_of(const Beam& beam, const Vector6& q_i, const Vector6& q_j);

/// 1/2 a^T k b: the energy where a = b   [model.md §2, U]. Symmetric in a and b.
double bilinear_energy(const Beam& beam, const BeamStrain& a, const BeamStrain& b);

inline double energy_of(const Beam& beam, const BeamStrain& e) { return bilinear_energy(beam, e, e); }

/// Force [N] and moment [N m] on each end, -dU/dq; the force on j is minus the force on i.
struct BeamLoads {
  Eigen::Vector3d force_i, moment_i, moment_j;
};

BeamLoads loads_of(const Beam& beam, const Vector6& q_i, const Vector6& q_j);

/// The 12 x 12 stiffness d^2U/dq^2, from the closed form's response to unit displacements.
Matrix12 stiffness_of(const Beam& beam);

/// Where an element is: its displacement [m] and its rotation, both since the unloaded lattice.
struct Pose {
  Eigen::Vector3d u = Eigen::Vector3d::Zero();
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
};

/// The pose of a displacement and a rotation vector of any size.
Pose pose_of(const Vector6& motion);

/// The displacement and the rotation vector (|theta| <= pi) of a pose.
Vector6 motion_of(const Pose& pose);

/// Deformation of a beam of any rotation, in directors: with t = R n_0 the initial axis carried along by an
/// element and n the present axis, bend = n x t; twist = 2 n.p with p the vector of the relative rotation's
/// quaternion   [model.md §2]. Zero under any rigid motion; to first order strain_of(beam, q_i, q_j).
BeamStrain strain_of(const Beam& beam, const Pose& i, const Pose& j);

/// Force and moments -dU/dq of U = energy_of(beam, strain_of(beam, i, j)), moments by rotations about the
/// axes of space.
BeamLoads loads_of(const Beam& beam, const Pose& i, const Pose& j);

/// d loads / d motion, 12 x 12, by central differences of loads_of: the stiffness that the beam has there. A
/// motion of an end turns it about the axes of space. Good to 1e-9.
Matrix12 tangent_of(const Beam& beam, const Pose& i, const Pose& j);

}  // namespace rift::lattice
