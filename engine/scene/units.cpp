#include "engine/scene/units.hpp"

#include "engine/scene/issue.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <span>
#include <vector>

namespace rift::scene {
namespace {

struct Kind {
  std::string_view operator()(bool) const { return "true or false"; }
  std::string_view operator()(std::int64_t) const { return "a whole number"; }
  std::string_view operator()(double) const { return "a number"; }
  std::string_view operator()(const std::string&) const { return "text"; }
  std::string_view operator()(const std::vector<Value>&) const { return "a list"; }
  std::string_view operator()(const Value::Other& other) const { return other.kind; }
};

struct Shown {
  std::string operator()(bool b) const { return b ? "true" : "false"; }
  std::string operator()(std::int64_t i) const { return fmt::format("{}", i); }
  std::string operator()(double d) const { return fmt::format("{}", d); }
  std::string operator()(const std::string& s) const { return '"' + printable(s) + '"'; }
  std::string operator()(const Value::Other& other) const { return '(' + other.kind + ')'; }
  std::string operator()(const std::vector<Value>& list) const {
    std::string out;
    for (const Value& value : list) {
      if (out.size() > 60) return '[' + out + ", ...]";
      out += (out.empty() ? "" : ", ") + shown(value);
    }
    return '[' + out + ']';
  }
};

}  // namespace

std::string_view kind_of(const Value& value) { return std::visit(Kind{}, value.held); }
std::string shown(const Value& value) { return std::visit(Shown{}, value.held); }

std::optional<double> number_in(const Value& value) {
  if (const auto* i = std::get_if<std::int64_t>(&value.held)) return static_cast<double>(*i);
  if (const auto* d = std::get_if<double>(&value.held)) return *d;
  return {};
}

std::string wrong_type(std::string_view expected, const Value& value) {
  const auto* text = std::get_if<std::string>(&value.held);
  return fmt::format("expected {}, got {}{}", expected, kind_of(value),
                     text && has_decimal_comma(*text) ? ": use a decimal point" : "");
}

namespace {

struct Unit {
  std::string_view name;
  int exponent;  // of ten, to SI
  bool written;  // used when we write; the others are only understood
};

// From large to small.
constexpr std::array lengths{Unit{"m", 0, true},   Unit{"cm", -2, false}, Unit{"mm", -3, true},
                             Unit{"um", -6, true}, Unit{"µm", -6, false}, Unit{"μm", -6, false},
                             Unit{"nm", -9, true}};
constexpr std::array times{Unit{"s", 0, true},    Unit{"ms", -3, true},  Unit{"us", -6, true},
                           Unit{"µs", -6, false}, Unit{"μs", -6, false}, Unit{"ns", -9, true}};
constexpr std::array pressures{Unit{"GPa", 9, true}, Unit{"MPa", 6, true}, Unit{"kPa", 3, true},
                               Unit{"Pa", 0, true}};
constexpr std::array speeds{Unit{"km/s", 3, false}, Unit{"m/s", 0, true}, Unit{"mm/s", -3, false}};
constexpr std::array densities{Unit{"g/cm3", 3, false}, Unit{"g/cm^3", 3, false}, Unit{"kg/m3", 0, true},
                               Unit{"kg/m^3", 0, false}};

constexpr std::array release_rates{Unit{"kJ/m2", 3, true},  Unit{"kJ/m^2", 3, false}, Unit{"J/m2", 0, true},
                                   Unit{"J/m^2", 0, false}, Unit{"N/mm", 3, false},   Unit{"N/m", 0, false}};

constexpr std::array forces{Unit{"kN", 3, true}, Unit{"N", 0, true}, Unit{"mN", -3, true}};
constexpr std::array stress_intensities{Unit{"MPa m1/2", 6, true}, Unit{"MPa m^1/2", 6, false},
                                        Unit{"Pa m1/2", 0, true}, Unit{"Pa m^1/2", 0, false}};

constexpr std::array strains{Unit{"m/m", 0, true},   Unit{"%", -2, true},     Unit{"mm/m", -3, true},
                             Unit{"um/m", -6, true}, Unit{"µm/m", -6, false}, Unit{"ue", -6, false},
                             Unit{"-", 0, false}};

struct DimensionRow {
  std::string_view name, si, example;
  std::span<const Unit> units;
};

DimensionRow row_of(Dimension dimension) {
  switch (dimension) {
    case Dimension::none:
      return {"a number", "", "0.5", {}};
    case Dimension::length:
      return {"a length", "m", "2 mm", lengths};
    case Dimension::time:
      return {"a time", "s", "0.47 ms", times};
    case Dimension::pressure:
      return {"a pressure", "Pa", "10 GPa", pressures};
    case Dimension::speed:
      return {"a speed", "m/s", "2200 m/s", speeds};
    case Dimension::density:
      return {"a density", "kg/m3", "667 kg/m3", densities};
    case Dimension::release_rate:
      return {"a release rate", "J/m2", "900 J/m2", release_rates};
    case Dimension::force:
      return {"a force", "N", "200 N", forces};
    case Dimension::stress_intensity:
      return {"a stress intensity", "Pa m1/2", "1.5 MPa m1/2", stress_intensities};
    case Dimension::strain:
      return {"a strain", "m/m", "500 um/m", strains};
  }
  std::abort();  // no such dimension
}

const char* end_of(std::string_view text) { return text.data() + text.size(); }

/// The number `digits` times ten to `shift`, rounded once. `digits` is a finite decimal number.
Parsed<double> shifted(std::string_view digits, int shift) {
  const auto e = digits.find_first_of("eE");
  int exponent = 0;
  if (e != std::string_view::npos) {
    std::string_view written = digits.substr(e + 1);
    if (written.starts_with('+')) written.remove_prefix(1);
    if (std::from_chars(written.data(), end_of(written), exponent).ec != std::errc{} ||
        std::abs(exponent) > 10000) {
      return {{}, "the number is too large or too small to be held"};
    }
  }
  const std::string text = fmt::format("{}e{}", digits.substr(0, e), exponent + shift);
  double value = 0.0;
  if (std::from_chars(text.data(), end_of(text), value).ec != std::errc{}) {
    return {{}, "the number is too large or too small to be held"};
  }
  return {value, {}};
}

/// The same with points for commas, short.
std::string with_points(std::string_view text) {
  std::string out = printable(text, 20);
  for (char& c : out)
    if (c == ',') c = '.';
  return out;
}

std::string unit_names(std::span<const Unit> units) {
  std::vector<std::string> names;
  for (const Unit& unit : units) {
    if (unit.written) names.emplace_back(unit.name);
  }
  return listed(names);
}

}  // namespace

std::string_view dimension_name(Dimension dimension) { return row_of(dimension).name; }
std::string_view si_unit(Dimension dimension) { return row_of(dimension).si; }
std::string_view example_quantity(Dimension dimension) { return row_of(dimension).example; }

std::string understood_units(Dimension dimension) {
  std::vector<std::string> names;
  for (const Unit& unit : row_of(dimension).units) names.emplace_back(unit.name);
  return listed(names, "and");
}

Parsed<double> read_quantity(std::string_view text, Dimension dimension) {
  const DimensionRow row = row_of(dimension);
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), end_of(text), number);
  if (error == std::errc::invalid_argument) {
    return {{}, fmt::format("expected {} such as \"{}\"", row.name, row.example)};
  }
  if (!std::isfinite(number)) return {{}, "must be a finite number"};
  if (has_decimal_comma(text))
    return {{}, fmt::format("use a decimal point, as in \"{}\"", with_points(text))};

  const std::string_view digits(text.data(), static_cast<std::size_t>(end - text.data()));
  const std::string_view name = trimmed(text.substr(digits.size()));
  if (name.empty()) return {{}, fmt::format("needs a unit: {}", unit_names(row.units))};
  for (const Unit& unit : row.units) {
    if (unit.name == name) return shifted(digits, unit.exponent);
  }
  return {
      {},
      fmt::format("unknown unit '{}' for {}: use {}", printable(name, 20), row.name, unit_names(row.units))};
}

std::string quantity_text(double si, Dimension dimension) {
  if (dimension == Dimension::none) return fmt::format("{}", si);
  const DimensionRow row = row_of(dimension);
  for (const Unit& unit : row.units) {
    if (!unit.written || std::abs(si) < std::pow(10.0, unit.exponent)) continue;
    // 15 digits name every short decimal; whether they name this very double is what the reading back asks.
    std::string text = fmt::format("{:.15g} {}", si * std::pow(10.0, -unit.exponent), unit.name);
    if (read_quantity(text, dimension).value == si) return text;
    break;
  }
  return fmt::format("{} {}", si, row.si);
}

std::string rounded_text(double si, Dimension dimension) {
  const std::string digits = fmt::format("{:.6g}", si);
  double rounded = si;
  std::from_chars(digits.data(), end_of(digits), rounded);
  return quantity_text(rounded, dimension);
}

std::string in_mm(double metres) { return fmt::format("{:.4g} mm", 1e3 * metres); }

}  // namespace rift::scene
