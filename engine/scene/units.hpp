#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rift::scene {

/// A value as the user wrote it, before it means anything: what TOML knows, without the TOML library.
struct Value {
  /// Something no parameter takes: "a table", "a date", "a time".
  struct Other {
    std::string kind;
  };
  std::variant<bool, std::int64_t, double, std::string, std::vector<Value>, Other> held;
};

/// "text", "a whole number", "a number", "true or false", "a list", "a table", ...
std::string_view kind_of(const Value& value);

/// The value on one short line as a message shows it: "5 c_r" with its quotes, [0.2, 0.4], nan.
std::string shown(const Value& value);

/// A bare number, whole or not.
std::optional<double> number_in(const Value& value);

/// "expected a list, got text".
std::string wrong_type(std::string_view expected, const Value& value);

enum class Dimension {
  none,
  length,
  time,
  pressure,
  speed,
  density,
  release_rate,
  force,
  stress_intensity,
  strain
};

/// What was read, or what is wrong with the text.
template <class T>
struct Parsed {
  std::optional<T> value;
  std::string problem;
};

/// "a length", "a time", ... for messages.
std::string_view dimension_name(Dimension dimension);

/// The SI unit: "m", "s", "Pa", "m/s", "kg/m3", ...; empty for Dimension::none.
std::string_view si_unit(Dimension dimension);

/// Every unit that is understood, "m, cm, mm, ..."; the spellings with a Greek letter for micro among them.
std::string understood_units(Dimension dimension);

/// A text that would be read: "2 mm", "0.47 ms", "10 GPa", ...
std::string_view example_quantity(Dimension dimension);

/// Reads a number with a unit ("2 mm", "10 GPa", "667 kg/m3") into SI.
/// All units are powers of ten and shift the decimal exponent before the number is rounded, so that "0.47 ms"
/// is the double nearest to 0.00047 and no factor adds an error. NaN, infinities and a missing unit are
/// problems.
/// @param dimension  any but none
Parsed<double> read_quantity(std::string_view text, Dimension dimension);

/// Readable text which read_quantity turns into exactly `si` again: 0.002 m is "2 mm"; where no short text
/// does, the SI number with its unit. For Dimension::none the number alone.
std::string quantity_text(double si, Dimension dimension);

/// As quantity_text with six digits, for messages about computed lengths and speeds.
std::string rounded_text(double si, Dimension dimension);

/// A computed length [m] in a sentence: "2.828 mm".
std::string in_mm(double metres);

}  // namespace rift::scene
