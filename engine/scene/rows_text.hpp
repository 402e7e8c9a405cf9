#pragma once

#include "engine/scene/scene.hpp"
#include "engine/scene/value.hpp"

#include <array>
#include <string>
#include <vector>

/// Parameters that are rows of numbers, read from what the user wrote and written back so that they are read
/// to the same bits. Readers return what is wrong (nothing is stored then), or empty; writers nothing of no
/// rows.
namespace rift::scene {

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
