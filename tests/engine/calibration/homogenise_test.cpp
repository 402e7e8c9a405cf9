#include "engine/calibration/homogenise.hpp"

#include "tests/engine/calibration/cubic_lattice.hpp"
#include "tests/engine/packing/packed_once.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace rift::calibration {
namespace {

TEST(Homogenisation, OfACubicLatticeIsExact) {
  const Matrix6 c = homogenised_stiffness(cubic_lattice::lattice_of({4, 5, 6}, packing::Shape::periodic));
  const double r = cubic_lattice::section_radius, l = cubic_lattice::edge, e = cubic_lattice::young;
  const double direct = e * std::numbers::pi * r * r / (l * l);
  // Both families of beams bend by half the shear: two beams a cell of 3 w (gamma / 2)^2 each, w = 2 E I / l.
  const double shear = 6.0 * e * (std::numbers::pi * r * r * r * r / 4.0) / (l * l * l * l);
  Matrix6 exact = Matrix6::Zero();
  exact.diagonal() << direct, direct, direct, shear, shear, shear;
  EXPECT_LT((c - exact).norm() / direct, 1e-8);
}

lattice::Lattice random_box(std::uint64_t seed) {
  const packing::Box box{10e-3, 10e-3, 10e-3, packing::Shape::periodic};
  const packing::Packing packing = packing::packed_once(
      {.box = box, .elements = 800, .radius_spread = 0.125, .coordination = 6.0, .seed = seed});
  return lattice::make_lattice(packing::make_free_specimen(packing, box, 1.0), {356e9, 0.3, 0.3}, 1000.0);
}

TEST(Homogenisation, IsSymmetricAndPositive) {
  const Matrix6 c = homogenised_stiffness(random_box(1));
  EXPECT_LT((c - c.transpose()).norm() / c.norm(), 1e-12);
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Matrix6>(c).eigenvalues().minCoeff(), 0.1e9);
}

TEST(Homogenisation, OfARandomBoxIsNearlyIsotropic) {
  const Isotropic solid = isotropic_part(homogenised_stiffness(random_box(1)));
  EXPECT_LT(solid.anisotropy, 0.05);
  EXPECT_GT(solid.anisotropy, 0.0);
  EXPECT_NEAR(solid.poisson_ratio, 0.32, 0.02);
}

TEST(IsotropicPart, OfAnIsotropicTensorIsItself) {
  const double e = 10.0, nu = 0.3, lame = e * nu / ((1 + nu) * (1 - 2 * nu)), g = e / (2 * (1 + nu));
  Matrix6 c = Matrix6::Zero();
  c.topLeftCorner<3, 3>().setConstant(lame);
  c.topLeftCorner<3, 3>().diagonal().array() += 2 * g;
  c.bottomRightCorner<3, 3>().diagonal().setConstant(g);
  const Isotropic solid = isotropic_part(c);
  EXPECT_NEAR(solid.young_modulus, e, 1e-12);
  EXPECT_NEAR(solid.poisson_ratio, nu, 1e-13);
  EXPECT_NEAR(solid.anisotropy, 0.0, 1e-12);
}

}  // namespace
}  // namespace rift::calibration
