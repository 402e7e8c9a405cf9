#include "engine/fracture/wake.hpp"

#include "tests/expectations.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>

namespace rift::fracture {
namespace {

/// A square net of 64 x 16 elements of radius 1 mm and mass 2 kg, a diameter apart.
lattice::Lattice net() {
  lattice::Lattice lattice;
  lattice.mean_radius = 1e-3;
  lattice.box = {.length = 0.128, .height = 0.032, .thickness = 0.002};
  for (int i = 0; i < 64; ++i)
    for (int k = 0; k < 16; ++k) {
      lattice.centre.emplace_back(1e-3 + 2e-3 * i, 1e-3 + 2e-3 * k, 1e-3);
      lattice.mass.push_back(2.0), lattice.inertia.push_back(0.5);
    }
  return lattice;
}

constexpr std::array<double, 2> all{0.0, 0.128};

Wake of_motion(const std::function<double(int, int)>& velocity, const std::array<double, 2>& stretch = all) {
  std::vector<lattice::Vector6> v(64UL * 16UL, lattice::Vector6::Zero());
  for (int i = 0; i < 64; ++i)
    for (int k = 0; k < 16; ++k) v[i * 16UL + k][1] = velocity(i, k);
  return wake_of(net(), stretch, v, std::vector<double>(v.size(), 0.0));
}

TEST(Wake, CellsDoubleFromFourRadiiToTheHeight) {
  const Wake wake = of_motion([](int, int) { return 1.0; });
  EXPECT_EQ(wake.cell_m, (std::vector<double>{4e-3, 8e-3, 16e-3, 32e-3}));
  EXPECT_EQ(wake.kinetic_j.size(), 5U);
}

TEST(Wake, ARigidMotionIsAllInTheLargestCells) {
  const Wake wake = of_motion([](int, int) { return 3.0; });
  for (int band = 0; band < 4; ++band) EXPECT_NEAR(wake.kinetic_j[band], 0.0, 1e-9);
  EXPECT_NEAR(wake.kinetic_j.back(), 0.5 * 2.0 * 1024 * 9.0, 1e-9);
}

TEST(Wake, NeighboursAgainstEachOtherAreAllInTheSmallest) {
  const Wake wake = of_motion([](int i, int) { return i % 2 == 0 ? 1.0 : -1.0; });
  EXPECT_NEAR(wake.kinetic_j.front(), 1024.0, 1e-9);
  ASSERT_GT(wake.kinetic_j.size(), 1U);
  for (std::size_t band = 1; band < wake.kinetic_j.size(); ++band) EXPECT_EQ(wake.kinetic_j[band], 0.0);
}

TEST(Wake, ABlockAgainstTheNextIsInTheBandThatJoinsThem) {
  const Wake wake = of_motion([](int i, int) { return (i / 4) % 2 == 0 ? 1.0 : -1.0; });  // 8 mm wide
  EXPECT_NEAR(wake.kinetic_j[2], 1024.0, 1e-9);  // whole in cells of 8 mm, gone in those of 16 mm
}

TEST(Wake, BandsAddUpToTheEnergyOfTheStretch) {
  const auto rough = [](int i, int k) { return std::sin(1.7 * i * i + 0.3 * k) + 0.2; };
  const Wake wake = of_motion(rough, {0.032, 0.096});
  double energy = 0.0;
  for (int i = 16; i < 48; ++i)
    for (int k = 0; k < 16; ++k) energy += rough(i, k) * rough(i, k);
  EXPECT_NEAR(std::accumulate(wake.kinetic_j.begin(), wake.kinetic_j.end(), 0.0) / energy, 1.0, 1e-12);
  for (double band : not_empty(wake.kinetic_j)) EXPECT_GE(band, -1e-9);
}

TEST(Wake, OutOfPlaneIsTheMeanOfACellNotOfAnElement) {
  std::vector<lattice::Vector6> v(64UL * 16UL, lattice::Vector6::Zero());
  v[5][4] = 2.0;
  std::vector<double> moved(v.size());
  for (int i = 0; i < 64; ++i)
    for (int k = 0; k < 16; ++k) moved[i * 16UL + k] = (i >= 60 ? -1e-5 : 0.0) + (i % 2 == 0 ? 1e-3 : -1e-3);
  const Wake wake = wake_of(net(), all, v, moved);
  EXPECT_NEAR(wake.out_of_plane_m, 1e-5, 1e-12);
  EXPECT_EQ(wake.rotation_j, 1.0);
}

}  // namespace
}  // namespace rift::fracture
