#pragma once

#include "studio/report/chart.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace rift::studio {

/// Indices of the points which a chart shows: x and y finite.
std::vector<std::size_t> drawable_points(const ChartSeries& series);

/// What the rows of each series are called in the csv: its label without markup, made unique, never empty.
std::vector<std::string> series_names(const Chart& chart);

/// The tidy csv: series,x,y,error, a row per drawable point, numbers that read back as they were.
std::string chart_data(const Chart& chart);

/// The gnuplot script which draws NAME.csv.
std::string chart_script(const Chart& chart, const std::string& name);

}  // namespace rift::studio
