#include "studio/reports/instruments_charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace rift::studio {

TraceScale scale_of(scene::Dimension dimension) {
  switch (dimension) {
    case scene::Dimension::force:
      return {1e-3, "kN"};
    case scene::Dimension::stress_intensity:
      return {1e-6, "MPa m^{1/2}"};
    case scene::Dimension::release_rate:
      return {1e-3, "kJ/m²"};
    case scene::Dimension::length:
      return {1e6, "µm"};
    case scene::Dimension::strain:
      return {1.0, ""};
    default:
      return {1.0, std::string(scene::si_unit(dimension))};
  }
}

namespace {

using Style = ChartSeries::Style;

constexpr std::size_t most_series = 12;
constexpr double most_cells = 5000;  // of a map

/// A trace against time, in its unit.
ChartSeries against_time(const measurement::Trace& trace, std::string label, Style style, int colour) {
  const double factor = scale_of(trace.dimension).factor;
  ChartSeries series{.label = std::move(label), .style = style, .colour = colour};
  for (std::size_t k = 0; k < trace.time.size(); ++k)
    series.add(1e6 * trace.time[k], factor * trace.value[k]);
  return series;
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
  Chart chart{.title = title, .x_label = "time [µs]"};
  int colour = 0;
  for (const Wanted& w : wanted) {
    const measurement::Trace* run = found(report.trace, w.name);
    if (!run) continue;
    const std::string unit = scale_of(run->dimension).unit;
    chart.y_label = fmt::format("{} [{}]", quantity, unit.empty() ? "-" : unit);
    chart.series.push_back(against_time(*run, w.label, Style::line, colour));
    if (const measurement::Trace* measured = found(report.measured, w.name))
      chart.series.push_back(against_time(*measured, w.label + ", measured", Style::points, colour));
    ++colour;
  }
  return {name, std::move(caption), std::move(chart)};
}

std::vector<NamedChart> gauge_charts(const InstrumentsReport& report) {
  struct Kind {
    const char *name, *title, *quantity;
  };
  std::vector<NamedChart> charts;
  for (const Kind& kind :
       {Kind{"strain_yy", "Strain of the gauges across the crack", "strain yy"},
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
                                  "Virtual gauges at the given positions, relative to the unloaded plate."));
  }
  return charts;
}

/// G of the field, what the damage zone takes, and what a crack without waves would release.
NamedChart field_rate_chart(const InstrumentsReport& report) {
  using Point = measurement::IntensityPoint;
  const std::vector<Point>& points = report.seen.intensity;
  return {
      "release_rate",
      "G from the stress intensities of the camera's field, G_ID from the energy balance, and the static "
      "reference G_I0.",
      Chart{.title = "Release rate by the field and by the energy balance",
            .x_label = "tip position [mm]",
            .y_label = "release rate [kJ/m²]",
            .y_range = {.min = 0.0},
            .series = {
                series_of("from K", Style::line_points, 1, points,
                          [](const Point& p) {
                            return ChartPoint{1e3 * p.tip, p.k ? 1e-3 * p.k->release_rate : NAN};
                          }),
                series_of("G_{ID} (energy balance)", Style::line, 0, points,
                          [](const Point& p) {
                            return ChartPoint{1e3 * p.tip, 1e-3 * p.g_id};
                          }),
                series_of("G_{I0}", Style::line, -1, points, [&](const Point& p) {
                  return ChartPoint{1e3 * p.tip, 1e-3 * (report.seen.g_i0 + report.seen.g_i0_slope * p.tip)};
                })}}};
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

std::vector<NamedChart> field_maps(const InstrumentsReport& report) {
  if (report.field.empty()) return {};
  std::vector<NamedChart> maps;
  const std::size_t last = report.field.size() - 1;
  for (const std::size_t k : {last / 2, last}) {
    const measurement::SeenField& field = report.field[k];
    const auto add = [&](const char* name, const char* title, const char* label, auto value) {
      HeatMap map = map_of(report, field, value);
      map.title = fmt::format("{}, tip at {:.1f} mm", title, 1e3 * field.tip), map.value_label = label;
      maps.push_back({fmt::format("{}_{}", name, k == last ? "end" : "half_way"),
                      "Field of the virtual camera; cells whose subset holds too few elements are empty.",
                      std::move(map)});
    };
    add("displacement_y", "Displacement across the crack", "u_y [µm]",
        [](const lattice::PlaneMotion& m) { return 1e6 * m.u.y(); });
    add("strain_yy", "Strain across the crack", "strain yy [10^{-3}]",
        [](const lattice::PlaneMotion& m) { return 1e3 * m.strain_yy(); });
    if (last == 0) break;
  }
  return maps;
}

std::vector<NamedChart> instrument_charts(const InstrumentsReport& report) {
  std::vector<NamedChart> charts{time_chart(report, "grip_force", "Force of the upper grip", "force",
                                            {{"grip_force", "grip"}},
                                            "Force of the upper grip across the crack.")};
  for (NamedChart& gauge : gauge_charts(report)) charts.push_back(std::move(gauge));
  charts.push_back(time_chart(
      report, "stress_intensity", "Stress intensity factors", "K", {{"k_i", "K_I"}, {"k_ii", "K_{II}"}},
      "Fitted to the camera field around the tip with the fields of a steadily running tip."));
  charts.push_back(field_rate_chart(report));
  return charts;
}

}  // namespace rift::studio
