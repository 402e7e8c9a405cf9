#include "viz/colour_map.hpp"

#include <algorithm>

namespace rift::viz {
namespace {

Colour rgb(std::uint32_t hex) {
  return {((hex >> 16) & 255) / 255.0, ((hex >> 8) & 255) / 255.0, (hex & 255) / 255.0};
}

}  // namespace

const std::vector<ColourMap>& colour_maps() {
  static const std::vector<ColourMap> all{
      {"coolwarm",
       Scale::diverging,
       "Moreland 2009",
       {0x3b4cc0, 0x6282ea, 0x8db0fe, 0xb8d0f9, 0xdddddd, 0xf5c4ad, 0xf49a7b, 0xde604d, 0xb40426}},
      {"vik",
       Scale::diverging,
       "Crameri 2018",
       {0x001261, 0x033e7d, 0x1e6f9d, 0x71a8c4, 0xc9dde7, 0xeacebd, 0xd39774, 0xbe6533, 0x8b2706, 0x590008}},
      {"viridis",
       Scale::sequential,
       "Smith and van der Walt 2015",
       {0x440154, 0x482475, 0x414487, 0x355f8d, 0x2a788e, 0x21918c, 0x22a884, 0x44bf70, 0x7ad151, 0xbddf26,
        0xfde725}},
      {"inferno",
       Scale::sequential,
       "Smith and van der Walt 2015",
       {0x000004, 0x160b39, 0x420a68, 0x6a176e, 0x932667, 0xbc3754, 0xdd513a, 0xf37819, 0xfca50a, 0xf6d746,
        0xfcffa4}},
      {"cividis",
       Scale::sequential,
       "Nuñez, Anderton and Renslow 2018",
       {0x00224e, 0x123570, 0x3b496c, 0x575d6d, 0x707173, 0x8a8678, 0xa59c74, 0xc3b369, 0xe1cc55, 0xfee838}},
  };
  return all;
}

const ColourMap* find_colour_map(std::string_view name) {
  const auto it = std::find_if(colour_maps().begin(), colour_maps().end(),
                               [&](const ColourMap& m) { return m.name == name; });
  return it == colour_maps().end() ? nullptr : &*it;
}

const ColourMap& colour_map_of(const Field& field) {
  return *find_colour_map(field.scale == Scale::diverging ? "coolwarm" : "viridis");
}

Colour colour_at(const ColourMap& map, double x) {
  const double last = static_cast<double>(map.stops.size() - 1), at = std::clamp(x, 0.0, 1.0) * last;
  const auto k = std::min(static_cast<std::size_t>(at), map.stops.size() - 2);
  const double part = at - static_cast<double>(k);
  const Colour a = rgb(map.stops[k]), b = rgb(map.stops[k + 1]);
  return {a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1]), a[2] + part * (b[2] - a[2])};
}

}  // namespace rift::viz
