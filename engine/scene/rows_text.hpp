#pragma once

#include "engine/scene/scene.hpp"
#include "engine/scene/units.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace rift::scene {

// The small languages of [crack]: velocity, path and relaxation, each read and written back exactly.

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

// Parameters that are rows of numbers, read from what the user wrote and written back so that they are read
// to the same bits. Readers return what is wrong (nothing is stored then), or empty; writers nothing of no
// rows.

/// Points of the plate, (x, y).
std::string read_points(const Value& value, std::vector<std::array<double, 2>>& out);
std::string rows_text(const std::vector<std::array<double, 2>>& points);

std::string read_history(const Value& value, std::vector<history::HistoryPoint>& out);
std::string rows_text(const std::vector<history::HistoryPoint>& rows);

/// The first row's unit says what all are against.
std::string read_critical_rate(const Value& value, fracture::CriticalRate& out);
std::string rows_text(const fracture::CriticalRate& rate);

/// The first row's unit says of what the curve is.
std::string read_load_curve(const Value& value, LoadCurve& out);
std::string rows_text(const LoadCurve& curve);

}  // namespace rift::scene
