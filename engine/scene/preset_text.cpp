#include "engine/scene/parameters.hpp"
#include "engine/scene/preset.hpp"
#include "engine/scene/scenarios.hpp"
#include "engine/scene/values_text.hpp"

#include <fmt/format.h>

namespace rift::scene {
namespace {

/// Rows of numbers one below the other where there are many: for the eye, and because a reader of presets
/// takes a line of very many dots for a hostile key.
std::string in_lines(std::string value) {
  constexpr std::size_t wide = 100;
  if (!value.starts_with("[[") || value.size() <= wide) return value;
  std::string out = "[\n  ";
  for (std::size_t from = 1;;) {
    const std::size_t next = value.find("], [", from);
    if (next == std::string::npos) return out + value.substr(from, value.size() - 1 - from) + ",\n]";
    out += value.substr(from, next + 1 - from) + ",\n  ";
    from = next + 3;
  }
}

/// One line per axis that the scene has a value for; what is left out is the base's when it is read.
std::string axis_lines(const Scene& scene, const std::vector<const Axis*>& varied) {
  std::string out;
  for (const Axis* axis : varied) {
    const std::string value = toml_value(scene, parameter_of(*axis));
    if (applies(scene, *axis) && !value.empty()) out += fmt::format("{} = {}\n", axis->name, in_lines(value));
  }
  return out;
}

/// The axes in which some lane differs from the base; never none, for a table without any is a mistake.
std::vector<const Axis*> varied_in_lanes(const Preset& preset) {
  std::vector<const Axis*> varied;
  for (const Axis& axis : axes()) {
    const Parameter& row = parameter_of(axis);
    const std::string base = toml_value(preset.scene, row);
    bool differs = false;
    for (const Scene& lane : preset.lanes) differs = differs || toml_value(lane, row) != base;
    if (differs) varied.push_back(&axis);
  }
  if (varied.empty()) varied.push_back(find_axis("technique"));
  return varied;
}

}  // namespace

std::string preset_text(const Scene& scene) {
  std::string out = "# The effective preset; docs/parameters.md says more.\n";
  std::string table;
  for (const Parameter& row : parameters()) {
    if (!is_used(scene, row)) continue;
    if (table_of(row) != table) {
      table = table_of(row);
      out += fmt::format("\n[{}]\n", table);
    }
    const std::string value = value_that_counts(scene, row);
    out += fmt::format("# {} Allowed: {}.\n", row.doc, allowed(row));
    out += value.empty() ? fmt::format("# {} is not given\n", name_of(row))
                         : fmt::format("{} = {}\n", name_of(row), in_lines(value));
  }
  return out;
}

std::string preset_text(const Preset& preset) {
  std::string out = preset_text(preset.scene);
  const std::vector<const Axis*> in_lanes = varied_in_lanes(preset);
  for (const Scene& lane : preset.lanes) out += "\n[[lanes]]\n" + axis_lines(lane, in_lanes);
  if (!preset.grid.empty()) out += "\n[study]\n";
  for (const GridAxis& axis : preset.grid)
    out += fmt::format("{} = [{}]\n", axis.name, fmt::join(axis.values, ", "));
  for (const StudyRow& row : preset.study) {
    if (!row.combinations.empty()) continue;  // of the grid
    std::vector<const Axis*> varied;
    for (const auto& [name, text] : row.axes) varied.push_back(find_axis(name));
    out += "\n[[study.rows]]\n" + axis_lines(row.scene, varied);
  }
  return out + steering_text(preset.steering);
}

namespace {

constexpr std::string_view opening = R"(# Parameters

<!-- Made from the parameter table (engine/scene/parameters.cpp); a test keeps it up to date. -->

A preset is a TOML file with the tables below; a missing key has its default.
Any key can be set on the command line by its full name: `--set crack.velocity='0.3 c_r'`.
`--set` replaces the value of that key in the preset and removes the keys that it excludes, with a note: `--set specimen.thickness='3 mm'` replaces `layers` of the preset.
`rift run PRESET --print-config` prints the effective preset.

The thickness of a plate follows from `layers`: B = 2 mm (20,000/N · LH/(200 mm · 40 mm))^½ (layers/2)^(3/2). Another number of elements is therefore another specimen, whose forces and energies grow with its thickness: 5,000 elements make the plate of 20,000 twice as thick. Where `--set` or an axis of a study changes a thickness in this way, a note says so with both numbers. Plates of one thickness, as in a study of convergence, have `thickness` in place of `layers`.

Quantities are numbers in SI units or text with a unit:

| quantity | units |
|---|---|
)";

constexpr std::string_view crack_words = R"(
The velocity of the crack always carries its unit, `c_r` (the Rayleigh speed) or a unit of speed; a bare number is an error.
The path is straight at a height, a fraction of it (`"0.5 H"`) or a length; or goes through points, a list `[["0 mm", "20 mm"], ["80 mm", "30 mm"]]` or a CSV file.

`history`, `path`, `toughness` and `loading.curve` take a list of rows or the name of a CSV file, whose path is relative to the preset's folder (with `--set`: to the working folder). Its header names columns and units:

| key | columns |
|---|---|
| `history` | `time`, `position`, and where it is known the standard `uncertainty` of the position |
| `path` | `x`, `y` |
| `toughness` | `velocity` (`c_r` or a speed) or `position`, and `release_rate` |
| `loading.curve` | `time`, and `displacement` or `force` |

Files are read as spreadsheets, cameras and instruments write them: UTF-8 with or without a byte order mark, lines ended as on Unix or Windows, columns separated by semicolons, tabs, commas or bars (or as given in a first line `sep=;`), cells in quotes, separators at the end of lines. Names are case-insensitive; a unit stands in brackets (`Time [us]`, `time (us)`), behind a slash (`t / µs`), behind an underscore (`time_us`), or in the row below. Up to 100 lines before the header, unknown columns, lines that begin with `#` and empty rows are ignored. Numbers have a decimal point, and times count from near 0: a decimal comma, a time of day, a time stamp and another encoding are reported once, with the remedy. A file holds at most 64 MiB and 100,000 rows (a path 10,000; a curve of `rift measure --against` 1,000,000).

The effective preset of a run holds the rows themselves. Rows are not sorted, filled in or dropped: each defect is an error with file and line; frames that seem to be missing, and a path that crosses itself, give a note.
)";

