#pragma once

#include "studio/report/chart.hpp"

#include <string>

namespace rift::studio {

/// column,row,x,y,value,text: a row per cell whose value is finite; column and row count from 0.
std::string chart_data(const HeatMap& map);

/// The gnuplot script which draws NAME.csv.
std::string chart_script(const HeatMap& map, const std::string& name);

}  // namespace rift::studio
