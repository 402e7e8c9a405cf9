#include "studio/charts/chart.hpp"

#include "engine/base/files.hpp"
#include "engine/base/world_error.hpp"
#include "studio/charts/chart_script.hpp"
#include "studio/charts/gnuplot.hpp"
#include "studio/charts/label.hpp"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cmath>

namespace rift::studio {

namespace fs = std::filesystem;
namespace {

[[maybe_unused]] bool is_chart_name(const std::string& name) {
  const auto allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; };
  return !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) != 0 &&
         std::all_of(name.begin(), name.end(), allowed);
}

template <class AnyChart>  // Chart or ChartGrid
bool any_shown(const AnyChart& chart, const std::vector<ChartSeries>& series) {
  const auto shown = [&](const ChartSeries& s) {
    const auto points = drawable_points(s);
    return std::any_of(points.begin(), points.end(), [&](std::size_t k) {
      return (!chart.log_x || s.x[k] > 0.0) && (!chart.log_y || s.y[k] > 0.0);
    });
  };
  return std::any_of(series.begin(), series.end(), shown);
}

bool has_points(const Chart& chart) { return any_shown(chart, chart.series); }

bool has_points(const ChartGrid& grid) {
  return std::any_of(grid.panels.begin(), grid.panels.end(),
                     [&](const ChartPanel& panel) { return any_shown(grid, panel.series); });
}

bool has_points(const HeatMap& map) {
  return std::any_of(map.value.begin(), map.value.end(), [](double v) { return std::isfinite(v); });
}

[[maybe_unused]] bool is_whole(const ChartSeries& s) {
  return s.x.size() == s.y.size() && (s.error.empty() || s.error.size() == s.x.size()) &&
         (s.text.empty() || s.text.size() == s.x.size());
}

template <class AnyChart>  // Chart, ChartGrid or HeatMap
DrawnChart draw(const AnyChart& chart, const fs::path& given, const std::string& name) {
  assert(is_chart_name(name));
  const fs::path folder = given.empty() ? fs::path(".") : given;
  if (!has_points(chart)) throw base::WorldError("draw", folder / name, "the chart has no points");
  base::make_folder(folder);
  DrawnChart drawn{folder / (name + ".svg"),
                   folder / (name + ".png"),
                   folder / (name + ".csv"),
                   folder / (name + ".gp"),
                   {}};
  base::write_whole_file(drawn.data, chart_data(chart));
  base::write_whole_file(drawn.script, chart_script(chart, name));
  run_script(folder, name);
  drawn.svg_text = inline_svg(base::read_whole_file(drawn.svg), name, plain_text(chart.title));
  return drawn;
}

}  // namespace

void shade_in_order(std::vector<ChartSeries>& series) {
  for (std::size_t k = 0; k < series.size(); ++k)
    series[k].shade =
        series.size() > 1 ? static_cast<double>(k) / static_cast<double>(series.size() - 1) : 0.5;
}

DrawnChart draw_chart(const Chart& chart, const fs::path& folder, const std::string& name) {
  assert(std::all_of(chart.series.begin(), chart.series.end(), is_whole));
  return draw(chart, folder, name);
}

DrawnChart draw_chart(const ChartGrid& grid, const fs::path& folder, const std::string& name) {
  for ([[maybe_unused]] const ChartPanel& panel : grid.panels)
    assert(std::all_of(panel.series.begin(), panel.series.end(), is_whole));
  return draw(grid, folder, name);
}

DrawnChart draw_chart(const HeatMap& map, const fs::path& folder, const std::string& name) {
  assert(map.value.size() == map.x.size() * map.y.size());
  assert(map.text.empty() || map.text.size() == map.value.size());
  return draw(map, folder, name);
}

std::vector<NamedChart> those_with_points(std::vector<NamedChart> charts) {
  const auto empty = [](const NamedChart& named) {
    return std::visit([](const auto& chart) { return !has_points(chart); }, named.chart);
  };
  std::erase_if(charts, empty);
  return charts;
}

DrawnChart draw_chart(const NamedChart& named, const fs::path& folder) {
  return std::visit([&](const auto& chart) { return draw_chart(chart, folder, named.name); }, named.chart);
}

}  // namespace rift::studio
