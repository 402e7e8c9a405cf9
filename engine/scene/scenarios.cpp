#include "engine/scene/scenarios.hpp"

#include "engine/base/text.hpp"
#include "engine/scene/issue.hpp"
#include "engine/scene/scenario.hpp"
#include "engine/scene/validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <map>
#include <utility>
#include <vector>

namespace rift::scene {
namespace {

// Per lane is what changes neither the lattice nor the critical step.
constexpr std::array<Axis, 20> axis_table{{
    {"technique", "crack.technique", true},
    {"relaxation", "crack.relaxation", true},
    {"damage_zone_ratio", "crack.damage_zone_ratio", true},
    {"damping_alpha", "damping.alpha", true},
    {"damping_region", "damping.region", true},
    {"crack_velocity", "crack.velocity", true},
    {"friction", "crack.friction", true},
    {"elements", "specimen.elements", false},
    {"layers", "specimen.layers", false},
    {"seed", "specimen.seed", false},
    {"stiffness", "material.stiffness", false},
    {"plane", "material.plane", false},
    {"dt_fraction", "solver.dt_fraction", false},
    {"beta", "solver.beta", false},
    {"precision", "solver.precision", false},
    {"kinematics", "solver.kinematics", false},
    {"length", "specimen.length", false},
    {"path", "crack.path", false},
    {"prestress_method", "loading.method", false},
    {"samples", "output.samples", false},
}};

std::vector<std::string> axis_names() {
  std::vector<std::string> names;
  names.reserve(axis_table.size());
  for (const Axis& axis : axis_table) names.emplace_back(axis.name);
  return names;
}

/// The axis that varies the key which is called so, with or without its table: "velocity" is crack_velocity.
std::string axis_of_key(const std::string& name) {
  for (const Axis& axis : axis_table) {
    if (name == axis.key || name == name_of(parameter_of(axis))) return std::string(axis.name);
  }
  return {};
}

}  // namespace

std::span<const Axis> axes() { return axis_table; }

const Axis* find_axis(std::string_view name) {
  for (const Axis& axis : axis_table) {
    if (axis.name == name) return &axis;
  }
  return nullptr;
}

const Parameter& parameter_of(const Axis& axis) {
  const Parameter* row = find_parameter(axis.key);
  assert(row);
  return *row;
}

bool applies(const Scene& scene, const Axis& axis) {
  const bool of_zone = axis.key == "crack.relaxation" || axis.key == "crack.damage_zone_ratio";
  return !of_zone || scene.crack.technique == fracture::Technique::progressive;
}

std::string axis_text(const Scene& scene, const Axis& axis) {
  const std::string value = applies(scene, axis) ? toml_value(scene, parameter_of(axis)) : std::string{};
  return value.empty() ? "-" : base::without_quotes(value);
}

// scenario_of() says how.
std::string_view settled_by(const Axis& axis) {
  if (axis.name == "damping_alpha") return "damping_region = \"none\"";
  if (axis.name == "damping_region") return "damping_alpha = 0";
  return "technique = \"simple\"";
}

std::string unknown_axis(const std::string& name) {
  const std::vector<std::string> names = axis_names();
  std::string nearest = axis_of_key(name);
  if (nearest.empty()) nearest = nearest_name(name, names);
  if (!nearest.empty()) return fmt::format("unknown axis '{}', did you mean '{}'?", printable(name), nearest);
  return fmt::format("unknown axis '{}': the axes are {}", printable(name), listed(names, "and"));
}

std::string lane_axes() {
  std::vector<std::string> names;
  for (const Axis& axis : axis_table) {
    if (axis.per_lane) names.emplace_back(axis.name);
  }
  return listed(names, "and");
}

namespace {

void check(ScenarioReading& reading, const Scenario& scenario) {
  for (const Issue& issue : scenario.preset.issues) reading.say(issue);
  for (Issue& issue : validate(scenario.preset, scenario.invalid)) reading.say(std::move(issue));
}

bool too_many(ScenarioReading& reading, double count, int line) {
  if (count <= most_scenarios) return false;
  reading.say(
      {reading.file_of(line), line, line > 0 ? "" : "study",
       fmt::format("{:.6g} scenarios, the limit is {}: leave out some values", count, most_scenarios)});
  return true;
}

/// What [study] comes to.
struct ScenesOfStudy {
  std::vector<Scene> scenes = {};
  std::vector<GridAxis> grid = {};
  std::vector<std::vector<std::vector<std::string>>> combinations = {};  // of each scene of the grid
  std::map<std::string, int> seen = {};  // the line of a scene, 0 for the grid, by its fingerprint
};

/// The next combination of the lists, the last list running fastest; false after the last one.
bool advance(std::vector<std::size_t>& at, const std::vector<std::vector<Setting>>& lists) {
  for (std::size_t i = lists.size(); i-- > 0;) {
    if (++at[i] < lists[i].size()) return true;
    at[i] = 0;
  }
  return false;
}

/// The value of a list as TOML, in the words in which presets are written.
std::string toml_of(const ScenarioReading& reading, const Setting& setting) {
  Scene scene = reading.base.preset.scene;
  assign(scene, parameter_of(*setting.axis), setting.value);
  return toml_value(scene, parameter_of(*setting.axis));
}

std::vector<GridAxis> grid_of(const ScenarioReading& reading,
                              const std::vector<std::vector<Setting>>& lists) {
  std::vector<GridAxis> grid;
  for (const std::vector<Setting>& list : lists) {
    GridAxis& axis = grid.emplace_back(GridAxis{std::string(list.front().axis->name), {}});
    for (const Setting& setting : list) axis.values.push_back(toml_of(reading, setting));
  }
  return grid;
}

/// Adds the grid's scenes, each once, in the order of nested loops over the lists.
void take_grid(ScenarioReading& reading, const std::vector<std::vector<Setting>>& lists, ScenesOfStudy& of) {
  if (lists.empty()) return;
  double count = 1;
  for (const auto& list : lists) count *= static_cast<double>(list.size());
  if (too_many(reading, count, lists.front().front().line)) return;
  of.grid = grid_of(reading, lists);
  std::map<std::string, std::size_t> place;  // of a scene among the others, by its fingerprint
  std::vector<std::size_t> at(lists.size(), 0);
  do {
    std::vector<Setting> settings;
    std::vector<std::string> values;
    for (std::size_t i = 0; i < lists.size(); ++i) {
      settings.push_back(lists[i][at[i]]);
      values.push_back(base::without_quotes(of.grid[i].values[at[i]]));
    }
    const Scenario scenario = scenario_of(reading.base, settings, Chosen::by_grid);
    const std::string mark = fingerprint(scenario.preset.scene);
    const auto [known, fresh] = place.emplace(mark, of.scenes.size());
    if (fresh) {
      check(reading, scenario);
      of.seen.emplace(mark, 0);
      of.scenes.push_back(scenario.preset.scene);
      of.combinations.emplace_back();
    }
    of.combinations[known->second].push_back(std::move(values));
  } while (advance(at, lists));
}

/// Adds the scenes that were written out one by one. One that is there already is a mistake, not a wish.
void take_rows(ScenarioReading& reading, const std::vector<ListedScenario>& rows,
               std::map<std::string, int>& seen, std::vector<Scene>& scenes) {
  if (!rows.empty() && too_many(reading, static_cast<double>(rows.size() + scenes.size()), rows.front().line))
    return;
  for (const ListedScenario& row : rows) {
    const Scenario scenario = scenario_of(reading.base, row.settings, Chosen::by_hand);
    check(reading, scenario);
    scenes.push_back(scenario.preset.scene);
    if (!row.valid || !scenario.preset.issues.empty()) continue;
    const auto [earlier, fresh] = seen.emplace(fingerprint(scenario.preset.scene), row.line);
    if (fresh) continue;
    const std::string where = earlier->second == 0 ? "the grid" : fmt::format("line {}", earlier->second);
    reading.say({reading.file_of(row.line), row.line, "", fmt::format("the same scenario as in {}", where)});
  }
}

/// A value of the grid that settling took out of every scenario is a mistake: nobody lists it for nothing.
void check_values(ScenarioReading& reading, const std::vector<std::vector<Setting>>& lists,
                  const std::vector<Scene>& scenes) {
  if (!reading.issues.empty()) return;
  for (const std::vector<Setting>& list : lists) {
    const Axis& axis = *list.front().axis;
    std::set<std::string> had;
    for (const Scene& scene : scenes) {
      if (applies(scene, axis)) had.insert(toml_value(scene, parameter_of(axis)));
    }
    const auto lost = std::find_if(list.begin(), list.end(), [&](const Setting& setting) {
      Scene scene = reading.base.preset.scene;
      assign(scene, parameter_of(axis), setting.value);
      return !had.contains(toml_value(scene, parameter_of(axis)));
    });
    if (lost == list.end()) continue;
    const Mention& mention = *std::find_if(reading.mentions.begin(), reading.mentions.end(),
                                           [&](const Mention& m) { return m.axis == &axis; });
    reading.say({reading.file_of(mention.line), mention.line, fmt::format("study.{}", axis.name),
                 fmt::format("{} applies to no scenario: all have {}", shown(lost->value), settled_by(axis)),
                 mention.value});
  }
}

/// An axis of rows or lanes that means nothing in any of them was meant for another technique.
void check_applies(ScenarioReading& reading, const std::vector<Scene>& scenes) {
  if (!reading.issues.empty()) return;
  for (const Mention& m : reading.mentions) {
    const bool somewhere = std::any_of(scenes.begin(), scenes.end(),
                                       [&](const Scene& scene) { return applies(scene, *m.axis); });
    if (somewhere) continue;
    reading.say({reading.file_of(m.line), m.line, fmt::format("{}.{}", m.table, m.axis->name),
                 "applies to no scenario: all have technique = \"simple\"", m.value});
  }
}

/// A --set of what the scenarios set themselves would look as if it counted.
void check_overrides(ScenarioReading& reading) {
  for (const Mention& m : reading.mentions) {
    const auto found = reading.base.preset.origins.find(std::string(m.axis->key));
    if (found == reading.base.preset.origins.end() || found->second.file != "--set") continue;
    const std::string where =
        m.line > 0 ? fmt::format("the {} (line {})", m.table == "lanes" ? "lanes" : "study", m.line)
                   : fmt::format("--set study.{}", m.axis->name);
    reading.say({"--set", 0, std::string(m.axis->key), fmt::format("varied by {}: change it there", where),
                 found->second.value});
  }
}

void check_both(ScenarioReading& reading, int study, int lanes) {
  if (study == 0 || lanes == 0) return;
  reading.say({reading.file_of(lanes), lanes, "",
               fmt::format("[[lanes]] beside [study] (line {}): a preset has one or the other", study)});
}

void check_empty(ScenarioReading& reading) {
  for (const TomlTable& table : reading.document.tables) {
    if (table.name != "study" || !reading.mentions.empty() || !reading.issues.empty()) continue;
    reading.say({reading.file_of(table.line), table.line, "",
                 "[study] names no axis: write one list of values per axis, or [[study.rows]]"});
  }
}

ScenesOfStudy study_scenes(ScenarioReading& reading) {
  ScenesOfStudy of;
  const std::vector<std::vector<Setting>> lists = read_grid(reading);
  const std::vector<ListedScenario> rows = read_listed_scenarios(reading, "study.rows");
  check_empty(reading);
  take_grid(reading, lists, of);
  check_values(reading, lists, of.scenes);
  take_rows(reading, rows, of.seen, of.scenes);
  check_applies(reading, of.scenes);
  return of;
}

std::vector<Scene> lane_scenes(ScenarioReading& reading) {
  std::map<std::string, int> seen;
  std::vector<Scene> scenes;
  take_rows(reading, read_listed_scenarios(reading, "lanes"), seen, scenes);
  check_applies(reading, scenes);
  return scenes;
}

/// The scenes as rows, those of the grid with their combinations.
std::vector<StudyRow> study_rows(ScenesOfStudy of, const std::vector<Mention>& mentions) {
  std::vector<StudyRow> rows;
  of.combinations.resize(of.scenes.size());
  for (std::size_t k = 0; k < of.scenes.size(); ++k) {
    StudyRow& row = rows.emplace_back(StudyRow{of.scenes[k], {}, std::move(of.combinations[k])});
    for (const Mention& m : mentions) row.axes.emplace_back(m.axis->name, axis_text(row.scene, *m.axis));
  }
  return rows;
}

/// The base is checked as it stands, but for the axes of scenarios which could not be made.
void check_base(ScenarioReading& reading, const std::vector<Mention>& mentions) {
  std::set<std::string> invalid = reading.base.invalid;
  for (const Mention& m : mentions) invalid.emplace(m.axis->key);
  for (Issue& issue : validate(reading.base.preset, invalid)) reading.say(std::move(issue));
}

}  // namespace

std::vector<Issue> take_scenarios(Preset& preset, const TomlDocument& document,
                                  const std::set<std::string>& invalid) {
  ScenarioReading study{{preset, invalid}, document}, lanes{{preset, invalid}, document};
  check_shapes(study);
  ScenesOfStudy of_study = study_scenes(study);
  std::vector<Scene> of_lanes = lane_scenes(lanes);
  check_overrides(study);
  check_overrides(lanes);
  check_both(study, first_line(document, "study"), first_line(document, "lanes"));
  for (Issue& issue : lanes.issues) study.say(std::move(issue));
  if (of_study.scenes.empty() && of_lanes.empty()) {
    std::vector<Mention> mentions = study.mentions;
    mentions.insert(mentions.end(), lanes.mentions.begin(), lanes.mentions.end());
    check_base(study, mentions);
  }
  preset.grid = of_study.grid;
  preset.study = study_rows(std::move(of_study), study.mentions);
  preset.lanes = std::move(of_lanes);
  return std::move(study.issues);
}

}  // namespace rift::scene
