#pragma once

#include "engine/lattice/rows.hpp"

#include <span>
#include <vector>

namespace rift::lattice {

/// Force and moment which each beam exerts on its two elements   [model.md §2; paper eqs. (3)-(6)], beam by
/// beam: for Lanczos iteration, and what the ensemble's kernels are measured against.
///   F_i = k_a (n.du) n - (3w/l) s x n,   M = -w (s + alpha) + n [w n.(s + alpha) +- k_t n.(theta_j -
///   theta_i)]
/// @param[in]     beams   n [-], k_a [N/m], w and k_t [N m], 1/l [1/m]
/// @param[in]     q       u [m] and theta [rad], [element][6]
/// @param[in,out] f       force [N] and moment [N m], [element][6], added to
/// Cost O(beams); allocates nothing.
void add_beam_forces(std::span<const BeamRow> beams, const double* q, double* f);

/// Viscous damping of one beam at alpha = 1 (critical)   [paper eq. (8); model.md §6]:
///   f = 2 alpha sqrt(K M) delta n, with K its initial stiffness and M = m_i m_j / (m_i + m_j); rotations
///   likewise.
/// Only rates that vanish in a rigid motion are damped (along the axis, and relative rotation), so that
/// momentum and angular momentum are conserved.
struct DampedBeam {
  int i = 0, j = 0;
  Eigen::Vector3d axis;
  double axial = 0;   // 2 sqrt(k_a M) [N s/m]
  double twist = 0;   // 2 sqrt(k_t I) [N m s]
  double bend = 0;    // 2 sqrt(w/2 I) [N m s]: w/2 is the stiffness against relative rotation of the ends
  int crossing = -1;  // its place among the beams that the crack crosses, or -1
  bool at_surface = false;  // near the crack path
};

DampedBeam damped_beam(const Lattice& lattice, int beam, int crossing, bool at_surface);

/// The damped beams of a lattice, beam by beam: for the critical step, and what the ensemble's kernels are
/// measured against.
struct ViscousDamping {
  std::vector<DampedBeam> beam;
  double alpha_at_surface = 0, alpha_elsewhere = 0;
  std::vector<double> last;  // [beam][4]: force along the axis [N], moment vector [N m], at the last step

  explicit ViscousDamping(std::vector<DampedBeam> beams = {})
      : beam(std::move(beams)), last(4 * beam.size(), 0.0) {}
};

/// Adds the damping forces at rates (q_{n+1} - q_n) / dt, and adds their work of this step,
///   1/2 (F_n + F_{n+1}) . (q_{n+1} - q_n)   [model.md §7].
/// @param[in]     rate      [element][6], (q_{n+1} - q_n) / dt
/// @param[in]     factor    [crossing beam]: a softening beam is damped in proportion
/// @param[in,out] f         [element][6]
/// @param[in,out] work      dissipated so far [J]
void add_damping_forces(ViscousDamping& damping, const double* rate, const double* factor, double dt,
                        double* f, double& work);

}  // namespace rift::lattice
