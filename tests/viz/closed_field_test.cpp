#include "viz/closed_field.hpp"

#include "viz/covered_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace rift::viz {
namespace {

/// Discs of radius 1 around the origin, at a distance from it; the first at an angle.
results::Geometry ring(int count, double away, double first = 0.0) {
  results::Geometry g;
  for (int k = 0; k < count; ++k) {
    const double angle = first + 2 * std::numbers::pi * k / count;
    g.position.push_back(
        {static_cast<float>(away * std::cos(angle)), static_cast<float>(away * std::sin(angle)), 0});
    g.radius.push_back(1);
  }
  return g;
}

std::vector<std::int32_t> all_of(const results::Geometry& g) {
  std::vector<std::int32_t> all(g.radius.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// Cells that show the background between the elements of a plate that is drawn as long as it is.
std::size_t bare_cells(const results::Geometry& g, const std::vector<float>& radii) {
  std::vector<Disc> discs;
  for (std::size_t i = 0; i < radii.size(); ++i)
    discs.push_back({g.position[i][0], g.position[i][1], radii[i]});
  CoveredCells cells(discs, 0.02);
  for (const Disc& disc : discs) (void)cells.cover(disc);
  std::size_t bare = 0;
  for (const auto& pore : cells.enclosed()) bare += pore.size();
  return bare;
}

TEST(ClosedField, APoreIsClosedByTheElementsBesideIt) {
  const results::Geometry g = ring(6, 2.0);  // an element would just fit
  EXPECT_GT(bare_cells(g, std::vector<float>(6, 1.15F)), 1000U);
  const std::vector<float> radii = radii_without_pores(g, all_of(g), 1.15F, 1.0);
  EXPECT_EQ(bare_cells(g, radii), 0U);
  for (const float r : radii) EXPECT_LT(r, 2.2F);  // to its middle and no further
}

TEST(ClosedField, AnOpeningInWhichAnElementHasRoomStaysOpen) {
  const results::Geometry g = ring(16, 5.2);
  EXPECT_EQ(radii_without_pores(g, all_of(g), 1.15F, 1.0), std::vector<float>(16, 1.15F));
}

TEST(ClosedField, OutsideOfThePlateNothingGrows) {
  const results::Geometry g{.position = {{0, 0, 0}, {2, 0, 0}, {4, 0, 0}},  // notches between them, no pore
                            .radius = {1, 1, 1},
                            .beam = {},
                            .crossing = {}};
  EXPECT_EQ(radii_without_pores(g, all_of(g), 1.15F, 1.0), std::vector<float>(3, 1.15F));
}

TEST(ClosedField, ALoadThatOpensAPoreIsReckonedWith) {
  const results::Geometry g = ring(4, 1.05, 0.25 * std::numbers::pi);
  EXPECT_EQ(radii_without_pores(g, all_of(g), 1.15F, 1.0), std::vector<float>(4, 1.15F));  // it is closed
  EXPECT_NE(radii_without_pores(g, all_of(g), 1.15F, 1.3), std::vector<float>(4, 1.15F));
}

TEST(ClosedField, APoreOnTheCrackStaysOpen) {
  results::Geometry g = ring(6, 2.0);
  g.beam = {{1, 5}};
  EXPECT_NE(radii_without_pores(g, all_of(g), 1.15F, 1.0), std::vector<float>(6, 1.15F));
  g.crossing = {0};
  EXPECT_EQ(radii_without_pores(g, all_of(g), 1.15F, 1.0), std::vector<float>(6, 1.15F));
}

TEST(ClosedField, ElementsThatAreNotShownCloseNothing) {
  const results::Geometry g = ring(6, 2.0);
  const std::vector<float> radii = radii_without_pores(g, {0, 1, 2}, 1.15F, 1.0);
  EXPECT_EQ(radii, std::vector<float>(3, 1.15F));  // three of them enclose nothing
}

}  // namespace
}  // namespace rift::viz
