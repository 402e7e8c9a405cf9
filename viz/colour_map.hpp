#pragma once

#include "viz/field.hpp"

#include <array>
#include <span>
#include <string_view>
#include <vector>

/// Colour maps that are perceptually uniform and read by the colour-blind.
namespace rift::viz {

using Colour = std::array<double, 3>;  // sRGB, 0 to 1

/// A map by colours at equal distances.
struct ColourMap {
  std::string_view name;
  Scale scale;
  std::string_view source;
  std::vector<std::uint32_t> stops;  // 0xRRGGBB
};

[[nodiscard]] const std::vector<ColourMap>& colour_maps();

/// The map of a name, or null.
[[nodiscard]] const ColourMap* find_colour_map(std::string_view name);

/// The map that a field has where the user names none.
[[nodiscard]] const ColourMap& colour_map_of(const Field& field);

/// The colour at x in [0, 1], linear between the stops; beyond the ends the ends' colours.
[[nodiscard]] Colour colour_at(const ColourMap& map, double x);

}  // namespace rift::viz
