#include "engine/scene/preset.hpp"

#include "engine/scene/issue.hpp"
#include "engine/scene/layers_note.hpp"
#include "engine/scene/parameters.hpp"
#include "engine/scene/rows_file.hpp"
#include "engine/scene/scenario.hpp"
#include "engine/scene/scenarios.hpp"
#include "engine/scene/thickness_note.hpp"
#include "engine/scene/toml_text.hpp"
#include "engine/scene/validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

namespace rift::scene {
namespace {

constexpr std::size_t most_nearest_names = 100;  // that are looked for in a file without one right key

/// A value that somebody gave to a known parameter.
struct Given {
  const Parameter* row;
  Value value;
  Origin origin;
};

struct Reading {
  Preset preset;
  TomlDocument document;
  std::vector<Given> given;
  std::vector<Given> replaced = {};    // what the preset says of keys that --set gives
  std::set<std::string> invalid = {};  // keys with an issue of their own
  std::filesystem::path folder = {};   // of the preset, from which its files are found

  void say(Issue issue) { preset.issues.push_back(std::move(issue)); }
};

/// What a [[name]] is.
bool is_list_of_tables(const Value& value) {
  const auto* list = std::get_if<std::vector<Value>>(&value.held);
  return list && !list->empty() && kind_of(list->front()) == "a table";
}

void take_entry(Reading& reading, const TomlEntry& entry) {
  const std::string key = entry.table + '.' + entry.name;
  if (const Parameter* row = find_parameter(key)) {
    reading.given.push_back({row, entry.value, {reading.preset.name, entry.line, shown(entry.value)}});
    return;
  }
  if (entry.table.empty() && is_table(entry.name)) {
    const std::string got = fmt::format("expected a table [{}], got {}", entry.name, kind_of(entry.value));
    reading.say({reading.preset.name, entry.line, entry.name, got, shown(entry.value)});
    return;
  }
  const bool as_table = entry.table.empty() && is_list_of_tables(entry.value);
  if (reading.preset.issues.size() >= most_nearest_names)
    return reading.say({reading.preset.name, entry.line, "", "unknown key " + printable(entry.name)});
  reading.say({reading.preset.name, entry.line, "",
               as_table ? unknown_table(entry.name) : unknown_key(entry.table, entry.name)});
}

void take_text(Reading& reading, std::string_view text) {
  reading.document = read_toml(text);
  const TomlDocument& document = reading.document;
  if (document.error) {
    const TomlError& e = *document.error;
    reading.say({reading.preset.name, e.line, "", e.text, "", e.column});
    return;
  }
  for (const TomlTable& table : document.tables) {
    if (!is_table(table.name) && !is_scenario_table(table.name))
      reading.say({reading.preset.name, table.line, "", unknown_table(table.name)});
  }
  for (const TomlEntry& entry : document.entries) {
    const bool of_scenarios = entry.table.empty() && is_scenario_table(entry.name);
    if (!of_scenarios && (entry.table.empty() || is_table(entry.table))) take_entry(reading, entry);
  }
}

/// Puts other lists in the place of [study]; where there is none, as if they stood at the end of the file.
void replace_grid(TomlDocument& document, const std::vector<GridAxis>& grid, int end) {
  const int begin = first_line(document, "study"), line = begin > 0 ? begin : end;
  std::erase_if(document.entries,
                [](const TomlEntry& entry) { return entry.table == "study" && entry.name != "rows"; });
  std::erase_if(document.tables, [](const TomlTable& table) { return table.name == "study"; });
  if (!grid.empty()) document.tables.push_back({"study", line});
  for (const GridAxis& axis : grid) {
    std::vector<Value> values;
    for (const std::string& text : axis.values) values.push_back(value_from_text(text));
    document.entries.push_back({"study", axis.name, {std::move(values)}, line});
  }
}

/// What the preset says of the keys that an override excludes gives way to it.
void drop_rivals(Reading& reading, const std::string& key) {
  for (const std::string& rival : rivals_of(key))
    std::erase_if(reading.given, [&](const Given& given) {
      if (given.row->key != rival || given.origin.file == "--set") return false;
      reading.preset.notes.push_back(fmt::format("--set {} replaces {} = {} ({}:{})", key, rival,
                                                 given.origin.value, given.origin.file, given.origin.line));
      return true;
    });
}

/// One --set study.AXIS=LIST: takes the place of the axis' list in [study], or adds the axis as the last.
void take_axis(Reading& reading, const std::string& key, std::string_view written) {
  const std::string name = key.substr(key.find('.') + 1);
  TomlDocument& document = reading.document;
  if (!find_axis(name))
    return reading.say({"--set", 0, printable(key), unknown_axis(name), printable(written)});
  if (const int lanes = first_line(document, "lanes"); lanes > 0)
    return reading.say(
        {"--set", 0, key,
         fmt::format("a preset has lanes or a study, and this one has [[lanes]] (line {})", lanes),
         printable(written)});
  const auto is_axis = [&](const TomlEntry& e) { return e.table == "study" && e.name == name; };
  const auto found = std::find_if(document.entries.begin(), document.entries.end(), is_axis);
  TomlEntry entry{"study", name, value_from_text(written)};
  if (found == document.entries.end())
    document.entries.push_back(std::move(entry));
  else
    *found = std::move(entry);
}

/// One --set: takes the place of what was given for its key before, and of the preset's for its rivals.
void take_override(Reading& reading, std::string_view text) {
  const auto equals = text.find('=');
  if (equals == std::string_view::npos) {
    reading.say({"--set", 0, printable(text), "expected key=value"});
    return;
  }
  const std::string key(trimmed(text.substr(0, equals)));
  const std::string_view written = trimmed(text.substr(equals + 1));
  if (key.starts_with("study.")) return take_axis(reading, key, written);
  const Parameter* row = find_parameter(key);
  if (!row) {
    reading.say({"--set", 0, printable(key), unknown_key("", key), printable(written)});
    return;
  }
  std::erase_if(reading.given, [&](const Given& earlier) {
    if (earlier.row != row) return false;
    if (earlier.origin.file != "--set") reading.replaced.push_back(earlier);
    return true;
  });
  drop_rivals(reading, key);
  reading.given.push_back({row, value_from_text(written), {"--set", 0, printable(written)}});
}

/// What is given takes the place of the default that excludes it.
void drop_excluded_defaults(Preset& preset) {
  const auto given = [&](const char* key) { return preset.origins.contains(key); };
  const bool has_layers =
      preset.scene.specimen.shape == packing::Shape::plate && !given("specimen.thickness");
  if (!has_layers && !given("specimen.layers")) preset.scene.specimen.layers.reset();
  if (given("material.density") && !given("material.rayleigh_speed"))
    preset.scene.material.rayleigh_speed.reset();
  Scene::Crack& crack = preset.scene.crack;
  if (!crack.history.empty() && !given("crack.start")) crack.start = crack.history.front().position;
}

/// Puts a file's rows in the place of its name.
/// @return whether they can be had
bool take_rows(Reading& reading, Given& given) {
  if (!names_rows_file(*given.row, given.value)) return true;
  const bool here = given.origin.file == "--set";
  RowsFile read = read_rows_file(*given.row, std::get<std::string>(given.value.held),
                                 here ? std::filesystem::path{} : reading.folder);
  for (Issue& issue : read.issues) {
    if (issue.line > 0)
      reading.say(std::move(issue));
    else
      reading.say(issue_at(reading.preset, std::string(given.row->key), to_text(issue)));
  }
  given.value = std::move(read.rows);
  reading.preset.rows[std::string(given.row->key)] = std::move(read.origin);
  return read.issues.empty();
}

void assign_all(Reading& reading) {
  reading.preset.scene = default_scene();
  for (Given& given : reading.given) {
    const std::string key(given.row->key);
    reading.preset.origins[key] = given.origin;
    if (!take_rows(reading, given)) {
      reading.invalid.insert(key);
      continue;
    }
    std::string problem = assign(reading.preset.scene, *given.row, given.value);
    if (problem.empty()) continue;
    reading.invalid.insert(key);
    reading.say(issue_at(reading.preset, key, std::move(problem)));
  }
  drop_excluded_defaults(reading.preset);
}

/// The scene with what the preset itself says of the keys in place of what --set says of them.
Scene without_overrides(const Reading& reading, std::span<const std::string_view> keys) {
  Scene scene = reading.preset.scene;
  const Scene standard = default_scene();
  for (const std::string_view key : keys) {
    const auto origin = reading.preset.origins.find(std::string(key));
    if (origin == reading.preset.origins.end() || origin->second.file != "--set") continue;
    const Parameter& row = *find_parameter(key);
    const auto own = std::find_if(reading.replaced.begin(), reading.replaced.end(),
                                  [&](const Given& given) { return given.row == &row; });
    assign(scene, row,
           own == reading.replaced.end() ? value_from_text(toml_value(standard, row)) : own->value);
  }
  return scene;
}

void add_notes(Reading& reading) {
  constexpr std::array<std::string_view, 3> keys{"specimen.elements", "specimen.length", "specimen.height"};
  Preset& preset = reading.preset;
  if (std::string note = note_on_thickness(preset, without_overrides(reading, keys)); !note.empty())
    preset.notes.push_back(std::move(note));
  if (std::string note = note_on_layers(preset); !note.empty()) preset.notes.push_back(std::move(note));
  for (std::string& note : notes_on_rows(preset)) preset.notes.push_back(std::move(note));
}

/// A title in the file says what the file's crack is: --set that changes load, material, crack or damping
/// takes it away, and pictures then say what is in the run.
void drop_title_of_another_crack(Reading& reading) {
  Preset& preset = reading.preset;
  const auto title = preset.origins.find("film.title");
  if (title == preset.origins.end() || title->second.file == "--set") return;
  std::vector<std::string_view> keys;
  for (const Parameter& row : parameters())
    if (const std::string table = table_of(row);
        table == "loading" || table == "material" || table == "crack" || table == "damping")
      keys.push_back(row.key);
  const Scene of_file = without_overrides(reading, keys);
  const bool same = std::all_of(keys.begin(), keys.end(), [&](std::string_view key) {
    const Parameter& row = *find_parameter(key);
    return toml_value(of_file, row) == toml_value(preset.scene, row);
  });
  if (!same) preset.scene.film.title.clear();
}

void sort_by_place(std::vector<Issue>& issues) {
  const auto place = [](const Issue& issue) { return std::pair{issue.file == "--set", issue.line}; };
  std::stable_sort(issues.begin(), issues.end(),
                   [&](const Issue& a, const Issue& b) { return place(a) < place(b); });
}

Preset finished(Reading reading, const std::vector<std::string>& overrides, bool readable) {
  for (const std::string& text : overrides) take_override(reading, text);
  assign_all(reading);
  drop_title_of_another_crack(reading);
  if (readable) {
    for (Issue& issue : take_scenarios(reading.preset, reading.document, reading.invalid))
      reading.say(std::move(issue));
    for (Issue& issue : take_steering(reading.preset, reading.document)) reading.say(std::move(issue));
  }
  sort_by_place(reading.preset.issues);
  if (reading.preset.issues.empty()) add_notes(reading);
  return std::move(reading.preset);
}

Preset read(Reading reading, std::string_view text, const std::vector<std::string>& overrides,
            const std::vector<GridAxis>* grid) {
  take_text(reading, text);
  if (grid)
    replace_grid(reading.document, *grid, static_cast<int>(std::count(text.begin(), text.end(), '\n')) + 1);
  // After a syntax error nothing is known of the file, so nothing can contradict it.
  const bool readable = reading.preset.issues.empty() || reading.preset.issues.front().column == 0;
  return finished(std::move(reading), overrides, readable);
}

Preset read_file(const std::filesystem::path& path, const std::vector<std::string>& overrides,
                 const std::vector<GridAxis>* grid) {
  const PresetFile file = read_preset_file(path, largest_preset);
  Reading reading;
  reading.preset.name = path.string();
  reading.folder = path.parent_path();
  if (file.problem.empty()) return read(std::move(reading), file.text, overrides, grid);
  reading.say({path.string(), 0, "", file.problem});
  return finished(std::move(reading), overrides, false);
}

}  // namespace

Preset read_preset_text(std::string_view text, const std::string& name,
                        const std::vector<std::string>& overrides) {
  Reading reading;
  reading.preset.name = name;
  return read(std::move(reading), text, overrides, nullptr);
}

Preset read_preset(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  return read_file(path, overrides, nullptr);
}

Preset read_preset(const std::filesystem::path& path, const std::vector<std::string>& overrides,
                   const std::vector<GridAxis>& grid) {
  return read_file(path, overrides, &grid);
}

Issue issue_at(const Preset& preset, const std::string& key, std::string text) {
  const auto found = preset.origins.find(key);
  if (found != preset.origins.end()) {
    const Origin& origin = found->second;
    return {origin.file, origin.line, key, std::move(text), origin.value};
  }
  const Parameter* row = find_parameter(key);
  const std::string value = row ? toml_value(preset.scene, *row) : std::string{};
  return {preset.name, 0, key, std::move(text), value.empty() ? value : value + " (default)"};
}

Issue issue_at_row(const Preset& preset, const std::string& key, std::size_t row, std::string text) {
  const auto rows = preset.rows.find(key);
  if (rows != preset.rows.end() && row < rows->second.line.size())
    return {rows->second.file, rows->second.line[row], "", std::move(text)};
  return issue_at(preset, key, fmt::format("row {}: {}", row + 1, text));
}

PresetFile read_preset_file(const std::filesystem::path& path, std::size_t largest) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) return {"", "no such file"};
  if (std::filesystem::is_directory(status)) return {"", "is a directory"};

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
  if (!file) return {"", fmt::format("cannot be read: {}", std::strerror(errno))};
  std::string text;
  std::vector<char> buffer(std::size_t{1} << 16);
  while (text.size() <= largest) {
    const std::size_t most = std::min(buffer.size(), largest + 1 - text.size());
    const std::size_t count = std::fread(buffer.data(), 1, most, file.get());
    if (std::ferror(file.get()) != 0) return {"", fmt::format("cannot be read: {}", std::strerror(errno))};
    if (count == 0) break;
    text.append(buffer.data(), count);
  }
  return {std::move(text), ""};
}

}  // namespace rift::scene
