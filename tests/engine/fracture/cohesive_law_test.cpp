#include "engine/fracture/cohesive_law.hpp"

#include "tests/engine/calibration/cubic_lattice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rift::fracture {
namespace {

using calibration::cubic_lattice::edge;
using calibration::cubic_lattice::lattice_of;

constexpr CohesiveMaterial glass{
    .law = FractureLaw::cohesive, .release_rate = 3.0, .strength = 1e5, .young_modulus = 1e9, .kappa = 0.7};

TEST(CohesiveLaw, FollowsALineFromTheStrengthToNothing) {
  const Softening beam{2.0, 10.0};
  EXPECT_EQ(stiffness_left(beam, 0.0), 1.0);
  EXPECT_EQ(stiffness_left(beam, 2.0), 1.0);
  EXPECT_EQ(stiffness_left(beam, 10.0), 0.0);
  EXPECT_EQ(stiffness_left(beam, 11.0), 0.0);
  for (const double opening :
       {2.5, 4.0, 6.0, 9.9})  // force over stiffness, s delta, against the straight line
    EXPECT_NEAR(stiffness_left(beam, opening) * opening, 2.0 * (10.0 - opening) / 8.0, 1e-15 * 10.0);
}

TEST(CohesiveLaw, TakesKappaGcForTheAreaThatABeamStandsFor) {
  const lattice::Lattice lattice = lattice_of({4, 4, 4}, packing::Shape::periodic);
  EXPECT_NEAR(area_of_beam(lattice) / (edge * edge), 1.0, 1e-8);
  for (const FractureLaw law : {FractureLaw::cohesive, FractureLaw::snap}) {
    CohesiveMaterial material = glass;
    material.law = law;
    const std::vector<Softening> softening = softening_of(lattice, material);
    ASSERT_EQ(softening.size(), lattice.beam.size());
    for (std::size_t b = 0; b < softening.size(); ++b) {
      const Softening& s = softening[b];
      EXPECT_NEAR(0.5 * lattice.beam[b].axial * s.first * s.last / (0.7 * 3.0 * edge * edge), 1.0, 1e-7);
      if (law == FractureLaw::snap)
        EXPECT_EQ(s.first, s.last);
      else
        EXPECT_NEAR(s.first / (lattice.beam[b].length * 1e-4), 1.0, 1e-12);
    }
  }
}

TEST(ResolvedStrength, IsThatOfSixteenRadii) {
  const lattice::Lattice lattice = lattice_of({4, 4, 4}, packing::Shape::periodic);
  EXPECT_NEAR(resolved_strength(lattice, glass) /
                  std::sqrt(9.0 * std::numbers::pi / 32.0 * 1e9 * 3.0 / (16.0 * lattice.mean_radius)),
              1.0, 1e-12);
  for (const double kappa :
       {1e-4, 1e-3}) {  // so little energy that beams could not soften before they are gone
    CohesiveMaterial weak = glass;
    weak.kappa = kappa;
    weak.strength = resolved_strength(lattice, weak);
    double closest = 1e9;
    for (const Softening& s : softening_of(lattice, weak)) closest = std::min(closest, s.last / s.first);
    EXPECT_NEAR(closest, 1.0, 1e-9);
  }
}

TEST(BrokenBeams, LeadWhereThreeAreNearEachOther) {
  BrokenBeams gone(1.0);
  gone.add({0.0, 0.0}), gone.add({5.0, 0.0}), gone.add({0.5, 0.5});
  EXPECT_FALSE(gone.leading());
  gone.add({0.9, 0.0});
  EXPECT_EQ(gone.leading(), 0.9);
  gone.add({5.5, 0.0});
  EXPECT_EQ(gone.leading(), 0.9);
  gone.add({4.5, 0.0});
  EXPECT_EQ(gone.leading(), 5.5);
  EXPECT_EQ(gone.count(), 6);
}

}  // namespace
}  // namespace rift::fracture
