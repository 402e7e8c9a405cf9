#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace rift::scene {

// Small helpers for texts that quote what a user wrote.

/// The text on one line, short and harmless on a terminal: escaped (base/text.hpp), bytes past `limit` "...".
std::string printable(std::string_view text, std::size_t limit = 60);

/// "a", "a or b", "a, b or c"; `last` is the word before the last name.
std::string listed(std::span<const std::string> names, std::string_view last = "or");

/// The candidate nearest to `name`, or empty where none is near enough to be meant.
/// Distance: insertions, deletions, substitutions and swaps of neighbours, whatever the case, underscores and
/// dashes; at most a third of the name, at most 3. Where none is so near, the shortest that begins with the
/// name.
std::string nearest_name(std::string_view name, std::span<const std::string> candidates);

/// Whether a comma stands between two digits, "60,5 mm", where a quantity wants a point.
bool has_decimal_comma(std::string_view text);

/// Without the blanks at both ends.
std::string_view trimmed(std::string_view text);

/// One mistake in what the user gave us; collected as a value, never thrown one by one.
struct Issue {
  std::string file;        // the preset, or "--set" for an override
  int line = 0;            // from 1; 0 where there is none
  std::string key;         // full key such as "crack.velocity"; empty where the text says it all
  std::string text;        // what is wrong and what is allowed
  std::string value = {};  // the value as shown to the user, quotes included; empty where there is none
  int column = 0;          // of a syntax error, from 1; 0 otherwise
};

/// The line which the user reads: `presets/x.toml:14: crack.velocity = "5 c_r": must lie in (0, 2] c_r`,
/// or `--set crack.velocity=5: ...` for an override.
std::string to_text(const Issue& issue);

/// The same without the place: `crack.velocity = "5 c_r": must lie in (0, 2] c_r`.
std::string without_place(const Issue& issue);

/// More are counted, not shown: nobody reads the nine thousandth.
inline constexpr std::size_t most_issues_shown = 20;

/// Bad input found where it can no longer be returned as a value (a command, or a check that needs the
/// lattice). what() holds one line per issue, at most `most_issues_shown` and how many
/// there are more.
struct InputError : std::runtime_error {
  explicit InputError(std::vector<Issue> found);
  std::vector<Issue> issues;
};

// Messages about names that the parameter table does not know, with the nearest one that it does.

/// Whether presets have a table of this name.
bool is_table(const std::string& name);

/// "unknown table [spcimen], did you mean [specimen]?"
std::string unknown_table(const std::string& name);

/// "unknown key 'damge_zone_ratio', did you mean 'damage_zone_ratio'?"
/// @param table  of the preset in which the key stands; empty where `name` is meant to be a full key
std::string unknown_key(const std::string& table, const std::string& name);

/// The full key that is meant by `name`, with or without its table, or the nearest to it; empty where none is
/// near.
std::string nearest_key(const std::string& name);

}  // namespace rift::scene
