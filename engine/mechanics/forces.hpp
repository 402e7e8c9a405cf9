#pragma once

#include "engine/lattice/lattice.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace rift {

/// A beam as the hot loop reads it: one cache line.
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

/// Force and moment which each beam exerts on its two elements, for every lane   [physics.md §2; paper eqs.
/// (3)-(6)].
///   F_i = k_a (n.du) n - (3w/l) s x n,   M = -w (s + alpha) + n [w n.(s + alpha) +- k_t n.(theta_j -
///   theta_i)]
/// @param[in]     beams   n [-], k_a [N/m], w and k_t [N m], 1/l [1/m]
/// @param[in]     q       u [m] and theta [rad], [element][6][lane]
/// @param[in]     factor  Y1/Y2 of each beam, [beam][lane]; the second form only
/// @param[in,out] f       force [N] and moment [N m], [element][6][lane], added to
/// Cost O(beams x lanes); allocates nothing.
template <int Lanes>
void add_beam_forces(std::span<const BeamRow> beams, const double* q, double* f);
template <int Lanes>
void add_beam_forces(std::span<const BeamRow> beams, const double* factor, const double* q, double* f);

}  // namespace rift
