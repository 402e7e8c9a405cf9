#include "engine/scene/text_differences.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace rift::scene {
namespace {

/// The lines of a text by name: keys of a preset, and lines such as "resamples 12".
std::map<std::string, std::string> values_of(const std::string& text) {
  std::map<std::string, std::string> values;
  std::istringstream lines(text);
  std::string table;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.starts_with('#')) continue;
    if (line.starts_with('[')) {
      table = line.substr(1, line.find(']') - 1) + ".";
      continue;
    }
    const std::size_t equals = line.find(" = "), blank = line.rfind(' ');
    if (equals != std::string::npos)
      values[table + line.substr(0, equals)] = line.substr(equals + 3);
    else
      values[line.substr(0, blank)] = line.substr(std::min(line.size(), blank + 1));
  }
  return values;
}

/// A list of rows is too long to be shown.
std::string shown(const std::map<std::string, std::string>& values, const std::string& name) {
  constexpr std::size_t longest = 40;
  const auto found = values.find(name);
  if (found == values.end()) return "not given";
  return found->second.size() <= longest ? found->second : found->second.substr(0, longest) + " ...";
}

}  // namespace

std::vector<std::string> text_differences(const std::string& before, const std::string& now) {
  const std::map<std::string, std::string> old_values = values_of(before), new_values = values_of(now);
  std::map<std::string, std::string> names = old_values;
  names.insert(new_values.begin(), new_values.end());
  std::vector<std::string> differences;
  for (const auto& [name, value] : names) {
    const auto was = old_values.find(name), is = new_values.find(name);
    if (was != old_values.end() && is != new_values.end() && was->second == is->second) continue;
    const std::string before_text = shown(old_values, name), now_text = shown(new_values, name);
    differences.push_back(before_text == now_text
                              ? fmt::format("{} differs", name)
                              : fmt::format("{} was {}, is now {}", name, before_text, now_text));
  }
  return differences;
}

std::string differences_text(const std::string& before, const std::string& now) {
  constexpr std::size_t most = 4;
  std::vector<std::string> differences = text_differences(before, now);
  if (differences.empty()) return {};
  const std::size_t count = differences.size();
  differences.resize(std::min(most, count));
  return fmt::format(": {}{}", fmt::join(differences, "; "),
                     count > most ? fmt::format("; and {} more", count - most) : "");
}

}  // namespace rift::scene
