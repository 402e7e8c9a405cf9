#pragma once

#include "engine/lattice/static_system.hpp"

#include <vector>

namespace rift::lattice {

/// How the top face is moved along y: by `middle` [m] in its middle, and by `tilt` of that more at its right
/// end and less at its left one, straight between; and by `shear` of it along x.
struct Pull {
  double middle = 0, tilt = 0, shear = 0;
  Pull(double displacement, double tilt_of_it = 0, double shear_of_it = 0)
      : middle(displacement), tilt(tilt_of_it), shear(shear_of_it) {}  // NOLINT: a plain pull is a number
  double at(double over_length) const { return middle * (1.0 + tilt * (2.0 * over_length - 1.0)); }
};

/// Displacements of all elements at rest, K q = 0 on the free ones   [physics.md §4].
/// Bottom elements are clamped, top elements move without turning; elements that no
/// path of present beams joins to a grip stay where they are.
/// @param[in] present       B, 0 for a beam that a notch has cut
/// @return N displacements (u [m], theta [rad]); relative residual of the free forces 1e-13
/// Cost about 100 products with K (conjugate gradients, see RigidPatches); throws StaticsError, Interrupted.
std::vector<Vector6> stretched_at_rest(const Lattice& lattice, const std::vector<char>& present,
                                       const Pull& pull, const base::FractionTold& told = {});

/// The same with corotational beams: Newton's method from the linear solution until the free forces are 1e-11
/// of the linear loads, or what rounding leaves of strains below 1e-4. Cost about five linear solutions;
/// throws StaticsError, Interrupted.
/// @return N displacements and rotation vectors
std::vector<Vector6> stretched_at_rest_corotational(const Lattice& lattice, const std::vector<char>& present,
                                                    const Pull& pull, const base::FractionTold& told = {});

}  // namespace rift::lattice
