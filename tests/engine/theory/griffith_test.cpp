#include "engine/theory/references.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace rift::theory {
namespace {

constexpr double e = 10e9, nu = 0.3, height = 0.2, delta = 2e-3, strain = delta / height;  // [Pa], [m]

// By Hooke's law with no strain along the crack, in each plane with its own E'.
TEST(Griffith, IsPiSigmaSquaredOverEPrimeInPlaneStress) {
  const double sigma = e / (1.0 - nu * nu) * strain;
  const double slope = griffith_slope(0.5 * sigma * delta, height, nu, Plane::stress);
  EXPECT_NEAR(slope / (std::numbers::pi * sigma * sigma / e), 1.0, 1e-14);
}

TEST(Griffith, IsPiSigmaSquaredOverEPrimeInPlaneStrain) {
  const double sigma = e * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu)) * strain;
  const double e_prime = e / (1.0 - nu * nu);
  const double slope = griffith_slope(0.5 * sigma * delta, height, nu, Plane::strain);
  EXPECT_NEAR(slope / (std::numbers::pi * sigma * sigma / e_prime), 1.0, 1e-14);
}

}  // namespace
}  // namespace rift::theory
