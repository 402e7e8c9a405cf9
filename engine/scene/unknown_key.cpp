#include "engine/scene/unknown_key.hpp"

#include "engine/scene/parameters.hpp"
#include "engine/scene/wording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace rift::scene {

namespace {

std::vector<std::string> table_names() {
  std::vector<std::string> names;
  for (const Parameter& row : parameters()) {
    if (names.empty() || names.back() != table_of(row)) names.push_back(table_of(row));
  }
  return names;
}

std::vector<std::string> names_in(const std::string& table) {
  std::vector<std::string> names;
  for (const Parameter& row : parameters()) {
    if (table_of(row) == table) names.push_back(name_of(row));
  }
  return names;
}

/// The full key whose last part is `name`, or nearest to it, in any table.
std::string full_key_named(const std::string& name) {
  std::vector<std::string> names;
  for (const Parameter& row : parameters()) names.push_back(name_of(row));
  const std::string last =
      std::find(names.begin(), names.end(), name) != names.end() ? name : nearest_name(name, names);
  for (const Parameter& row : parameters()) {
    if (!last.empty() && name_of(row) == last) return std::string(row.key);
  }
  return {};
}

std::string nearest_full_key(const std::string& name) {
  std::vector<std::string> keys;
  for (const Parameter& row : parameters()) keys.emplace_back(row.key);
  return nearest_name(name, keys);
}

}  // namespace

bool is_table(const std::string& name) {
  const std::vector<std::string> names = table_names();
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string unknown_table(const std::string& name) {
  std::vector<std::string> names = table_names();
  names.insert(names.end(), {"study", "lanes"});
  std::string nearest = nearest_name(name, names);
  if (nearest == "lanes") nearest = "[lanes]";
  if (!nearest.empty())
    return fmt::format("unknown table [{}], did you mean [{}]?", printable(name), nearest);
  return fmt::format("unknown table [{}]: a preset has {}", printable(name), listed(names, "and"));
}

std::string unknown_key(const std::string& table, const std::string& name) {
  const std::vector<std::string> siblings = names_in(table);
  std::string nearest = nearest_name(name, siblings);
  if (nearest.empty()) nearest = nearest_full_key(name);
  if (nearest.empty()) nearest = full_key_named(name.substr(name.rfind('.') + 1));
  if (!nearest.empty()) return fmt::format("unknown key '{}', did you mean '{}'?", printable(name), nearest);
  if (siblings.empty())
    return fmt::format("unknown key '{}': docs/parameters.md lists them all", printable(name));
  return fmt::format("unknown key '{}': [{}] has {}", printable(name), table, listed(siblings, "and"));
}

}  // namespace rift::scene
