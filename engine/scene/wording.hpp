#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Small helpers for texts that quote what a user wrote.
namespace rift::scene {

/// The text on one line, short and harmless on a terminal: escaped (base/text.hpp), bytes past `limit` "...".
std::string printable(std::string_view text, std::size_t limit = 60);

/// "a", "a or b", "a, b or c"; `last` is the word before the last name.
std::string listed(std::span<const std::string> names, std::string_view last = "or");

/// The candidate nearest to `name`, or empty where none is near enough to be meant.
/// Distance: insertions, deletions, substitutions and swaps of neighbours; at most a third of the name, at
/// most 3.
std::string nearest_name(std::string_view name, std::span<const std::string> candidates);

/// Whether a comma stands between two digits, "60,5 mm", where a quantity wants a point.
bool has_decimal_comma(std::string_view text);

/// Without the blanks at both ends.
std::string_view trimmed(std::string_view text);

}  // namespace rift::scene
