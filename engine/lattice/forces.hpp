#pragma once

#include "engine/lattice/lattice.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace rift::lattice {

/// A beam in one cache line.
struct BeamRow {
  std::int32_t i, j;
  double nx, ny, nz;
  double axial;       // k_a [N/m]
  double bending;     // w [N m]
  double twist;       // k_t [N m]
  double per_length;  // 1 / l [1/m]
};
static_assert(sizeof(BeamRow) == 64);

BeamRow row_of(const Lattice& lattice, int beam);

/// Force and moment which each beam exerts on its two elements   [physics.md §2; paper eqs. (3)-(6)], beam by
/// beam: for Lanczos iteration, and what the ensemble's kernels are measured against.
///   F_i = k_a (n.du) n - (3w/l) s x n,   M = -w (s + alpha) + n [w n.(s + alpha) +- k_t n.(theta_j -
///   theta_i)]
/// @param[in]     beams   n [-], k_a [N/m], w and k_t [N m], 1/l [1/m]
/// @param[in]     q       u [m] and theta [rad], [element][6]
/// @param[in,out] f       force [N] and moment [N m], [element][6], added to
/// Cost O(beams); allocates nothing.
void add_beam_forces(std::span<const BeamRow> beams, const double* q, double* f);

}  // namespace rift::lattice
