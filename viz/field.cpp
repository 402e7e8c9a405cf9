#include "viz/field.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rift::viz {
namespace {

using Header = nlohmann::ordered_json;
using Vectors = std::vector<std::array<float, 3>>;

std::vector<float> component(const Vectors& vectors, int axis) {
  std::vector<float> values;
  values.reserve(vectors.size());
  for (const auto& v : vectors) values.push_back(v[axis]);
  return values;
}

std::vector<float> magnitude(const Vectors& vectors) {
  std::vector<float> values;
  values.reserve(vectors.size());
  for (const auto& v : vectors) values.push_back(std::hypot(v[0], v[1], v[2]));
  return values;
}

/// An element's share of the plate's volume is that of its sphere over the solid fraction, so that a density
/// adds up to the plate's energy.
double share_of_plate(float radius, double solid_fraction) {
  const double r = radius;
  return 4.0 / 3.0 * std::numbers::pi * r * r * r / solid_fraction;
}

/// 1/2 m v² of an element over its share of the plate [J/m³]: masses are volumes times one density, so that
/// is left.
std::vector<float> kinetic(const Vectors& velocity, const Header& header) {
  const double half_density = 0.5 * header.at("density_kg_m3").get<double>();
  std::vector<float> values;
  values.reserve(velocity.size());
  for (const auto& v : velocity)
    values.push_back(static_cast<float>(half_density * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2])));
  return values;
}

std::vector<float> elastic(const std::vector<float>& energy, const results::Geometry& geometry,
                           const Header& header) {
  const double solid = header.at("solid_fraction").get<double>();
  std::vector<float> values;
  values.reserve(energy.size());
  for (std::size_t i = 0; i < energy.size(); ++i)
    values.push_back(static_cast<float>(energy[i] / share_of_plate(geometry.radius[i], solid)));
  return values;
}

/// The least factor of an element's beams on the path, as damage 1 - factor; 0 away from the path.
std::vector<float> damage(const std::vector<float>& factor, const results::Geometry& geometry) {
  std::vector<float> values(geometry.position.size(), 0.0F);
  for (std::size_t k = 0; k < factor.size(); ++k)
    for (const std::int32_t i : geometry.beam[geometry.crossing[k]])
      values[i] = std::max(values[i], 1 - factor[k]);
  return values;
}

/// Up to a number whose quarters are short.
double rounded_up(double x) {
  if (x <= 0) return 0;
  const double decade = std::pow(10.0, std::floor(std::log10(x)));
  for (const double step : {1.0, 1.2, 1.6, 2.0, 2.4, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (x <= step * decade * (1 + 1e-6)) return step * decade;
  return 10 * decade;
}

}  // namespace

const std::vector<Field>& fields() {
  static const std::vector<Field> all{
      {"ux", "displacement along the crack", "mm", 1e-3, Scale::diverging, "displacement"},
      {"uy", "vertical displacement", "mm", 1e-3, Scale::diverging, "displacement"},
      {"uz", "out-of-plane displacement", "µm", 1e-6, Scale::diverging, "displacement"},
      {"u", "displacement", "mm", 1e-3, Scale::sequential, "displacement"},
      {"vx", "velocity along the crack", "m/s", 1, Scale::diverging, "velocity"},
      {"vy", "vertical velocity", "m/s", 1, Scale::diverging, "velocity"},
      {"vz", "out-of-plane velocity", "m/s", 1, Scale::diverging, "velocity"},
      {"v", "velocity", "m/s", 1, Scale::sequential, "velocity"},
      {"kinetic", "kinetic energy density", "MJ/m³", 1e6, Scale::sequential, "velocity"},
      {"elastic", "elastic energy density", "MJ/m³", 1e6, Scale::sequential, "energy"},
      {"damage", "damage of the beams", "1", 1, Scale::sequential, "damage"},
  };
  return all;
}

const Field* find_field(std::string_view name) {
  const auto it =
      std::find_if(fields().begin(), fields().end(), [&](const Field& f) { return f.name == name; });
  return it == fields().end() ? nullptr : &*it;
}

std::vector<float> values_of(const Field& field, const results::Frame& frame,
                             const results::Geometry& geometry, const Header& header) {
  if (field.name == "u") return magnitude(frame.displacement);
  if (field.name == "v") return magnitude(frame.velocity);
  if (field.name == "kinetic") return kinetic(frame.velocity, header);
  if (field.name == "elastic") return elastic(frame.elastic_energy, geometry, header);
  if (field.name == "damage")
    return frame.damage_factor.empty() ? std::vector<float>{} : damage(frame.damage_factor, geometry);
  const Vectors& vectors = field.stored == "displacement" ? frame.displacement : frame.velocity;
  return component(vectors, field.name.back() - 'x');
}

std::optional<std::array<double, 2>> known_range(const Field& field, const Header& header) {
  if (field.name == "damage") return std::array{0.0, 1.0};
  if (field.name != "uy" || !header.contains("displacement_m")) return std::nullopt;
  return std::array{0.0, header.at("displacement_m").get<double>()};
}

std::array<double, 2> range_of(const Field& field, std::vector<float>& values) {
  if (values.empty()) return {0, 0};
  for (float& v : values) v = std::abs(v);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  const double most = rounded_up(*at);
  return {field.scale == Scale::diverging ? -most : 0.0, most};
}

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
