#pragma once

#include "engine/lattice/beam.hpp"

#include <Eigen/Geometry>

namespace rift::lattice {

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
/// quaternion   [physics.md §2]. Zero under any rigid motion; to first order strain_of(beam, q_i, q_j).
BeamStrain strain_of(const Beam& beam, const Pose& i, const Pose& j);

/// Force and moments -dU/dq of U = energy_of(beam, strain_of(beam, i, j)), moments by rotations about the
/// axes of space.
BeamLoads loads_of(const Beam& beam, const Pose& i, const Pose& j);

/// d loads / d motion, 12 x 12, by central differences of loads_of: the stiffness that the beam has there. A
/// motion of an end turns it about the axes of space. Good to 1e-9.
Matrix12 tangent_of(const Beam& beam, const Pose& i, const Pose& j);

}  // namespace rift::lattice
