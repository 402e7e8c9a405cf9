#include "engine/scene/scenario.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

namespace rift::scene {
namespace {

void put(Scenario& scenario, const Setting& setting) {
  const std::string key(setting.axis->key);
  scenario.preset.origins[key] = {scenario.preset.name, setting.line, shown(setting.value)};
  scenario.invalid.erase(key);  // of the base, whose value no longer counts
  std::string problem = assign(scenario.preset.scene, parameter_of(*setting.axis), setting.value);
  if (problem.empty()) return;
  scenario.invalid.insert(key);
  scenario.preset.issues.push_back(issue_at(scenario.preset, key, std::move(problem)));
}

void settle_damage_zone(Scene& scene, const Scene& base) {
  if (scene.crack.technique != fracture::Technique::simple) return;
  scene.crack.relaxation = base.crack.relaxation;
  scene.crack.damage_zone_ratio = base.crack.damage_zone_ratio;
}

/// Only what the scenario says itself takes damping out: an alpha on a base without a region stays a mistake.
void settle_damping(Scene& scene, bool alpha_given, bool region_given, Chosen chosen) {
  const bool grid = chosen == Chosen::by_grid;
  const bool nowhere = region_given && scene.damping.region == DampingRegion::none;
  const bool nothing = alpha_given && scene.damping.alpha == 0;
  if (nowhere && (grid || !alpha_given)) scene.damping.alpha = 0;
  if (nothing && (grid || !region_given)) scene.damping.region = DampingRegion::none;
}

}  // namespace

Scenario scenario_of(const Base& base, std::span<const Setting> settings, Chosen chosen) {
  Scenario scenario{
      {base.preset.scene, base.preset.origins, {}, base.preset.name, {}, {}, {}, base.preset.rows, {}},
      base.invalid};
  for (const Setting& setting : settings) put(scenario, setting);
  const auto given = [&](std::string_view key) {
    return std::any_of(settings.begin(), settings.end(),
                       [&](const Setting& s) { return s.axis->key == key; });
  };
  Scene& scene = scenario.preset.scene;
  settle_damage_zone(scene, base.preset.scene);
  settle_damping(scene, given("damping.alpha"), given("damping.region"), chosen);
  return scenario;
}

std::string fingerprint(const Scene& scene) {
  std::string out;
  for (const Axis& axis : axes()) out += toml_value(scene, parameter_of(axis)) + '\n';
  return out;
}

namespace {

bool mentioned(const std::vector<Mention>& mentions, const Axis* axis) {
  return std::any_of(mentions.begin(), mentions.end(), [&](const Mention& m) { return m.axis == axis; });
}

Issue issue_of(const ScenarioReading& reading, const TomlEntry& entry, std::string text) {
  return {reading.file_of(entry.line), entry.line, entry.table + '.' + entry.name, std::move(text),
          shown(entry.value)};
}

std::string wants_a_list(const TomlEntry& entry) {
  if (std::holds_alternative<Value::Other>(entry.value.held))
    return fmt::format("expected a list of values, got {}", kind_of(entry.value));
  return fmt::format("expected a list of values: write {} = [{}]", entry.name, shown(entry.value));
}

std::string wants_tables(const std::string& list, const Value& value) {
  const auto* items = std::get_if<std::vector<Value>>(&value.held);
  const std::string got =
      items ? (items->empty() ? "an empty list" : "a list with something else") : std::string(kind_of(value));
  return fmt::format("expected tables [[{}]], got {}", list, got);
}

bool has_rows(const TomlDocument& document, const std::string& list) {
  return std::any_of(document.rows.begin(), document.rows.end(),
                     [&](const TomlRow& row) { return row.list == list; });
}

/// The values of one list that can be had, each once.
std::vector<Setting> read_axis(ScenarioReading& reading, const Axis& axis, const TomlEntry& entry) {
  std::vector<Setting> settings;
  std::map<std::string, std::string> seen;  // how a value is shown, by its meaning: "linear" is 1
  for (const Value& item : std::get<std::vector<Value>>(entry.value.held)) {
    Scene scene = reading.base.preset.scene;
    const Parameter& row = parameter_of(axis);
    if (std::string problem = assign(scene, row, item); !problem.empty()) {
      reading.say(
          {reading.file_of(entry.line), entry.line, std::string(axis.key), std::move(problem), shown(item)});
      continue;
    }
    const auto [earlier, fresh] = seen.emplace(toml_value(scene, row), shown(item));
    if (fresh) {
      settings.push_back({&axis, item, entry.line});
    } else if (earlier->second == shown(item)) {
      reading.say(issue_of(reading, entry, shown(item) + " twice"));
    } else {
      reading.say(issue_of(reading, entry,
                           fmt::format("{} and {} are the same value", earlier->second, shown(item))));
    }
  }
  return settings;
}

ListedScenario read_listed_scenario(ScenarioReading& reading, const TomlRow& row) {
  ListedScenario out{{}, row.line};
  if (row.entries.empty()) {
    reading.say({reading.file_of(row.line), row.line, "",
                 fmt::format("[[{}]] is empty: name an axis and its value", row.list)});
    out.valid = false;
  }
  for (const TomlEntry& entry : row.entries) {
    const Axis* axis = find_axis(entry.name);
    const bool allowed_here = axis && (row.list != "lanes" || axis->per_lane);
    out.valid = out.valid && allowed_here;
    if (!axis) {
      reading.say({reading.file_of(entry.line), entry.line, "", unknown_axis(entry.name)});
    } else if (!allowed_here) {
      reading.say(issue_of(
          reading, entry,
          fmt::format("lanes share one lattice and one step: they may differ in {} only", lane_axes())));
    } else {
      out.settings.push_back({axis, entry.value, entry.line});
    }
  }
  return out;
}

/// Adds the axes that a table is the first to name: before the next one that is known already, so that what
/// an earlier table left out keeps its place (technique, relaxation, seed from a simple row and a progressive
/// one), else at the end.
void merge(std::vector<Mention>& mentions, const ListedScenario& row, const std::string& list) {
  for (auto setting = row.settings.begin(); setting != row.settings.end(); ++setting) {
    if (mentioned(mentions, setting->axis)) continue;
    const auto next = std::find_if(setting, row.settings.end(),
                                   [&](const Setting& s) { return mentioned(mentions, s.axis); });
    const auto place = std::find_if(mentions.begin(), mentions.end(), [&](const Mention& m) {
      return next != row.settings.end() && m.axis == next->axis;
    });
    mentions.insert(place, {setting->axis, list, setting->line, shown(setting->value)});
  }
}

}  // namespace

bool is_scenario_table(const std::string& name) {
  return name == "study" || name == "lanes" || name == "steering";
}

int first_line(const TomlDocument& document, const std::string& name) {
  int line = 0;
  const auto see = [&](int at) { line = line == 0 ? at : std::min(line, at); };
  for (const TomlTable& table : document.tables) {
    if (table.name == name) see(table.line);
  }
  for (const TomlRow& row : document.rows) {
    if (row.list == name || row.list.starts_with(name + '.')) see(row.line);
  }
  for (const TomlEntry& entry : document.entries) {
    if (entry.table.empty() && entry.name == name) see(entry.line);
  }
  return line;
}

void check_shapes(ScenarioReading& reading) {
  const TomlDocument& document = reading.document;
  for (const TomlTable& table : document.tables) {
    if (table.name == "lanes")
      reading.say(
          {reading.file_of(table.line), table.line, "", "lanes are a list of tables: write [[lanes]]"});
  }
  for (const TomlEntry& entry : document.entries) {
    if (!entry.table.empty() || !is_scenario_table(entry.name)) continue;
    const bool tables = has_rows(document, entry.name);
    if (entry.name == "steering") {
      if (!tables)
        reading.say({reading.file_of(entry.line), entry.line, "steering",
                     wants_tables("steering", entry.value), shown(entry.value)});
    } else if (entry.name == "study") {
      const auto text = tables ? std::string("a study is one table: write [study]")
                               : fmt::format("expected a table [study], got {}", kind_of(entry.value));
      reading.say({reading.file_of(entry.line), entry.line, tables ? "" : "study", text,
                   tables ? "" : shown(entry.value)});
    } else if (!tables) {
      reading.say({reading.file_of(entry.line), entry.line, "lanes", wants_tables("lanes", entry.value),
                   shown(entry.value)});
    }
  }
}

std::vector<std::vector<Setting>> read_grid(ScenarioReading& reading) {
  std::vector<std::vector<Setting>> lists;
  for (const TomlEntry& entry : reading.document.entries) {
    if (entry.table != "study") continue;
    if (entry.name == "rows") {
      if (!has_rows(reading.document, "study.rows"))
        reading.say(issue_of(reading, entry, wants_tables("study.rows", entry.value)));
      continue;
    }
    const Axis* axis = find_axis(entry.name);
    const auto* items = std::get_if<std::vector<Value>>(&entry.value.held);
    if (!axis) {
      reading.say({reading.file_of(entry.line), entry.line, "", unknown_axis(entry.name)});
      continue;
    }
    reading.mentions.push_back({axis, "study", entry.line, shown(entry.value)});
    if (!items) {
      reading.say(issue_of(reading, entry, wants_a_list(entry)));
    } else if (items->empty()) {
      reading.say(issue_of(reading, entry, "needs at least one value"));
    } else if (std::vector<Setting> settings = read_axis(reading, *axis, entry); !settings.empty()) {
      lists.push_back(std::move(settings));
    }
  }
  return lists;
}

std::vector<ListedScenario> read_listed_scenarios(ScenarioReading& reading, const std::string& list) {
  std::vector<ListedScenario> rows;
  std::vector<Mention> found;
  for (const TomlRow& row : reading.document.rows) {
    if (row.list != list) continue;
    rows.push_back(read_listed_scenario(reading, row));
    merge(found, rows.back(), list);
  }
  for (Mention& mention : found) {
    if (!mentioned(reading.mentions, mention.axis)) reading.mentions.push_back(std::move(mention));
  }
  return rows;
}

}  // namespace rift::scene
