#include "engine/theory/wave_loaded_crack.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace rift::theory {
namespace {

WaveLoadedCrack glass(double young_modulus, double poisson_ratio) {
  return wave_loaded_crack(young_modulus, poisson_ratio, 2450.0, Plane::stress, 3.0, 1e6, 0.08);
}

// An independent integration of the exact g(v), with two decimals of a microsecond.
TEST(WaveLoadedCrack, RunsAsAnIndependentIntegrationSays) {
  const WaveLoadedCrack crack = glass(32e9, 0.2);
  EXPECT_NEAR(crack.arrival, 10.844e-6, 5e-10);
  EXPECT_NEAR(crack.delay, 5.323e-6, 5e-10);
  EXPECT_NEAR(crack.rayleigh, 2111.7, 0.05);
  EXPECT_NEAR(crack.time_of(0.0), 16.17e-6, 5e-9);
  for (const auto& [mm, us] :
       {std::pair{3, 21.04}, {5, 22.77}, {8, 25.01}, {10, 26.39}, {12, 27.70}, {15, 29.59}, {17, 30.80}}) {
    EXPECT_NEAR(crack.time_of(1e-3 * mm), 1e-6 * us, 1e-8) << mm;
    EXPECT_NEAR(crack.advance_at(crack.time_of(1e-3 * mm)), 1e-3 * mm, 1e-12);
  }
  const WaveLoadedCrack own = glass(31.7e9, 0.274);
  for (const auto& [mm, us] : {std::pair{3, 21.05}, {8, 25.11}, {15, 29.78}})
    EXPECT_NEAR(own.time_of(1e-3 * mm), 1e-6 * us, 1e-8) << mm;
}

}  // namespace
}  // namespace rift::theory
