#pragma once

#include "engine/scene/scene.hpp"
#include "engine/scene/units.hpp"

#include <string>
#include <string_view>
#include <vector>

/// The small languages of [crack]: velocity, path and relaxation, each read and written back exactly.
namespace rift::scene {

/// No crack in mode I is prescribed faster than this many Rayleigh speeds.
inline constexpr double highest_velocity_over_cr = 2.0;

/// Reads "0.5 c_r", "1100 m/s" or pieces "0.2 c_r until 40 mm, 0.6 c_r"; the unit is never optional, the
/// untils rise, the last piece has none. Speeds must be above 0, and at most 2 where they are in c_r.
Parsed<std::vector<VelocityPiece>> read_velocity(std::string_view text);
std::string velocity_text(const std::vector<VelocityPiece>& velocity);

/// Reads "0.5 H" (a fraction of the plate's height, in (0, 1)) or a length above 0.
Parsed<CrackLine> read_path(std::string_view text);
std::string path_text(const CrackLine& path);

/// "linear" is p = 1, "square-root" 1/2, "quadratic" 2 of Y1/Y2 = (1 - b/l)^p   [paper eqs. (9)-(11)]
Parsed<double> read_relaxation(std::string_view name);

/// The name of p, or "power(p)" where it has none.
std::string relaxation_name(double p);

}  // namespace rift::scene
