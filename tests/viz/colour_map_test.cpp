#include "tests/expectations.hpp"
#include "viz/field.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rift::viz {
namespace {

/// Lightness L* of CIELAB, of an sRGB colour.
double lightness(const Colour& c) {
  const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  const double y = 0.2126 * linear(c[0]) + 0.7152 * linear(c[1]) + 0.0722 * linear(c[2]);
  return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

TEST(ColourMap, ASequentialOneGetsLighterEvenly) {
  int sequential = 0;
  for (const ColourMap& map : colour_maps()) {
    if (map.scale != Scale::sequential) continue;
    ++sequential;
    const double span = lightness(colour_at(map, 1)) - lightness(colour_at(map, 0));
    for (double x = 0; x < 0.95; x += 0.1) {
      const double step = lightness(colour_at(map, x + 0.1)) - lightness(colour_at(map, x));
      EXPECT_GT(step, 0.04 * span) << map.name << " at " << x;
      EXPECT_LT(step, 0.18 * span) << map.name << " at " << x;
    }
  }
  EXPECT_GT(sequential, 0);
}

TEST(ColourMap, ADivergingOneIsLightestInItsMiddleAndItsEndsDifferInBlueAndRed) {
  int diverging = 0;
  for (const ColourMap& map : colour_maps()) {
    if (map.scale != Scale::diverging) continue;
    ++diverging;
    const Colour low = colour_at(map, 0), high = colour_at(map, 1);
    EXPECT_GT(low[2], high[2]) << map.name;
    EXPECT_GT(high[0], low[0]) << map.name;
    for (double x = 0; x < 0.45; x += 0.1) {
      EXPECT_GT(lightness(colour_at(map, x + 0.1)), lightness(colour_at(map, x))) << map.name << " at " << x;
      EXPECT_GT(lightness(colour_at(map, 0.9 - x)), lightness(colour_at(map, 1 - x)))
          << map.name << " at " << x;
    }
  }
  EXPECT_GT(diverging, 0);
}

TEST(ColourMap, ItsStopsAreItsColours) {
  const ColourMap& viridis = *find_colour_map("viridis");
  EXPECT_NEAR(colour_at(viridis, 0)[2], 0x54 / 255.0, 1e-12);
  EXPECT_NEAR(colour_at(viridis, 0.5)[1], 0x91 / 255.0, 1e-12);
  EXPECT_NEAR(colour_at(viridis, 1)[0], 0xfd / 255.0, 1e-12);
  EXPECT_EQ(colour_at(viridis, -3), colour_at(viridis, 0));
}

TEST(ColourMap, EveryFieldHasOneOfItsScale) {
  for (const Field& field : not_empty(fields())) EXPECT_EQ(colour_map_of(field).scale, field.scale);
}

}  // namespace
}  // namespace rift::viz
