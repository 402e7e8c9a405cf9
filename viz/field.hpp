#pragma once

#include "engine/results/schema.hpp"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rift::viz {

// What the colours of a picture tell: a number per element, computed from the stored fields of a frame.

/// How the colours run from one end of the range to the other.
enum class Scale : std::uint8_t {
  diverging,   // about zero
  sequential,  // from zero upwards
};

struct Field {
  std::string_view name;   // "uy", as the user asks for it
  std::string_view title;  // "vertical displacement"
  std::string_view unit;   // "mm", as it is shown
  double unit_in_si;       // 1e-3
  Scale scale;
  std::string_view stored;  // the entry of output.fields that it needs: "displacement", ...
};

/// All fields: ux, uy, uz, u (magnitude), vx, vy, vz, v, kinetic and elastic (energy densities of the plate,
/// J/m³), damage.
[[nodiscard]] const std::vector<Field>& fields();

/// The field of a name, or null.
[[nodiscard]] const Field* find_field(std::string_view name);

/// The field's value at each element, in SI. @param header  of the run; densities need what it says of the
/// elements Empty where the frame does not hold what the field needs. Cost O(elements).
[[nodiscard]] std::vector<float> values_of(const Field& field, const results::Frame& frame,
                                           const results::Geometry& geometry,
                                           const nlohmann::ordered_json& header);

/// The range that is known before anything was computed: half the grip's displacement each way for uy, [0, 1]
/// for damage.
[[nodiscard]] std::optional<std::array<double, 2>> known_range(const Field& field,
                                                               const nlohmann::ordered_json& header);

/// The range of these values [SI] without the outermost hundredth, rounded up: symmetric about zero for a
/// diverging scale, from zero for a sequential one. @param values  of one or several frames; reordered
[[nodiscard]] std::array<double, 2> range_of(const Field& field, std::vector<float>& values);

// Colour maps that are perceptually uniform and read by the colour-blind.

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
