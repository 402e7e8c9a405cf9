#pragma once

#include "engine/scene/preset.hpp"
#include "engine/scene/scenarios.hpp"
#include "engine/scene/toml_text.hpp"

#include <set>
#include <span>
#include <string>
#include <vector>

namespace rift::scene {

// One scenario of a study, or one lane: the base scene with the values of some axes put in their place.

/// An axis at a value, and the line of the preset that says so.
struct Setting {
  const Axis* axis;
  Value value;
  int line = 0;
};

/// The scene of a preset that scenarios start from.
struct Base {
  const Preset& preset;
  const std::set<std::string>& invalid;  // its keys with an issue of their own
};

struct Scenario {
  Preset preset;  // scene and origins, those of the settings at their lines; issues: of the settings alone
  std::set<std::string> invalid;  // keys with an issue of their own
};

/// Who chose a combination of values. In a grid it is arithmetic, and what means nothing is taken out; in a
/// table of its own it is a wish, and two values that cannot both be meant stay for validate() to find.
enum class Chosen { by_grid, by_hand };

/// The base with `settings` assigned, then settled, so that what is physically one scenario is one scene:
/// a simple release has the base's relaxation and damage zone; no damped region has alpha 0; alpha 0 has no
/// region.
Scenario scenario_of(const Base& base, std::span<const Setting> settings, Chosen chosen);

/// Equal for two scenarios of one base exactly where their scenes are.
std::string fingerprint(const Scene& scene);

// What [study], [[study.rows]] and [[lanes]] say, before any scene is made of it.

/// The first place of a preset that names an axis.
struct Mention {
  const Axis* axis;
  std::string table;  // "study", "study.rows" or "lanes"
  int line = 0;
  std::string value;  // as shown in messages
};

/// One table of [[study.rows]] or [[lanes]].
struct ListedScenario {
  std::vector<Setting> settings;
  int line = 0;
  bool valid = true;  // every name in it was understood
};

/// Everything on the way from a text to scenarios, each mistake held once.
struct ScenarioReading {
  Base base;
  const TomlDocument& document;
  std::vector<Issue> issues = {};
  std::vector<Mention> mentions = {};  // every axis once: those of the grid, then those of the tables
  std::set<std::string> said = {};

  void say(Issue issue) {
    if (said.insert(to_text(issue)).second) issues.push_back(std::move(issue));
  }
  /// What stands in no line comes from --set study.AXIS=LIST.
  std::string file_of(int line) const { return line > 0 ? base.preset.name : "--set"; }
};

/// "study", "lanes" and "steering", which are no tables of parameters.
bool is_scenario_table(const std::string& name);

/// Where the preset begins to speak of `name`, or 0 where it does not.
int first_line(const TomlDocument& document, const std::string& name);

/// Complains about a [lanes], a `study = 3` and the like.
void check_shapes(ScenarioReading& reading);

/// The lists of [study] in the order of the file, without the values that are wrong.
std::vector<std::vector<Setting>> read_grid(ScenarioReading& reading);

/// The tables of `list`, "study.rows" or "lanes", in the order of the file.
std::vector<ListedScenario> read_listed_scenarios(ScenarioReading& reading, const std::string& list);

}  // namespace rift::scene
