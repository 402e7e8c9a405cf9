#include "viz/front_layer.hpp"

#include <gtest/gtest.h>

namespace rift::viz {
namespace {

TEST(FrontLayer, WhatLiesBehindAnElementIsLeftOut) {
  const results::Geometry g{.position = {{0, 0, 0}, {0, 0, 1}, {5, 0, 0}},
                            .radius = {0.5F, 0.5F, 0.5F},
                            .beam = {},
                            .crossing = {}};
  EXPECT_EQ(front_layer(g), (std::vector<std::int32_t>{1, 2}));
}

TEST(FrontLayer, WhatShowsBetweenElementsIsKept) {
  const results::Geometry g{.position = {{0, 0, 1}, {1, 0, 1}, {0.5F, 0.45F, 0}},
                            .radius = {0.5F, 0.5F, 0.5F},
                            .beam = {},
                            .crossing = {}};
  EXPECT_EQ(front_layer(g), (std::vector<std::int32_t>{0, 1, 2}));
}

TEST(FrontLayer, TheFacesOfTheCrackAreKeptForItsOpening) {
  const results::Geometry g{.position = {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 1, 1}},
                            .radius = {0.5F, 0.5F, 0.5F, 0.5F},
                            .beam = {{0, 2}},
                            .crossing = {0}};
  EXPECT_EQ(front_layer(g), (std::vector<std::int32_t>{0, 1, 2, 3}));
}

}  // namespace
}  // namespace rift::viz
