#include "studio/reports/study_charts.hpp"

#include "engine/base/numbers.hpp"
#include "engine/base/world_error.hpp"
#include "engine/study/store.hpp"
#include "studio/reports/claim_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace rift::studio {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_together = 6;     // curves that are still told apart in one chart
constexpr std::size_t most_of_colour = 8;    // sequential colours that are still told apart
constexpr std::size_t most_oscillating = 4;  // raw curves that may lie over one another
constexpr std::size_t panels_of_a_chart = 12;

/// A curve with the axes that set it apart.
struct FamilyCurve {
  study::AxisTexts axes;
  std::vector<ChartSeries> series;  // the curve, and what belongs to it; the first has the label
};

/// The ordered axis with the most values of those that are varied, up to `most`; of several the later one,
/// which varies faster. Empty where there is none.
std::string colour_axis(const study::StudyRows& rows, const std::vector<std::string>& axes,
                        std::size_t most) {
  std::string chosen;
  std::size_t count = 1;
  for (const std::string& name : axes) {
    const std::size_t values = values_of_axis(rows, name).size();
    if (is_ordered_axis(rows, name) && values <= most && values >= count) chosen = name, count = values;
  }
  return chosen;
}

/// What the axes have beyond `varied` says nothing: all curves share it.
study::AxisTexts axes_of(const study::AxisTexts& axes, const std::vector<std::string>& varied,
                         const std::string& without = {}) {
  study::AxisTexts kept;
  for (const auto& axis : axes)
    if (axis.first != without && std::find(varied.begin(), varied.end(), axis.first) != varied.end())
      kept.push_back(axis);
  return kept;
}

/// All series of a curve but references look alike: `label` on the first, colour by the place among `of`.
void dress(FamilyCurve& curve, const std::string& label, std::size_t place, std::size_t of, bool ordered) {
  curve.series.front().label = label;
  for (ChartSeries& s : curve.series) {
    if (s.colour < 0) continue;
    if (&s != &curve.series.front()) s.name = label + ", " + s.label;
    s.colour = static_cast<int>(place);
    if (ordered) s.shade = of > 1 ? static_cast<double>(place) / static_cast<double>(of - 1) : 0.5;
  }
}

/// References stay last, above the curves, and those of one label are one series.
void move_into(std::vector<ChartSeries>& series, FamilyCurve& curve) {
  const auto is_reference = [](const ChartSeries& s) { return s.colour < 0; };
  for (ChartSeries& s : curve.series) {
    const auto references = std::find_if(series.begin(), series.end(), is_reference);
    const auto same = std::find_if(references, series.end(),
                                   [&](const ChartSeries& other) { return other.label == s.label; });
    if (!is_reference(s))
      series.insert(references, std::move(s));
    else if (same == series.end())
      series.push_back(std::move(s));
    else
      for (std::size_t k = 0; k < s.x.size(); ++k) same->add(s.x[k], s.y[k]);
  }
}

/// What all charts of these curves have in common.
struct Frame {
  std::string name, title, x_label, y_label, caption;
  AxisRange x_range = {}, y_range = {};
  std::vector<ChartSeries> references = {};  // in each panel
};

Chart one_chart(const Frame& frame, std::vector<FamilyCurve>& curves, const std::vector<std::string>& varied,
                bool ordered) {
  Chart chart{.title = frame.title,
              .x_label = frame.x_label,
              .y_label = frame.y_label,
              .x_range = frame.x_range,
              .y_range = frame.y_range};
  for (std::size_t k = 0; k < curves.size(); ++k) {
    dress(curves[k], axes_label(axes_of(curves[k].axes, varied)), k, curves.size(), ordered);
    move_into(chart.series, curves[k]);
  }
  chart.series.insert(chart.series.end(), frame.references.begin(), frame.references.end());
  return chart;
}

