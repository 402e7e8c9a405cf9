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
      {"damage", "damage of the beams on the crack's path", "1", 1, Scale::sequential, "damage"},
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

}  // namespace rift::viz
