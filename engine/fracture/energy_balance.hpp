#pragma once

namespace rift::fracture {

/// The energy balance of one lane [J]: what its lattice holds, and what has gone where since the balance was
/// opened, each term summed on its own, none as the remainder   [model.md §7].
struct EnergyBalance {
  double elastic = 0;              // U, what the faces of the crack hold included
  double kinetic_translation = 0;  // of the elements not gripped
  double kinetic_rotation = 0;
  double step_correction = 0;  // C = dt^2/8 sum F^2/m, which velocity Verlet conserves together with K + U

  double start = 0;              // K + U - C when the balance was opened
  double fracture = 0;           // taken by beams that lose stiffness
  double damping = 0;            // taken by viscous damping
  double numerical_damping = 0;  // taken by beta < 1
  double contact = 0;  // taken by the friction of the faces, and as they meet and part between two steps
  double work_external = 0;  // done by the grips on the lattice
  double largest = 0;        // K + U - C, the largest so far
  double error = 0;          // balance_error() of the terms above

  /// K + U - C
  double total() const { return elastic + kinetic_translation + kinetic_rotation - step_correction; }
};

/// (K + U - C) - start - W_ext + fracture + damping + numerical damping + contact, over the largest K + U -
/// C. As a lattice begins to move that was at rest without load, K and C cancel: over C until there is more
/// than a trace of energy.
inline double balance_error(const EnergyBalance& b) {
  constexpr double trace = 1e-6;
  const double lost = b.fracture + b.damping + b.numerical_damping + b.contact;
  const double missing = b.total() - b.start - b.work_external + lost;
  if (missing == 0.0) return 0.0;  // a balance just opened on an unloaded lattice
  const bool begins = b.start == 0.0 && b.largest < trace * b.step_correction;
  return missing / (begins ? b.step_correction : b.largest);
}

}  // namespace rift::fracture
