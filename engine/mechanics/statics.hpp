#pragma once

#include "engine/mechanics/static_system.hpp"

#include <vector>

namespace rift {

/// Displacements of all elements at rest, K q = 0 on the free ones   [physics.md §4].
/// Bottom elements are clamped, top elements move by `displacement` along y without turning; elements that no
/// path of present beams joins to a grip stay where they are.
/// @param[in] present       B, 0 for a beam that a notch has cut
/// @param[in] displacement  [m]
/// @return N displacements (u [m], theta [rad]); relative residual of the free forces 1e-13
/// Cost about 100 products with K (conjugate gradients, see RigidPatches); throws StaticsError.
std::vector<Vector6> stretched_at_rest(const Lattice& lattice, const std::vector<char>& present,
                                       double displacement);

/// The same with corotational beams: Newton's method from the linear solution until the free forces are 1e-11
/// of the linear loads, or what rounding leaves of strains below 1e-4. Cost about five linear solutions;
/// throws StaticsError.
/// @return N displacements and rotation vectors
std::vector<Vector6> stretched_at_rest_corotational(const Lattice& lattice, const std::vector<char>& present,
                                                    double displacement);

}  // namespace rift
