#include "studio/reports/instruments_charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <utility>

namespace rift::studio {
namespace {

using Style = ChartSeries::Style;

constexpr std::size_t most_series = 12;
constexpr double most_cells = 5000;  // of a map

ChartSeries series_of(const measurement::Trace& trace, std::string label, Style look, int colour) {
  const TraceScale scale = scale_of(trace.dimension);
  ChartSeries s;
  s.label = std::move(label), s.style = look, s.colour = colour;
  for (std::size_t k = 0; k < trace.time.size(); ++k)
    s.x.push_back(1e6 * trace.time[k]), s.y.push_back(scale.factor * trace.value[k]);
  return s;
}

const measurement::Trace* found(const std::vector<measurement::Trace>& traces, const std::string& name) {
  const auto at =
      std::find_if(traces.begin(), traces.end(), [&](const measurement::Trace& t) { return t.name == name; });
  const auto seen = [](double value) { return std::isfinite(value); };
  const bool any = at != traces.end() && std::any_of(at->value.begin(), at->value.end(), seen);
  return any ? &*at : nullptr;
}

/// A trace and what was measured of it, in one colour.
struct Wanted {
  std::string name, label;
};

NamedChart time_chart(const InstrumentsReport& report, const char* name, const char* title,
                      const char* quantity, const std::vector<Wanted>& wanted, std::string caption) {
  NamedChart named{name, std::move(caption), {}};
  named.chart.title = title, named.chart.x_label = "time [us]";
  named.chart.key_outside = wanted.size() > 2 || !report.measured.empty();
  int colour = 0;
  for (const Wanted& w : wanted) {
    const measurement::Trace* run = found(report.trace, w.name);
    const measurement::Trace* measured = found(report.measured, w.name);
    if (!run) continue;
    const std::string unit = scale_of(run->dimension).unit;
    named.chart.y_label = fmt::format("{} [{}]", quantity, unit.empty() ? "-" : unit);
    named.chart.series.push_back(series_of(*run, w.label, Style::line, colour));
    if (measured)
      named.chart.series.push_back(series_of(*measured, w.label + ", measured", Style::points, colour));
    ++colour;
  }
  return named;
}

std::vector<NamedChart> gauge_charts(const InstrumentsReport& report) {
  struct Kind {
    const char *name, *title, *quantity;
  };
  std::vector<NamedChart> charts;
  for (const Kind& kind :
       {Kind{"strain_yy", "Strain across the crack", "strain yy"},
        Kind{"strain_xx", "Strain along the crack", "strain xx"},
        Kind{"strain_xy", "Shear strain", "strain xy"}, Kind{"vy", "Velocity across the crack", "velocity y"},
        Kind{"vx", "Velocity along the crack", "velocity x"}}) {
    std::vector<Wanted> gauges;
    for (int g = 0; gauges.size() < most_series; ++g) {
      const measurement::Trace* trace = found(report.trace, fmt::format("gauge{}_{}", g, kind.name));
      if (!trace) break;
      const auto row = std::find_if(report.seen.gauges.begin(), report.seen.gauges.end(),
                                    [&](const results::GaugeRow& r) { return r.gauge == g; });
      gauges.push_back(
          {trace->name, fmt::format("{}: ({:.4g}, {:.4g}) mm", g, 1e3 * row->x_m, 1e3 * row->y_m)});
    }
    if (!gauges.empty())
      charts.push_back(time_chart(report, kind.name, kind.title, kind.quantity, gauges,
                                  "Virtual gauges, by their place, since the unloaded plate."));
  }
  return charts;
}

/// G of the field, what the damage zone takes, and what a crack without waves would release.
NamedChart rate_chart(const InstrumentsReport& report) {
  NamedChart named{
      "release_rate",
      "What arrives at the tip, by the stress intensities of the camera's field, what the damage zone "
      "takes of it, by the lattice's books, and G_I0.",
      {}};
  named.chart.title = "Release rate", named.chart.x_label = "tip position [mm]";
  named.chart.y_label = "release rate [kJ/m^2]", named.chart.y_range.min = 0.0;
  named.chart.key_outside = true;
  ChartSeries field, books, still;
  field.label = "of the field", field.style = Style::line_points, field.colour = 1;
  books.label = "G_{ID} of the books", books.style = Style::line, books.colour = 0;
  still.label = "G_{I0}", still.style = Style::line, still.colour = -1;
  for (const measurement::IntensityPoint& p : report.seen.intensity) {
    const double tip = 1e3 * p.tip;
    field.x.push_back(tip), field.y.push_back(p.k ? 1e-3 * p.k->release_rate : std::nan(""));
    books.x.push_back(tip), books.y.push_back(1e-3 * p.g_id);
    still.x.push_back(tip), still.y.push_back(1e-3 * (report.seen.g_i0 + report.seen.g_i0_slope * p.tip));
  }
  named.chart.series = {std::move(field), std::move(books), std::move(still)};
  return named;
}

bool has_points(const NamedChart& named) {
  return std::any_of(named.chart.series.begin(), named.chart.series.end(), [](const ChartSeries& s) {
    return std::any_of(s.y.begin(), s.y.end(), [](double y) { return std::isfinite(y); });
  });
}

/// To a tenth, as a tick is labelled.
double mm(double metres) { return 0.1 * std::round(1e4 * metres); }

/// Every so manieth point of the grid, as a map.
HeatMap map_of(const InstrumentsReport& report, const measurement::SeenField& field,
               const std::function<double(const lattice::PlaneMotion&)>& value) {
  const measurement::Grid& grid = report.seen.grid;
  const int stride = std::max(
      1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(grid.point.size()) / most_cells))));
  HeatMap map;
  map.x_label = "x [mm]", map.y_label = "y [mm]";
  for (int i = 0; i < grid.columns; i += stride) map.x.push_back(mm(grid.point[i].x()));
  for (int j = 0; j < grid.rows; j += stride) {
    map.y.push_back(mm(grid.point[static_cast<std::size_t>(j) * grid.columns].y()));
    for (int i = 0; i < grid.columns; i += stride) {
      const auto& motion = field.motion[static_cast<std::size_t>(j) * grid.columns + i];
      map.value.push_back(motion ? value(*motion) : std::numeric_limits<double>::quiet_NaN());
    }
  }
  return map;
}

}  // namespace

