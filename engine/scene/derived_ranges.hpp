#pragma once

#include "engine/scene/parameters.hpp"
#include "engine/scene/preset.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace rift::scene {

/// A number that follows from several keys, and the numbers it may be: each key alone may be fine and what
/// follows from all of them too large or too small to be computed with.
struct DerivedNumber {
  std::string name;  // with its article: "a mean radius"
  double value = 0;
  Range range;
  std::string unit;               // empty of a bare number
  std::vector<std::string> keys;  // that it follows from, the one that matters most first
};

/// What is wrong with the number, or nothing where it lies in its range. NaN lies in none. Of its keys the
/// issue points at the one that the user gave and whose value is furthest from its default; the text names
/// the others, the number and its range.
std::optional<Issue> range_issue(const Preset& preset, const Scene& scene, const DerivedNumber& number);

/// The issues of those that are out of their ranges, one for each key that is to blame: what follows from a
/// number that is out of its range is out of its own, too.
std::vector<Issue> range_issues(const Preset& preset, const Scene& scene,
                                const std::vector<DerivedNumber>& numbers);

/// All that follows from the preset's scene without a lattice: thickness, mean radius, elastic moduli,
/// density, wave speeds, strain, damage zone; those but for which a key is among the `unsound`.
std::vector<DerivedNumber> derived_numbers(const Preset& preset, const std::set<std::string>& unsound);

/// Of the Young's modulus of beams [Pa], given or derived.
inline constexpr Range micro_modulus_range{1e-6, 1e18};

/// Of the grip's displacement over the height, whatever its sign: corotational beams know the strain as the
/// difference of two lengths, which rounding ends at 1e-16 of them, and single precision ends at 1e-38.
Range strain_range(const Scene& scene);

}  // namespace rift::scene
