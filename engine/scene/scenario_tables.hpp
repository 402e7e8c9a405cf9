#pragma once

#include "engine/scene/scenario.hpp"
#include "engine/scene/toml_text.hpp"

#include <set>
#include <string>
#include <vector>

/// What [study], [[study.rows]] and [[lanes]] say, before any scene is made of it.
namespace rift::scene {

/// The first place of a preset that names an axis.
struct Mention {
  const Axis* axis;
  std::string table;  // "study", "study.rows" or "lanes"
  int line = 0;
  std::string value;  // as shown in messages
};

/// One table of [[study.rows]] or [[lanes]].
struct HandRow {
  std::vector<Setting> settings;
  int line = 0;
  bool sound = true;  // every name in it was understood
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
  const std::string& file() const { return base.preset.name; }
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
std::vector<HandRow> read_hand_rows(ScenarioReading& reading, const std::string& list);

}  // namespace rift::scene
