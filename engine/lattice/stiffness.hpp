#pragma once

#include "engine/lattice/lattice.hpp"

#include <vector>

namespace rift::lattice {

/// The paper's calibrated set (Table 2): in bulk these beams make a solid of E = 10.3 GPa and nu = 0.3.
inline constexpr MicroMaterial bulk_micro_material{
    .young_modulus = 356e9, .poisson_ratio = 0.3, .radius_ratio = 0.3};

/// Energy of a beam of the lattice in the motions q of its ends [J], by either kinematics.
double energy_of_beam(const Lattice& lattice, int beam, Kinematics kinematics, const std::vector<Vector6>& q);

/// With which the top grip pulls along y to hold the motions q [N]; below 0 it presses.
/// @param[in] present  B, 0 for a beam that a notch has cut
double grip_force(const Lattice& lattice, const std::vector<char>& present, Kinematics kinematics,
                  const std::vector<Vector6>& q);

/// Elastic energy of a lattice per unit of its length [J/m], over the middle half of the length: the beams
/// whose middle lies there. @param[in] q  N displacements and rotation vectors
double energy_per_length(const Lattice& lattice, Kinematics kinematics, const std::vector<Vector6>& q);

/// Modulus of a clamped strip pulled by delta [Pa]: 2 (energy per length) H / (B delta^2), with the nominal
/// height H; a continuum has E / (1 - nu^2)   [physics.md §5, in-situ]. Linear kinematics.
double strip_modulus(const Lattice& lattice, const std::vector<Vector6>& q, double displacement);

}  // namespace rift::lattice
