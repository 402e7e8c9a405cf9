#pragma once

#include "engine/lattice/beam.hpp"
#include "engine/packing/specimen.hpp"

namespace rift::lattice {

/// The material of the beams (micro) and the density of the whole.
struct MicroMaterial {
  double young_modulus = 0;  // E_mu [Pa]
  double poisson_ratio = 0;  // nu_mu
  double radius_ratio = 0;   // r_mu: beam radius over the mean radius of its two elements
};

/// What moves: masses and beams over the elements of a specimen. All in SI, unloaded.
struct Lattice {
  std::vector<Eigen::Vector3d> centre;   // N [m]
  std::vector<double> radius;            // N [m]
  std::vector<packing::Grip> grip;       // N
  std::vector<double> mass, inertia;     // N [kg], [kg m2]
  std::vector<std::array<int, 2>> ends;  // B pairs i < j
  std::vector<Beam> beam;                // B
  double mean_radius = 0;                // [m] of all elements of the packing
  packing::Box box;
};

/// Masses so that their sum is density x box volume: m_i = rho V_i V_box / sum V_j, I_i = 2/5 m_i r_i^2
/// [physics.md §1]; beams of circular section with radius r_mu (r_i + r_j) / 2   [paper, eqs. 3-6].
Lattice make_lattice(const packing::Specimen& specimen, const MicroMaterial& micro, double density);

}  // namespace rift::lattice
