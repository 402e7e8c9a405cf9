#include "engine/simulation/own_constants.hpp"

#include "engine/base/files.hpp"
#include "tests/engine/simulation/small_plate.hpp"

namespace rift::simulation {
namespace {

// Beams of twice the modulus make a plate of twice E and of the same nu.
TEST(OwnConstants, GoWithTheBeamsModulus) {
  const auto with = [](const char* modulus) {
    return own_constants(
        small_plate({"material.stiffness=explicit", std::string("material.micro_young_modulus=") + modulus,
                     "material.micro_poisson_ratio=0.3", "material.micro_radius_ratio=0.3"}),
        shared_cache());
  };
  const OwnConstants soft = with("150 GPa"), stiff = with("300 GPa");
  EXPECT_NEAR(stiff.young_modulus() / soft.young_modulus(), 2.0, 1e-6);
  EXPECT_NEAR(stiff.poisson_ratio(), soft.poisson_ratio(), 1e-6);
  EXPECT_EQ(stiff.between_grips, soft.between_grips);
}

// Grips hold elements whose centre lies within 1.3 radii of a face: half a radius or so more than one.
TEST(OwnConstants, TheHeightBetweenTheGripsIsAboutTwoRadiiLess) {
  const Prepared p = small_plate();
  const double less = (p.lattice.box.height - between_grips(p.lattice)) / p.lattice.mean_radius;
  EXPECT_GT(less, 1.6);
  EXPECT_LT(less, 2.2);
}

TEST(OwnConstants, AreMeasuredOnceASpecimen) {
  const Prepared p = small_plate();
  const TemporaryFolder folder;
  base::Cache cache{.folder = folder.path(), .notes = {}};
  EXPECT_FALSE(known_constants(p, cache));
  int told = 0;
  const auto tell = [&](double) { return ++told > 0; };
  const OwnConstants first = own_constants(p, cache, tell);
  EXPECT_GT(told, 0);
  told = 0;
  const OwnConstants again = own_constants(p, cache, tell);
  EXPECT_EQ(told, 0);
  ASSERT_TRUE(known_constants(p, cache));
  EXPECT_EQ(known_constants(p, cache)->poisson_across, first.poisson_across);
  EXPECT_EQ(known_constants(p, cache)->between_grips, first.between_grips);
  EXPECT_EQ(first.young_along, again.young_along);
  EXPECT_EQ(first.poisson_across, again.poisson_across);
}

}  // namespace
}  // namespace rift::simulation
