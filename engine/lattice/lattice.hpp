#pragma once

#include "engine/lattice/beam.hpp"
#include "engine/packing/specimen.hpp"

#include <vector>

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
  bool grips_turn = false;               // whether the elements that a grip holds are free to turn
  std::vector<double> mass, inertia;     // N [kg], [kg m2]
  std::vector<std::array<int, 2>> ends;  // B pairs i < j
  std::vector<Beam> beam;                // B
  double mean_radius = 0;                // [m] of all elements of the packing
  packing::Box box;

  /// Whether a grip holds the displacements of an element, and its rotations.
  bool is_gripped(std::size_t element) const { return grip[element] != packing::Grip::none; }
  bool cannot_turn(std::size_t element) const { return is_gripped(element) && !grips_turn; }
};

/// Masses so that their sum is density x box volume: m_i = rho V_i V_box / sum V_j, I_i = 2/5 m_i r_i^2
/// [model.md §1]; beams of circular section with radius r_mu (r_i + r_j) / 2   [paper, eqs. 3-6].
Lattice make_lattice(const packing::Specimen& specimen, const MicroMaterial& micro, double density);

/// The paper's calibrated set (Table 2): in bulk these beams make a solid of E = 10.3 GPa and nu = 0.3.
inline constexpr MicroMaterial bulk_micro_material{
    .young_modulus = 356e9, .poisson_ratio = 0.3, .radius_ratio = 0.3};

/// Energy of a beam of the lattice in the motions q of its ends [J], by either kinematics.
double energy_of_beam(const Lattice& lattice, int beam, Kinematics kinematics, const std::vector<Vector6>& q);

/// Elastic energy of a lattice [J], its beams added up in their order.
/// @param[in] present  B, 0 for a beam that is not there
double elastic_energy(const Lattice& lattice, const std::vector<char>& present, Kinematics kinematics,
                      const std::vector<Vector6>& q);

/// Force with which the top grip pulls along y to hold the motions q [N]; below 0 it presses.
/// @param[in] present  B, 0 for a beam that a notch has cut
double grip_force(const Lattice& lattice, const std::vector<char>& present, Kinematics kinematics,
                  const std::vector<Vector6>& q);

/// Elastic energy of a lattice per unit of its length [J/m], over the middle half of the length: the beams
/// whose middle lies there. @param[in] q  N displacements and rotation vectors
double energy_per_length(const Lattice& lattice, Kinematics kinematics, const std::vector<Vector6>& q);

/// Modulus of a clamped strip pulled by delta [Pa]: 2 (energy per length) H / (B delta^2), with the nominal
/// height H; a continuum has E / (1 - nu^2)   [model.md §5, in-situ]. Linear kinematics.
double strip_modulus(const Lattice& lattice, const std::vector<Vector6>& q, double displacement);

}  // namespace rift::lattice
