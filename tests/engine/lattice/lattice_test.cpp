#include "engine/lattice/lattice.hpp"

#include "tests/engine/lattice/hand_made.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rift::lattice {
namespace {

/// Elements of many sizes, each joined to the next two.
packing::Specimen tangle(int elements) {
  hand_made::Draw draw(111);
  packing::Specimen specimen;
  specimen.box = {.length = 0.2, .height = 0.04, .thickness = 0.002};
  for (int i = 0; i < elements; ++i) {
    specimen.centre.emplace_back(0.01 * draw.vector());
    specimen.radius.push_back(1e-3 * draw.between(0.4, 0.6));
    specimen.grip.push_back(static_cast<packing::Grip>(i % 3));
    for (int j = i + 1; j < std::min(i + 3, elements); ++j) specimen.beam.push_back({i, j});
  }
  specimen.rattlers = 4;
  specimen.packing.mean_radius = 4.9e-4;  // rattlers included: not that of the radii above
  return specimen;
}

const MicroMaterial micro{.young_modulus = 356e9, .poisson_ratio = 0.3, .radius_ratio = 0.3};

TEST(Lattice, WeighsDensityTimesItsBox) {
  for (const int elements : {2, 100, 10'000}) {
    const Lattice lattice = make_lattice(tangle(elements), micro, 667.05);
    double total = 0.0, lost = 0.0;  // compensated: the test's own sum must not round
    for (double m : lattice.mass) {
      const double term = m - lost, next = total + term;
      lost = (next - total) - term;
      total = next;
    }
    const double expected = 667.05 * 0.2 * 0.04 * 0.002;
    EXPECT_NEAR(total, expected, 1e-14 * expected * std::max(1.0, elements / 1000.0)) << elements;
  }
}

TEST(Lattice, SharesTheMassByVolumeAsSolidSpheres) {
  const packing::Specimen specimen = tangle(50);
  const Lattice lattice = make_lattice(specimen, micro, 667.05);
  for (int i = 0; i < 50; ++i) {
    const double r = specimen.radius[i];
    EXPECT_NEAR(lattice.mass[i] / lattice.mass[0], std::pow(r / specimen.radius[0], 3), 1e-14);
    EXPECT_NEAR(lattice.inertia[i], 0.4 * lattice.mass[i] * r * r, 1e-14 * lattice.inertia[i]);
  }
}

TEST(Lattice, HasBeamsOfRadiusRatioTimesTheMeanOfTheirElements) {
  const packing::Specimen specimen = tangle(50);
  const Lattice lattice = make_lattice(specimen, micro, 667.05);
  ASSERT_FALSE(specimen.beam.empty());
  ASSERT_EQ(lattice.beam.size(), specimen.beam.size());
  for (std::size_t b = 0; b < lattice.beam.size(); ++b) {
    const auto& [i, j] = specimen.beam[b];
    const Eigen::Vector3d span = specimen.centre[j] - specimen.centre[i];
    const double section = 0.3 * 0.5 * (specimen.radius[i] + specimen.radius[j]), l = span.norm();
    const double area = std::numbers::pi * section * section, I = area * section * section / 4.0;
    EXPECT_NEAR((lattice.beam[b].axis * l - span).norm(), 0.0, 1e-15 * l);
    EXPECT_NEAR(lattice.beam[b].length, l, 1e-15 * l);
    EXPECT_NEAR(lattice.beam[b].axial / (356e9 * area / l), 1.0, 1e-14);
    EXPECT_NEAR(lattice.beam[b].bending / (2.0 * 356e9 * I / l), 1.0, 1e-14);
    EXPECT_NEAR(lattice.beam[b].twist / (356e9 / 2.6 * 2.0 * I / l), 1.0, 1e-14);
  }
}

TEST(Lattice, KeepsPlacesGripsBoxAndTheMeanRadiusOfThePacking) {
  const packing::Specimen specimen = tangle(10);
  const Lattice lattice = make_lattice(specimen, micro, 667.05);
  EXPECT_EQ(lattice.centre, specimen.centre);
  EXPECT_EQ(lattice.grip, specimen.grip);
  EXPECT_EQ(lattice.ends, specimen.beam);
  EXPECT_EQ(lattice.mean_radius, 4.9e-4);
  EXPECT_EQ(lattice.box.volume(), specimen.box.volume());
}

}  // namespace
}  // namespace rift::lattice
