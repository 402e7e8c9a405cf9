#pragma once

#include "engine/results/schema.hpp"

namespace rift::fracture {

/// What one lane has gained and lost so far, each booked on its own, none as the remainder [J]   [physics.md
/// §7].
struct Ledger {
  double energy_start = 0;       // lattice energy K + U - C when the books were opened
  double fracture = 0;           // taken by softening and breaking beams
  double damping = 0;            // by viscous damping
  double numerical_damping = 0;  // by beta < 1
  double contact = 0;            // by the friction of the faces, and as they meet and part between two steps
  double work_external = 0;      // done by the grips on the lattice
  double largest = 0;            // largest lattice energy so far
};

/// The energies a lattice holds at one moment [J].
struct LatticeEnergy {
  double elastic = 0;              // U, what the faces of the crack hold included
  double kinetic_translation = 0;  // of the elements not gripped
  double kinetic_rotation = 0;
  double step_correction = 0;  // C = dt^2/8 sum F^2/m, which velocity Verlet conserves together with K + U
  double total() const { return elastic + kinetic_translation + kinetic_rotation - step_correction; }
};

/// (K + U - C) - start - W_ext + fracture + damping + numerical damping + contact, over the largest lattice
/// energy so far.
double residual_of(const Ledger& ledger, const LatticeEnergy& energy);

/// One row of the books. Notes the largest lattice energy.
results::Sample balance(Ledger& ledger, const LatticeEnergy& energy);

}  // namespace rift::fracture