constexpr std::string_view scenario_words = R"(
## Studies and lanes

A preset may ask for many scenarios. Each is the preset's scene with other values of some axes, checked like the keys themselves.

`[study]` has one list of values per axis and stands for all their combinations, the first list varying slowest.
Combinations that are physically the same scenario are computed once: with `technique = "simple"` there is no damage zone, so `relaxation` and `damage_zone_ratio` do not apply; without a damped region `damping_alpha` is 0, and with `damping_alpha = 0` there is no damped region.
`[[study.rows]]` lists single scenarios, a table each; axes that a row does not name are as in the preset. They follow the grid.

```toml
[study]
technique = ["simple", "progressive"]
damage_zone_ratio = [1, 2, 4]
crack_velocity = ["0.3 c_r", "0.6 c_r"]

[[study.rows]]
relaxation = "quadratic"
layers = 2
```

These are eight scenarios of the grid (two simple, six progressive) and one more.

`[[lanes]]` are scenarios that run at once as one ensemble, a table each. They share one lattice and one time step and may differ in the axes marked below only.

```toml
[[lanes]]
technique = "simple"

[[lanes]]
damage_zone_ratio = 4
```

A preset has a study or lanes, not both. `--set` changes the scene that they start from; for a key that they vary it is an error. `--set 'study.seed=[1, 2]'` puts another list in the place of an axis of `[study]`, or adds the axis. Two rows or two lanes with the same scenario are an error as well.

`[[steering]]` changes a lane of a run while its crack runs: a table each, with the `lane` (from 0; 0 where it is not named), the `step` of that lane after which the change is made, and one or more of `technique`, `relaxation`, `damage_zone_ratio`, `damping_alpha` and `crack_velocity`. The workbench writes such tables (`steering.toml`); beams that the damage zone has already reached keep their law.

```toml
[[steering]]
step = 1200
damage_zone_ratio = 6
crack_velocity = "0.3 c_r"
```

| axis | key | lanes may differ |
|---|---|---|
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
  for (const Dimension d : {Dimension::length, Dimension::time, Dimension::pressure, Dimension::speed,
                            Dimension::density, Dimension::release_rate, Dimension::force}) {
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
  out += scenario_words;
  for (const Axis& axis : axes())
    out += fmt::format("| `{}` | `{}` | {} |\n", axis.name, axis.key, axis.per_lane ? "yes" : "no");
  return out;
}

}  // namespace rift::scene
