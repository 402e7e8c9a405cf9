#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace rift::scene {

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

/// More are counted, not shown: nobody reads the nine thousandth.
inline constexpr std::size_t most_issues_shown = 20;

/// Bad input found where it can no longer be returned as a value (a command, or a check that needs the
/// lattice). what() holds one line per issue, at most `most_issues_shown` and how many
/// there are more.
struct InputError : std::runtime_error {
  explicit InputError(std::vector<Issue> found);
  std::vector<Issue> issues;
};

}  // namespace rift::scene
