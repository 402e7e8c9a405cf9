#pragma once

#include "engine/mechanics/beam.hpp"

namespace rift {

/// What the two faces of a crack carry where a beam between them is gone: its own axial stiffness against
/// being shortened, and its own shear stiffness against sliding as far as Coulomb's friction holds   [ADR
/// 0012; Potyondy and Cundall 2004]. Both are springs of the beam itself, so no time step that is stable with
/// the beam is unstable without it.
struct FaceContact {
  double shortening = 0;                              // min(stretch, 0) [m]
  Eigen::Vector3d sliding = Eigen::Vector3d::Zero();  // what holds of alpha_i + alpha_j less the slip [rad]
};

/// @param[in] slip      the slip so far, as the beam's alpha_i + alpha_j [rad]
/// @param[in] friction  mu: the force across, (2/l) 3/2 w |sliding|, is at most mu times that along
FaceContact face_contact(const Beam& beam, const BeamStrain& strain, const Eigen::Vector3d& slip,
                         double friction);

/// 1/2 k_a g_a g_b + 3/4 w e_a.e_b with the shortenings g and the slidings e: the energy where a = b [J].
double bilinear_energy(const Beam& beam, const FaceContact& a, const FaceContact& b);

}  // namespace rift
