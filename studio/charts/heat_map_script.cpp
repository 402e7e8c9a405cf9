#include "studio/charts/chart_script.hpp"
#include "studio/charts/label.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift::studio {
namespace {

constexpr std::size_t most_ticks = 14;

/// The values of an axis at their cells; only every so many where there are more than fit.
std::string ticks(char axis, const std::vector<double>& values) {
  const std::size_t stride = 1 + (values.size() - 1) / most_ticks;
  std::string out;
  for (std::size_t k = 0; k < values.size(); k += stride)
    out += fmt::format("{}'{:.4g}' {}", out.empty() ? "" : ", ", values[k], k);
  return fmt::format("set {0}tics ({1})\nset {0}range [-0.5:{2}.5]\n", axis, out, values.size() - 1);
}

AxisRange value_range(const HeatMap& map) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double v : map.value)
    if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
  low = map.value_range.min.value_or(low), high = map.value_range.max.value_or(high);
  if (low == high) low -= 0.5, high += 0.5;  // one colour needs an extent too
  return {low, high};
}

}  // namespace

std::string chart_data(const HeatMap& map) {
  std::string out = "column,row,x,y,value,text\n";
  for (std::size_t k = 0; k < map.value.size(); ++k) {
    if (!std::isfinite(map.value[k])) continue;
    const std::size_t column = k % map.x.size(), row = k / map.x.size();
    out += fmt::format("{},{},{},{},{},{}\n", column, row, map.x[column], map.y[row], map.value[k],
                       map.text.empty() ? "" : gnuplot_field(map.text[k]));
  }
  return out;
}

std::string chart_script(const HeatMap& map, const std::string& name) {
  const AxisRange range = value_range(map);
  std::string out = script_head(map.title, name, chart_height);
  out += fmt::format("set title {}\nset xlabel {}\nset ylabel {}\nset cblabel {} offset 1.5, 0\n",
                     label_string(map.title), label_string(map.x_label), label_string(map.y_label),
                     label_string(map.value_label));
  out += ticks('x', map.x) + ticks('y', map.y);
  out += fmt::format("set cbrange [{}:{}]\n", *range.min, *range.max);
  out += "set rmargin 12\nset tics scale 0.3\nunset grid\nset border 0\nset key off\nset colorbox noborder\n";
  // Cividis: reads the same with and without colour blindness, and in grey.
  out +=
      "set palette defined (0 '#00224e', 1 '#2a3f6d', 2 '#575d6d', 3 '#7d7c78', 4 '#a59c74', 5 '#d2c060', 6 "
      "'#fee838')\n";
  std::string plot = "plot data using 1:2:(0.51):(0.51):5 with boxxyerror fs solid noborder fc palette";
  if (!map.text.empty()) {
    out += fmt::format("ink(v) = v > {} ? 0x000000 : 0xffffff   # black upon light cells\n",
                       *range.min + 0.5 * (*range.max - *range.min));
    plot += ", \\\n     data using 1:2:6:(ink($5)) with labels noenhanced tc rgb variable font ',13'";
  }
  return out + script_end(plot + "\n", chart_height);
}

}  // namespace rift::studio
