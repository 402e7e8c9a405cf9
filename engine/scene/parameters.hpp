#pragma once

#include "engine/scene/scene.hpp"
#include "engine/scene/units.hpp"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rift::scene {

/// The allowed numbers, in SI.
struct Range {
  double lower = 0.0, upper = 0.0;
  bool lower_open = false, upper_open = false;
};

/// A member that is a relaxation exponent: a number that may also be given by name.
struct Exponent {
  double* p;
};

/// A member that is one of the row's words, by its name; or any text where the row has none.
struct Word {
  std::string* p;
};

/// Where a parameter lives in a Scene. The kind of the member decides how its text is read and written.
using Slot = std::variant<double*, std::optional<double>*, int*, long*, bool*, Word, Exponent,
                          packing::Shape*, packing::Radii*, theory::Plane*, StiffnessChoice*, LoadingMethod*,
                          GripRotation*, fracture::Technique*, fracture::ReleaseOrder*,
                          fracture::FractureLaw*, DampingRegion*, lattice::Kinematics*, ensemble::Precision*,
                          ReleaseRateReference*, std::vector<VelocityPiece>*, CrackLine*,
                          std::vector<history::HistoryPoint>*, fracture::CriticalRate*, LoadCurve*,
                          history::Smoothing*, PathShape*, std::vector<std::string>*, std::vector<double>*,
                          std::vector<std::array<double, 2>>*, std::optional<std::array<double, 2>>*>;

/// One row of the table: all that is known of one member of Scene.
struct Parameter {
  std::string_view key;       // "specimen.length": table and name
  std::string_view standard;  // the default as --set would take it; empty for none
  Slot (*slot)(Scene&);
  std::string_view doc;                        // one line
  Dimension dimension = Dimension::none;       // of numbers
  Range range = {};                            // of numbers
  std::vector<std::string_view> choices = {};  // the words of an enum in its order, or of a list of words
};

/// THE parameter table, in the order in which a preset is written. It gives reading, checking, --set,
/// --print-config and docs/parameters.md.
std::span<const Parameter> parameters();

/// The row of a full key, or null.
const Parameter* find_parameter(std::string_view key);

/// "specimen" and "length" of "specimen.length".
std::string table_of(const Parameter& row);
std::string name_of(const Parameter& row);

/// Every parameter at its default.
Scene default_scene();

/// Checks `value` against the row and stores it in the scene.
/// @return what is wrong with it (the scene is then as before), or empty
std::string assign(Scene& scene, const Parameter& row, const Value& value);

/// The member's present value as TOML, so that assign() reads it back to the same bits; empty where it is
/// absent.
std::string toml_value(const Scene& scene, const Parameter& row);

/// The word of an enum's value; the choices of its row stand in the enum's order.
template <class Enum>
std::string word_of(std::string_view key, Enum value) {
  return std::string(find_parameter(key)->choices.at(static_cast<std::size_t>(value)));
}

/// "(0, 100] m", "\"static\" or \"ramp\"", ...: what the row allows.
std::string allowed(const Parameter& row);

}  // namespace rift::scene
