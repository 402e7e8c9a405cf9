#include "engine/scene/issue.hpp"

#include "engine/base/text.hpp"
#include "engine/scene/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace rift::scene {
namespace {

/// Edit distance with swaps of neighbours (optimal string alignment; Damerau 1964), O(|a| |b|).
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t change = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + change});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

std::string printable(std::string_view text, std::size_t limit) {
  std::size_t end = std::min(text.size(), limit);
  while (end < text.size() && end > 0 && base::continues_letter(text[end]))
    --end;  // never cut a letter in two
  const std::string out = base::escaped(text.substr(0, end));
  return end < text.size() ? out + "..." : out;
}

std::string listed(std::span<const std::string> names, std::string_view last) {
  std::string out;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) out += i + 1 == names.size() ? fmt::format(" {} ", last) : std::string(", ");
    out += names[i];
  }
  return out;
}

namespace {

/// The letters and digits that distinguish names: in lower case, without underscores and dashes.
std::string letters_of(std::string_view name) {
  std::string letters;
  for (const char c : name)
    if (c != '_' && c != '-') letters += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return letters;
}

}  // namespace

std::string nearest_name(std::string_view name, std::span<const std::string> candidates) {
  constexpr std::size_t longest = 80, fewest_of_begin = 5;  // no key is longer; "stu" begins too much
  if (name.size() > longest) return {};
  const std::string letters = letters_of(name);
  std::size_t best = std::clamp<std::size_t>(name.size() / 3, 1, 3) + 1;
  std::string found, begun;
  for (const std::string& candidate : candidates) {
    if (candidate == name) continue;
    const std::string other = letters_of(candidate);
    const std::size_t d = distance(letters, other);
    if (d < best) {
      best = d;
      found = candidate;
    }
    const bool begins = letters.size() >= fewest_of_begin && other.starts_with(letters);
    if (begins && (begun.empty() || candidate.size() < begun.size())) begun = candidate;
  }
  return found.empty() ? begun : found;
}

bool has_decimal_comma(std::string_view text) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  for (std::size_t k = 1; k + 1 < text.size(); ++k)
    if (text[k] == ',' && is_digit(text[k - 1]) && is_digit(text[k + 1])) return true;
  return false;
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

namespace {

std::string place(const Issue& issue) {
  if (issue.line == 0) return issue.file;
  if (issue.column == 0) return fmt::format("{}:{}", issue.file, issue.line);
  return fmt::format("{}:{}:{}", issue.file, issue.line, issue.column);
}

std::string joined(const std::vector<Issue>& issues) {
  std::string lines;
  const std::size_t shown = std::min(issues.size(), most_issues_shown);
  for (std::size_t k = 0; k < shown; ++k) lines += (k == 0 ? "" : "\n") + to_text(issues[k]);
  if (issues.size() > shown) lines += fmt::format("\nand {} more", issues.size() - shown);
  return lines;
}

}  // namespace

std::string to_text(const Issue& issue) {
  if (issue.file == "--set") {
    const std::string given = issue.value.empty() ? issue.key : issue.key + "=" + issue.value;
    return fmt::format("--set {}: {}", given, issue.text);
  }
  return fmt::format("{}: {}", place(issue), without_place(issue));
}

std::string without_place(const Issue& issue) {
  if (issue.key.empty()) return issue.text;
  const std::string given = issue.value.empty() ? issue.key : issue.key + " = " + issue.value;
  return fmt::format("{}: {}", given, issue.text);
}

InputError::InputError(std::vector<Issue> found)
    : std::runtime_error(joined(found)), issues(std::move(found)) {}

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

std::string nearest_key(const std::string& name) {
  if (find_parameter(name) != nullptr) return name;
  const std::string whole = nearest_full_key(name);
  return whole.empty() ? full_key_named(name.substr(name.rfind('.') + 1)) : whole;
}

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
  if (nearest.empty()) nearest = nearest_key(name);
  if (!nearest.empty()) return fmt::format("unknown key '{}', did you mean '{}'?", printable(name), nearest);
  if (siblings.empty())
    return fmt::format("unknown key '{}': docs/parameters.md lists them all", printable(name));
  return fmt::format("unknown key '{}': [{}] has {}", printable(name), table, listed(siblings, "and"));
}

}  // namespace rift::scene
