#include "viz/pores.hpp"

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

std::vector<Ball> fillers_of(const results::Geometry& g, double stretch = 1.0) {
  return pore_fillers(g, all_of(g), 1.15F, stretch);
}

/// Cells that show the background between elements and fillers.
std::size_t bare_cells(const results::Geometry& g, const std::vector<Ball>& fillers) {
  std::vector<Disc> discs;
  for (const auto& p : g.position) discs.push_back({p[0], p[1], 1.15});
  for (const Ball& f : fillers) discs.push_back({f.place[0], f.place[1], f.radius});
  CoveredCells cells(discs, 0.02);
  for (const Disc& disc : discs) (void)cells.cover(disc);
  std::size_t bare = 0;
  for (const auto& pore : cells.enclosed()) bare += pore.size();
  return bare;
}

TEST(PoreFillers, CloseAPoreFromBehind) {
  const results::Geometry g = ring(6, 2.0);  // an element would just fit
  EXPECT_GT(bare_cells(g, {}), 1000U);
  const std::vector<Ball> fillers = fillers_of(g);
  ASSERT_EQ(fillers.size(), 1U);
  EXPECT_EQ(bare_cells(g, fillers), 0U);
  EXPECT_LT(fillers[0].place[2] + fillers[0].radius, -1.1F);  // it covers no element
  EXPECT_LT(fillers[0].radius, 1.5F);
}

TEST(PoreFillers, LeaveAnOpeningInWhichAnElementHasRoom) { EXPECT_TRUE(fillers_of(ring(16, 5.2)).empty()); }

TEST(PoreFillers, AreNoneOutsideOfThePlate) {
  const results::Geometry g{.position = {{0, 0, 0}, {2, 0, 0}, {4, 0, 0}},  // notches between them, no pore
                            .radius = {1, 1, 1},
                            .beam = {},
                            .crossing = {}};
  EXPECT_TRUE(fillers_of(g).empty());
}

TEST(PoreFillers, ReckonWithALoadThatOpensAPore) {
  const results::Geometry g = ring(4, 1.05, 0.25 * std::numbers::pi);
  EXPECT_TRUE(fillers_of(g, 1.0).empty());  // it is closed
  EXPECT_EQ(fillers_of(g, 1.3).size(), 1U);
}

TEST(PoreFillers, LeaveAPoreOnTheCrack) {
  results::Geometry g = ring(6, 2.0);
  g.beam = {{1, 5}};
  EXPECT_EQ(fillers_of(g).size(), 1U);
  g.crossing = {0};
  EXPECT_TRUE(fillers_of(g).empty());
}

TEST(PoreFillers, GoByTheElementsThatAreShown) {
  EXPECT_TRUE(pore_fillers(ring(6, 2.0), {0, 1, 2}, 1.15F, 1.0).empty());  // three of them enclose nothing
}

}  // namespace
}  // namespace rift::viz
