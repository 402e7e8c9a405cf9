#pragma once

#include "engine/lattice/beam.hpp"

namespace rift::fracture {

/// What the two faces of a crack carry where a beam between them is gone: a spring k against closing along
/// the normal of the face, whatever way the beam ran, and the same along the face as far as Coulomb's
/// friction holds   [ADR 0012; the smooth joint of Mas Ivars et al. 2011]. Where a beam resists a
/// displacement delta of its middle by k_a along and k_s across its axis, k = k_s < k_a is below both: no
/// time step that is stable with the beam is unstable without it.
struct FaceContact {
  double overlap = 0;                                 // min(m . gap, 0) [m]
  Eigen::Vector3d sliding = Eigen::Vector3d::Zero();  // what holds of the rest of the gap less the slip [m]
};

/// k = 6 w / l^2 [N/m]
double face_stiffness(const lattice::Beam& beam);

/// How far the two halves of a beam are apart in its middle, each carried by its element: u_j - u_i - l/2
/// (theta_i + theta_j) x n [m]
Eigen::Vector3d face_gap(const lattice::Beam& beam, const lattice::Vector6& q_i, const lattice::Vector6& q_j);

/// For any rotation, R_i and R_j: u_j - u_i + l n - l/2 (R_i + R_j) n
Eigen::Vector3d face_gap(const lattice::Beam& beam, const lattice::Pose& i, const lattice::Pose& j);

/// @param[in] normal    m, unit, from the face of i to that of j
/// @param[in] slip      along the face, so far [m]
/// @param[in] friction  mu: |sliding| is at most mu |overlap|
FaceContact face_contact(const Eigen::Vector3d& gap, const Eigen::Vector3d& normal,
                         const Eigen::Vector3d& slip, double friction);

/// k/2 (g_a g_b + e_a . e_b) with the overlaps g and the slidings e: the energy where a = b [J].
double bilinear_energy(double stiffness, const FaceContact& a, const FaceContact& b);

}  // namespace rift::fracture
