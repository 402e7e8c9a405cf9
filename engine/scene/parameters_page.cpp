#include "engine/scene/parameters_page.hpp"

#include "engine/scene/parameters.hpp"

#include <fmt/format.h>

namespace rift {

namespace {

constexpr std::string_view opening = R"(# Parameters

<!-- Made from the parameter table (engine/scene/parameters.cpp); a test keeps it up to date. -->

A preset is a TOML file with the tables below; a key that is not there has its default.
Any key can be set on the command line by its full name: `--set crack.velocity='0.3 c_r'`.
`--set` replaces what the preset says of that key, and only that: `--set specimen.thickness='3 mm'` on a preset with `layers` is a contradiction.
`rift run PRESET --print-config` prints the effective preset.

Quantities are numbers in SI units or text with a unit:

| quantity | units |
|---|---|
)";

constexpr std::string_view crack_words = R"(
The velocity of the crack always carries its unit, `c_r` (the Rayleigh speed) or a unit of speed; a bare number is an error.
The path is a fraction of the height (`"0.5 H"`) or a length.
)";

/// The text inside a cell of a table.
std::string cell(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
  return out;
}

}  // namespace

std::string parameters_markdown() {
  const Scene standard = default_scene();
  std::string out(opening);
  for (const Dimension d :
       {Dimension::length, Dimension::time, Dimension::pressure, Dimension::speed, Dimension::density}) {
    out +=
        fmt::format("| {} | {} |\n", dimension_name(d).substr(2), understood_units(d));  // without its "a "
  }
  out += crack_words;
  std::string table;
  for (const Parameter& row : parameters()) {
    if (table_of(row) != table) {
      table = table_of(row);
      out += fmt::format("\n## [{}]\n\n| key | default | allowed | meaning |\n|---|---|---|---|\n", table);
    }
    const std::string value = toml_value(standard, row);
    out += fmt::format("| `{}` | {} | {} | {} |\n", name_of(row),
                       value.empty() ? "none" : '`' + cell(value) + '`', cell(allowed(row)), cell(row.doc));
  }
  return out;
}

}  // namespace rift
