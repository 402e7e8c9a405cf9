#include "engine/lattice/lattice.hpp"
#include "engine/lattice/statics.hpp"
#include "engine/scene/scene.hpp"
#include "tests/engine/lattice/hand_made.hpp"

#include <gtest/gtest.h>

namespace rift::lattice {
namespace {

using hand_made::Rod;

/// Columns of `beams` equal beams each along y, at x = 0.5, 1.5, ..., in a box of the given length, height
/// `beams` and thickness 0.5.
Lattice colonnade(int columns, int beams, const Rod& rod) {
  Lattice lattice = hand_made::chain(0, Eigen::Vector3d::UnitY(), rod);
  for (int c = 0; c < columns; ++c) {
    for (int k = 0; k <= beams; ++k) {
      lattice.centre.emplace_back(c + 0.5, k, 0.25);
      lattice.grip.push_back(k == 0       ? packing::Grip::bottom
                             : k == beams ? packing::Grip::top
                                          : packing::Grip::none);
      const int here = static_cast<int>(lattice.centre.size()) - 1;
      if (k == 0) continue;
      lattice.ends.push_back({here - 1, here});
      lattice.beam.push_back(rod.between(lattice.centre[here - 1], lattice.centre[here]));
    }
  }
  lattice.mass.assign(lattice.centre.size(), 1.0);
  lattice.inertia.assign(lattice.centre.size(), 0.1);
  lattice.mean_radius = 0.5;
  lattice.box = {.length = 1.0 * columns, .height = 1.0 * beams, .thickness = 0.5};
  return lattice;
}

std::vector<Vector6> stretched(const Lattice& lattice, double displacement) {
  return stretched_at_rest(lattice, std::vector<char>(lattice.beam.size(), 1), displacement);
}

TEST(StripModulus, OfColumnsIsTheirShareOfTheSection) {
  // One column of section S a unit of length, thickness 0.5: E S / 0.5, whatever the pull and the height.
  const Rod rod{.radius = 0.3, .young = 11.0, .poisson = 0.2};
  for (const int beams : {3, 10})
    for (const double displacement : {1.0, -0.02}) {
      const Lattice lattice = colonnade(8, beams, rod);
      const double given = strip_modulus(lattice, stretched(lattice, displacement), displacement);
      EXPECT_NEAR(given / (rod.young * rod.area() / 0.5), 1.0, 1e-11);
    }
}

TEST(StripModulus, LooksAtTheMiddleHalfOnly) {
  const Rod rod, stiff{.radius = 0.2, .young = 50.0, .poisson = 0.25};
  const Lattice even = colonnade(8, 4, rod);
  Lattice stiff_ends = even;
  for (std::size_t b = 0; b < even.beam.size(); ++b)
    if (const double x = even.centre[even.ends[b][0]].x(); x < 2.0 || x > 6.0)
      stiff_ends.beam[b] = stiff.between(even.centre[even.ends[b][0]], even.centre[even.ends[b][1]]);
  const double expected = strip_modulus(even, stretched(even, 0.1), 0.1);
  EXPECT_NEAR(strip_modulus(stiff_ends, stretched(stiff_ends, 0.1), 0.1) / expected, 1.0, 1e-11);
}

TEST(EnergyPerLength, TakesABeamByItsMiddleAndHalfOpen) {
  // A single beam of energy 1/2 k e^2 at different places along a box of length 8: counted from x = 2 up to
  // below 6.
  const Rod rod;
  for (const auto& [x_i, x_j, counted] : std::vector<std::tuple<double, double, bool>>{{2.0, 2.0, true},
                                                                                       {1.5, 2.5, true},
                                                                                       {1.0, 2.9, false},
                                                                                       {2.1, 1.8, false},
                                                                                       {6.0, 6.0, false},
                                                                                       {5.5, 6.5, false},
                                                                                       {5.0, 6.9, true},
                                                                                       {4.0, 4.0, true}}) {
    Lattice lattice = hand_made::chain(2, Eigen::Vector3d::UnitY(), rod);
    lattice.centre = {{x_i, 0.0, 0.0}, {x_j, 1.0, 0.0}};
    lattice.beam = {rod.between(lattice.centre[0], lattice.centre[1])};
    lattice.box.length = 8.0;
    std::vector<Vector6> q(2, Vector6::Zero());
    q[1].head<3>() = 0.1 * lattice.beam[0].axis;
    const double energy = 0.5 * lattice.beam[0].axial * 0.01;
    EXPECT_NEAR(energy_per_length(lattice, Kinematics::linear, q), counted ? energy / 4.0 : 0.0, 1e-15)
        << x_i << ' ' << x_j;
  }
}

TEST(BulkMicroMaterial, IsThePapersTableTwo) {
  EXPECT_EQ(bulk_micro_material.young_modulus, 356e9);
  EXPECT_EQ(bulk_micro_material.poisson_ratio, 0.3);
  EXPECT_EQ(bulk_micro_material.radius_ratio, 0.3);
}

}  // namespace
}  // namespace rift::lattice
