#pragma once

#include "engine/lattice/modes.hpp"
#include "engine/stability/suite.hpp"

namespace rift::stability {

/// Beams of the small lattices: E_mu 10 GPa, nu_mu 0.3, r_mu 0.5; spheres of 1 mm side by side, 1000 kg/m3.
inline constexpr double small_spacing = 1e-3;  // [m]

/// A row of elements along x, its first one held; two are one beam.
lattice::Lattice small_chain(int elements);

/// A cubic block of elements along x, y, z with beams to the neighbours along the edges and the diagonals of
/// the x-y faces; its lowest and highest rows in y are gripped. @param[in] cut  no beam joins the two halves
/// in y
lattice::Lattice small_block(int nx, int ny, int nz, bool cut = false);

/// Marches the lattice from rest in its highest mode, nothing cracked, and measures what a step does to it:
/// the spectral radius of the matrix that fits all steps best. It diverges where that is above 1; where it is
/// not the energy balance must close, and the mode must turn as lattice::ModeStep::turn() says.
/// @param[in] steps  at most; it ends earlier where the amplitude has grown or shrunk 1e6-fold
Observed vibrate(const lattice::Lattice& lattice, const lattice::HighestMode& mode, double dt, double beta,
                 std::int64_t steps, ensemble::Precision precision);

/// Marches the lattice from rest in a mixture of all motions and looks at the energies a hundred times: half
/// of K + U - C is kinetic in the mean (the virial theorem, as velocity Verlet keeps it).
Observed vibrate_freely(const lattice::Lattice& lattice, double dt, std::int64_t steps,
                        ensemble::Precision precision);

}  // namespace rift::stability
