#pragma once

#include "engine/base/cache.hpp"
#include "engine/base/interrupted.hpp"
#include "engine/calibration/cylinders.hpp"
#include "engine/lattice/lattice.hpp"

namespace rift::calibration {

/// In the order xx, yy, zz, yz, xz, xy, with engineering shears.
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Stiffness tensor of a lattice that repeats itself [Pa]: six unit strains, each with the motions that leave
/// every element in balance, and C_ab = (2 / V) sum over beams of their bilinear energy.
/// Cost of six solutions with one matrix; throws StaticsError. Asserts a periodic box.
Matrix6 homogenised_stiffness(const lattice::Lattice& lattice, const base::ProgressCallback& told = {});

/// The isotropic solid nearest to a tensor, and how far from it the tensor is.
struct Isotropic {
  double young_modulus = 0, poisson_ratio = 0;  // of the Voigt-Reuss-Hill average
  double anisotropy = 0;                        // A^U = 5 G_V / G_R + K_V / K_R - 6; 0 where isotropic
};

/// Hill 1952; Ranganathan and Ostoja-Starzewski 2008 for the index.
Isotropic isotropic_part(const Matrix6& stiffness);

/// A periodic box that is homogenised with beams of unit modulus.
struct BoxTest {
  packing::PackingRequest packing;  // in a periodic box
  double contact_tolerance = 1;
  BeamShape beams;
};

struct BoxResult {
  packing::PackingRequest packing;
  double coordination = 0, solid_fraction = 0;
  Matrix6 stiffness;  // over E_mu
  Isotropic isotropic() const { return isotropic_part(stiffness); }
};

/// Homogenises all boxes; as press_cylinders() does it.
std::vector<BoxResult> homogenise_boxes(const std::vector<BoxTest>& tests, base::Cache& cache,
                                        const base::ProgressCallback& progress = {}, int threads = 0);

}  // namespace rift::calibration