/// A panel for each combination of the axes but the coloured one.
std::vector<ChartPanel> panels_of(const Frame& frame, std::vector<FamilyCurve>& curves,
                                  const study::StudyRows& rows, const std::vector<std::string>& varied,
                                  const std::string& colour) {
  const std::vector<std::string> values = values_of_axis(rows, colour);
  std::vector<study::AxisTexts> places;
  std::vector<ChartPanel> panels;
  for (FamilyCurve& curve : curves) {
    const study::AxisTexts axes = axes_of(curve.axes, varied, colour);
    const auto found = std::find(places.begin(), places.end(), axes);
    const auto place = static_cast<std::size_t>(found - places.begin());
    if (found == places.end()) places.push_back(axes), panels.push_back({.title = axes_label(axes)});
    const std::string value = value_of_axis(curve.axes, colour);
    const auto at = std::find(values.begin(), values.end(), value);
    if (at == values.end())  // the axis does not apply, or there is none
      dress(curve, colour.empty() ? "rift" : "any " + axis_in_words(colour), 0, 1, false);
    else
      dress(curve, axes_label({{colour, value}}), static_cast<std::size_t>(at - values.begin()),
            values.size(), true);
    move_into(panels[place].series, curve);
  }
  for (ChartPanel& panel : panels)
    panel.series.insert(panel.series.end(), frame.references.begin(), frame.references.end());
  return panels;
}

/// Few curves in one chart, many as small multiples of at most `most` curves each.
std::vector<NamedChart> charts_of(const Frame& frame, std::vector<FamilyCurve> curves,
                                  const study::StudyRows& rows, const std::string& along,
                                  std::size_t together, std::size_t most) {
  std::vector<std::string> varied = varied_axes(rows);
  std::erase_if(varied, [&](const std::string& name) { return name == "seed" || name == along; });
  const std::string colour = colour_axis(rows, varied, most);
  if (curves.empty()) return {};
  if (curves.size() <= together)
    return {{frame.name, frame.caption,
             one_chart(frame, curves, varied, varied.size() == 1 && colour == varied.front())}};
  const std::vector<ChartPanel> panels = panels_of(frame, curves, rows, varied, colour);
  std::vector<NamedChart> charts;
  for (std::size_t from = 0; from < panels.size(); from += panels_of_a_chart) {
    const auto first = panels.begin() + static_cast<std::ptrdiff_t>(from);
    const auto last =
        panels.begin() + static_cast<std::ptrdiff_t>(std::min(panels.size(), from + panels_of_a_chart));
    charts.push_back({charts.empty() ? frame.name : fmt::format("{}_{}", frame.name, charts.size() + 1),
                      frame.caption,
                      ChartGrid{.title = frame.title,
                                .x_label = frame.x_label,
                                .y_label = frame.y_label,
                                .x_range = frame.x_range,
                                .y_range = frame.y_range,
                                .panels = {first, last}}});
  }
  return charts;
}

bool is_seen(const ChartSeries& series) {
  return std::any_of(series.y.begin(), series.y.end(), [](double y) { return std::isfinite(y); });
}

/// Mean over the rows of one velocity, velocities ascending; no bar where there is one row only.
ChartSeries against_velocity(const RowFamily& family) {
  std::map<double, std::vector<study::SummaryRow>> by_velocity;
  for (const study::SummaryRow& row : family.rows)
    if (!std::isnan(row.crack_velocity_over_cr)) by_velocity[row.crack_velocity_over_cr].push_back(row);
  return series_of("", ChartSeries::Style::line_points, 0, by_velocity, [](const auto& at) {
    const MeanScatter ratio = mean_over(at.second, &study::SummaryRow::ratio);
    return ChartPoint{at.first, ratio.mean, ratio.scatter};
  });
}

const study::SummaryRow& first_row(const study::StudyRows& rows) {
  return **std::find_if(rows.begin(), rows.end(), [](const auto& row) { return row.has_value(); });
}

}  // namespace

std::vector<NamedChart> velocity_charts(const study::StudyRows& rows) {
  if (values_of_axis(rows, "crack_velocity").size() < 2) return {};
  std::vector<FamilyCurve> curves;
  for (const RowFamily& family : families(rows, {"crack_velocity", "seed"}))
    if (ChartSeries series = against_velocity(family); is_seen(series))
      curves.push_back({family.rows.front().axes, {std::move(series)}});
  const study::SummaryRow& first = first_row(rows);
  return charts_of(
      {.name = "ratio_velocity",
       .title = "Release rate against crack velocity",
       .x_label = "crack velocity v / c_R, nominal c_R [-]",
       .y_label = "G_{ID} / G_{I0} [-]",
       .caption =
           "Mean over the measuring window; bars: standard deviation between specimens. Broberg, Freund and "
           "strip are theory.",
       .x_range = {.min = 0.0},
       .y_range = {.min = 0.0},
       .references = theory_curves(first.poisson_ratio,
                                   first.plane == "stress" ? theory::Plane::stress : theory::Plane::strain)},
      std::move(curves), rows, "crack_velocity", most_together, most_of_colour);
}