TraceScale scale_of(scene::Dimension dimension) {
  switch (dimension) {
    case scene::Dimension::force:
      return {1e-3, "kN"};
    case scene::Dimension::stress_intensity:
      return {1e-6, "MPa m^{1/2}"};
    case scene::Dimension::release_rate:
      return {1e-3, "kJ/m^2"};
    case scene::Dimension::length:
      return {1e6, "um"};
    case scene::Dimension::strain:
      return {1.0, ""};
    default:
      return {1.0, std::string(scene::si_unit(dimension))};
  }
}

std::vector<NamedChart> instrument_charts(const InstrumentsReport& report) {
  std::vector<NamedChart> charts{time_chart(report, "grip_force", "Force of the upper grip", "force",
                                            {{"grip_force", "grip"}},
                                            "With which the upper grip pulls across the crack.")};
  for (NamedChart& gauge : gauge_charts(report)) charts.push_back(std::move(gauge));
  charts.push_back(
      time_chart(report, "stress_intensity", "Stress intensities", "K", {{"k_i", "K_I"}, {"k_ii", "K_{II}"}},
                 "Fitted to the camera's field around the tip, with the waves of a running tip."));
  charts.push_back(rate_chart(report));
  std::erase_if(charts, [](const NamedChart& named) { return !has_points(named); });
  return charts;
}

std::vector<NamedMap> field_maps(const InstrumentsReport& report) {
  if (report.field.empty()) return {};
  std::vector<NamedMap> maps;
  const std::size_t last = report.field.size() - 1;
  for (const std::size_t k : {last / 2, last}) {
    const measurement::SeenField& field = report.field[k];
    const std::string when = fmt::format("tip at {:.1f} mm", 1e3 * field.tip);
    const auto add = [&](const char* name, const char* title, const char* label, auto value) {
      NamedMap named{fmt::format("{}_{}", name, k == last ? "end" : "half_way"),
                     "As a camera sees it; where a subset has lost its hold nothing is shown.",
                     map_of(report, field, value)};
      named.map.title = fmt::format("{}, {}", title, when), named.map.value_label = label;
      maps.push_back(std::move(named));
    };
    add("displacement_y", "Displacement across the crack", "u_y [um]",
        [](const lattice::PlaneMotion& m) { return 1e6 * m.u.y(); });
    add("strain_yy", "Strain across the crack", "strain yy [10^{-3}]",
        [](const lattice::PlaneMotion& m) { return 1e3 * m.strain_yy(); });
    if (last == 0) break;
  }
  std::erase_if(maps, [](const NamedMap& named) {
    return std::none_of(named.map.value.begin(), named.map.value.end(),
                        [](double v) { return std::isfinite(v); });
  });
  return maps;
}

}  // namespace rift::studio
