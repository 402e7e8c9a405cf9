#pragma once

#include "engine/lattice/lattice.hpp"

namespace rift::stability {

/// Beams of the small lattices: E_mu 10 GPa, nu_mu 0.3, r_mu 0.5; spheres of 1 mm side by side, 1000 kg/m3.
inline constexpr double small_spacing = 1e-3;  // [m]

/// A row of elements along x, its first one held; two are one beam.
lattice::Lattice small_chain(int elements);

/// A cubic block of elements along x, y, z with beams to the neighbours along the edges and the diagonals of
/// the x-y faces; its lowest and highest rows in y are gripped. @param[in] cut  no beam joins the two halves
/// in y
lattice::Lattice small_block(int nx, int ny, int nz, bool cut = false);

}  // namespace rift::stability
