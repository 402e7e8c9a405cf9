#include "engine/theory/wave_speeds.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rift::theory {
namespace {

// alpha^2 of the two waves, straight from the definition; D loses no digits near c_R, where its terms do not
// cancel.
double rayleigh_function(double v_over_cs, double cd_over_cs) {
  const double alpha_d = std::sqrt(1.0 - std::pow(v_over_cs / cd_over_cs, 2));
  const double alpha_s2 = 1.0 - v_over_cs * v_over_cs;
  return 4.0 * alpha_d * std::sqrt(alpha_s2) - std::pow(1.0 + alpha_s2, 2);
}

TEST(RayleighSpeed, IsTheRootOfD) {
  for (const Plane plane : {Plane::stress, Plane::strain}) {
    for (const double nu : {-0.9, -0.5, 0.0, 0.1, 0.25, 0.3, 0.49}) {
      const double c = rayleigh_over_shear(nu, plane), cd = dilatational_over_shear(nu, plane);
      // D's slope is between -1 and -15 here and its terms are below 4: rounding leaves 1e-15.
      EXPECT_NEAR(rayleigh_function(c, cd), 0.0, 1e-14) << nu;
      EXPECT_GT(rayleigh_function(c * (1.0 - 1e-12), cd), 0.0) << nu;
      EXPECT_LT(rayleigh_function(c * (1.0 + 1e-12), cd), 0.0) << nu;
    }
  }
}

TEST(RayleighSpeed, IsTheClosedFormOfACauchySolid) {
  // nu = 1/4 in plane strain: y^2 = 2 - 2/sqrt(3)   [Rayleigh 1885]
  EXPECT_NEAR(rayleigh_over_shear(0.25, Plane::strain), std::sqrt(2.0 - 2.0 / std::sqrt(3.0)), 1e-15);
}

TEST(RayleighSpeed, StaysFiniteInAnIncompressibleSolid) {
  const double y = std::pow(rayleigh_over_shear(0.5, Plane::strain), 2);
  EXPECT_NEAR(y * y * y - 8 * y * y + 24 * y - 16, 0.0, 3e-14);  // terms below 22, so rounding below 3e-14
  EXPECT_TRUE(std::isinf(dilatational_over_shear(0.5, Plane::strain)));
}

TEST(DilatationalSpeed, FollowsThePlane) {
  EXPECT_NEAR(dilatational_over_shear(0.25, Plane::strain), std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(dilatational_over_shear(0.5, Plane::stress), 2.0, 1e-15);
}

TEST(WaveSpeeds, GiveTheDensityOfThePaper) {
  // E = 10 GPa, nu = 0.3 and 667 kg/m3 make c_R = 2200 m/s in plane stress, 683 in plane strain. [model.md
  // §5]
  EXPECT_NEAR(wave_speeds(10e9, 0.3, 667.0, Plane::stress).rayleigh, 2200.0, 1.0);
  EXPECT_NEAR(wave_speeds(10e9, 0.3, 683.0, Plane::strain).rayleigh, 2200.0, 1.0);
}

TEST(WaveSpeeds, DilatationalIsThatOfThePlaneModulus) {
  const double e = 70e9, nu = 0.2, rho = 2500.0;
  EXPECT_NEAR(wave_speeds(e, nu, rho, Plane::stress).dilatational, std::sqrt(e / (1 - nu * nu) / rho), 1e-9);
  EXPECT_NEAR(wave_speeds(e, nu, rho, Plane::strain).dilatational,
              std::sqrt(e * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / rho), 1e-9);
  EXPECT_NEAR(wave_speeds(e, nu, rho, Plane::strain).shear, std::sqrt(e / (2 * (1 + nu)) / rho), 1e-9);
}

}  // namespace
}  // namespace rift::theory
