#include "viz/field.hpp"

#include "tests/expectations.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <numbers>

namespace rift::viz {
namespace {

using Header = nlohmann::ordered_json;

const Header numbers_of_run{{"displacement_m", 2e-3}, {"solid_fraction", 0.6}, {"density_kg_m3", 600.0}};

results::Geometry two_elements() {
  return {
      .position = {{0, 0, 0}, {1e-3F, 0, 0}}, .radius = {5e-4F, 5e-4F}, .beam = {{0, 1}}, .crossing = {0}};
}

results::Frame frame_of_two() {
  return {.displacement = {{1, -2, 2}, {0, 3, 4}},
          .velocity = {{10, 0, 0}, {0, 3, 4}},
          .damage_factor = {0.25F},
          .elastic_energy = {2e-4F, 0},
          .rotation = {}};
}

std::vector<float> values(std::string_view name) {
  return values_of(*find_field(name), frame_of_two(), two_elements(), numbers_of_run);
}

TEST(Field, ComponentsAndMagnitudesAreThoseOfTheFrame) {
  EXPECT_EQ(values("uy"), (std::vector<float>{-2, 3}));
  EXPECT_EQ(values("uz"), (std::vector<float>{2, 4}));
  EXPECT_EQ(values("u"), (std::vector<float>{3, 5}));
  EXPECT_EQ(values("vx"), (std::vector<float>{10, 0}));
  EXPECT_EQ(values("v"), (std::vector<float>{10, 5}));
}

TEST(Field, KineticDensityAddsUpToTheEnergyOfTheElements) {
  const double sphere = 4.0 / 3.0 * std::numbers::pi * std::pow(5e-4, 3);
  const double share = sphere / 0.6, mass = 1000 * sphere;
  EXPECT_NEAR(values("kinetic")[0] * share, 0.5 * mass * 100, 1e-6 * mass * 100);
  EXPECT_NEAR(values("kinetic")[1] * share, 0.5 * mass * 25, 1e-6 * mass * 25);
}

TEST(Field, ElasticDensityIsTheEnergyOverTheElementsShareOfThePlate) {
  const double share = 4.0 / 3.0 * std::numbers::pi * std::pow(5e-4, 3) / 0.6;
  EXPECT_NEAR(values("elastic")[0], 2e-4 / share, 1e-5 * 2e-4 / share);
  EXPECT_EQ(values("elastic")[1], 0);
}

TEST(Field, DamageIsOneLessTheFactorAtBothEndsOfABeam) {
  EXPECT_EQ(values("damage"), (std::vector<float>{0.75F, 0.75F}));
}

TEST(Field, AFrameWithoutWhatAFieldNeedsGivesNoValues) {
  for (const Field& field : not_empty(fields()))
    EXPECT_TRUE(values_of(field, {}, two_elements(), numbers_of_run).empty()) << field.name;
}

TEST(Field, TheVerticalDisplacementLiesBetweenTheGrips) {
  EXPECT_EQ(known_range(*find_field("uy"), numbers_of_run), (std::array{0.0, 2e-3}));
  EXPECT_EQ(known_range(*find_field("v"), numbers_of_run), std::nullopt);
}

TEST(Field, ARangeLeavesOutliersAndIsSymmetricWhereItsScaleIs) {
  std::vector<float> many(1000, 1.0F);
  many[17] = -1000.0F;
  auto copy = many;
  EXPECT_EQ(range_of(*find_field("vy"), copy), (std::array{-1.0, 1.0}));
  EXPECT_EQ(range_of(*find_field("v"), many), (std::array{0.0, 1.0}));
}

TEST(Field, NoFieldHasAnUnknownName) {
  EXPECT_EQ(find_field("pressure"), nullptr);
  for (const Field& field : not_empty(fields())) EXPECT_EQ(find_field(field.name), &field);
}

}  // namespace
}  // namespace rift::viz