namespace {

/// A scenario's release rate over its tip [mm].
ChartSeries against_tip(const fs::path& csv) {
  const study::SeriesTable table = study::read_series(csv);
  if (table.empty()) throw base::WorldError("read", csv, "it holds no series");
  ChartSeries series{.x = {}, .y = {}};
  // A crack begins a damage zone before its start: outside the plate, where there is no notch.
  for (std::size_t k = 0; k < table.phase.size(); ++k)
    if (table.at("tip_m")[k] >= 0.0 && std::isfinite(table.at("ratio")[k]))
      series.add(1e3 * table.at("tip_m")[k], table.at("ratio")[k]);
  series.error.clear();
  return series;
}

/// The value at x between the points around it, NaN beyond them.
double value_at(const ChartSeries& series, double x) {
  if (series.x.size() < 2 || x < series.x.front() || x > series.x.back())
    return std::numeric_limits<double>::quiet_NaN();
  const auto [k, part] = base::interval_at(series.x, x);
  return std::lerp(series.y[k - 1], series.y[k], part);
}

/// The mean over the specimens at the positions of the first one, and a band from the least to the largest.
std::vector<ChartSeries> mean_and_band(const std::vector<ChartSeries>& specimens) {
  ChartSeries mean{.style = ChartSeries::Style::line},
      band{.label = "specimens, least to largest", .style = ChartSeries::Style::band};
  for (const double x : specimens.front().x) {
    std::vector<double> values;
    for (const ChartSeries& s : specimens)
      if (const double value = value_at(s, x); std::isfinite(value)) values.push_back(value);
    if (values.size() < specimens.size()) continue;
    const auto [least, largest] = std::minmax_element(values.begin(), values.end());
    mean.add(x, base::mean_of(values));
    band.add(x, 0.5 * (*least + *largest), 0.5 * (*largest - *least));
  }
  if (specimens.size() == 1) return {mean};
  return {mean, band};
}

/// Tip position up to which no echo has come back [mm]; NaN where the row does not know.
double echo_free_mm(const study::SummaryRow& row) { return 1e3 * row.echo_free_over_length * row.length_m; }

}  // namespace

std::vector<NamedChart> tip_charts(const study::StudyRows& rows, const std::vector<fs::path>& series) {
  std::vector<FamilyCurve> curves;
  bool bands = false, echoes = false;
  for (const RowFamily& family : families(rows, {"seed"})) {
    std::vector<ChartSeries> specimens;
    for (const study::SummaryRow& row : family.rows)
      if (ChartSeries s = against_tip(series[static_cast<std::size_t>(row.row)]); is_seen(s))
        specimens.push_back(std::move(s));
    if (specimens.empty()) continue;
    FamilyCurve curve{family.rows.front().axes, mean_and_band(specimens)};
    bands = bands || curve.series.size() > 1;
    ChartSeries echo = echo_marks();
    mark_echo(echo, curve.series.front(), echo_free_mm(family.rows.front()));
    echoes = echoes || !echo.x.empty();
    if (!echo.x.empty()) curve.series.push_back(std::move(echo));
    if (is_seen(curve.series.front())) curves.push_back(std::move(curve));
  }
  std::string caption = "Release rate against tip position, damping included, without any smoothing";
  if (bands) caption += "; mean over the specimens, the band reaches from the least to the largest of them";
  if (echoes) caption += "; the dot marks where the first boundary reflection reaches the tip";
  return charts_of({.name = "ratio_tip",
                    .title = "Release rate against tip position",
                    .x_label = "tip position [mm]",
                    .y_label = "G_{ID} / G_{I0} [-]",
                    .caption = caption + "."},
                   std::move(curves), rows, "", most_oscillating, most_oscillating);
}

}  // namespace rift::studio
