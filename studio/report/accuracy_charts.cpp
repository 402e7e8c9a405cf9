#include "studio/report/accuracy_charts.hpp"

#include "engine/study/curve.hpp"
#include "studio/report/label.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rift::studio {
namespace {

constexpr double smallest_drawn = 1e-7;  // errors below it are rounding, of no use in a chart

/// Points of a logarithmic chart, and how many of them could not be drawn.
struct Points {
  ChartSeries series;
  int left_out = 0;

  void add(double x, double error) {
    if (!std::isfinite(x) || !std::isfinite(error)) return;
    if (std::abs(error) < smallest_drawn) {
      ++left_out;
      return;
    }
    series.x.push_back(x);
    series.y.push_back(std::abs(error));
  }
};

std::string left_out_text(int count) {
  if (count == 0) return {};
  return fmt::format(" {} with an error below {:g}, the references among them, cannot be drawn.", count,
                     smallest_drawn);
}

const char* series_label(study::Knob knob) {
  switch (knob) {
    case study::Knob::scene:
      return "the scene as it is";
    case study::Knob::time_step:
      return "time step, double";
    case study::Knob::precision:
      return "time step, single";
    case study::Knob::together:
      return "single, few samples";
    case study::Knob::prestress:
      return "ramp instead of statics";
    case study::Knob::samples:
      return "number of samples";
    default:
      return "elements, to the finest";
  }
}

/// A line leads from step to step; elements scatter too much to be joined.
ChartSeries::Style style_of(study::Knob knob) {
  const bool steps =
      knob == study::Knob::time_step || knob == study::Knob::precision || knob == study::Knob::together;
  return steps ? ChartSeries::Style::line_points : ChartSeries::Style::points;
}

/// A level line from the cheapest to the dearest point.
ChartSeries level(const std::string& label, double y, double from, double to) {
  ChartSeries series{.label = label, .x = {from, to}, .y = {y, y}, .error = {}};
  series.colour = -1;
  return series;
}

NamedChart work_precision(const study::Accuracy& accuracy, double goal) {
  NamedChart named{"work_precision", {}, {}};
  Chart& chart = named.chart;
  chart.title = "What accuracy costs";
  chart.x_label = "wall time of the march [s]";
  chart.y_label = "|error of G_{ID}/G_{I0}| [-]";
  chart.log_x = chart.log_y = true;
  chart.key_outside = true;
  int left_out = 0;
  double from = INFINITY, to = 0.0;
  constexpr study::Knob knobs[] = {study::Knob::time_step, study::Knob::precision, study::Knob::together,
                                   study::Knob::elements,  study::Knob::samples,   study::Knob::prestress,
                                   study::Knob::scene};
  for (const study::Knob knob : knobs) {
    Points points;
    points.series.label = series_label(knob);
    points.series.style = style_of(knob);
    points.series.colour = static_cast<int>(chart.series.size());
    for (const study::AccuracyLine& line : accuracy.lines)
      if (line.knob == knob && line.cannot_be.empty() && line.wall_s > 0.0)
        points.add(line.wall_s, knob == study::Knob::elements ? line.error : line.step_error);
    left_out += points.left_out;
    if (points.series.x.empty()) continue;
    from = std::min(from, *std::min_element(points.series.x.begin(), points.series.x.end()));
    to = std::max(to, *std::max_element(points.series.x.begin(), points.series.x.end()));
    chart.series.push_back(std::move(points.series));
  }
  if (chart.series.empty()) return named;
  chart.series.push_back(level(fmt::format("goal {:g}", goal), goal, from, to));
  if (accuracy.specimen_scatter > smallest_drawn)
    chart.series.push_back(level("scatter of specimens", accuracy.specimen_scatter, from, to));
  if (accuracy.recommended >= 0) {
    const study::AccuracyLine& best = accuracy.lines[static_cast<std::size_t>(accuracy.recommended)];
    chart.marks.push_back({best.wall_s, best.wall_s, "recommended: " + escape_label(best.label)});
  }
  named.caption =
      "Error and the time that the march takes, each variant computed by itself: down and to the left is "
      "better. "
      "Errors are against the converged step on the scene's own specimen, those of elements against the "
      "finest "
      "lattice, means over the specimens; an error of elements below their scatter is not resolved.";
  named.caption += left_out_text(left_out);
  return named;
}

/// C h^p through the second finest step that is drawn, over all of them.
ChartSeries order_line(const ChartSeries& steps, double order, const std::string& label) {
  ChartSeries series;
  series.label = label;
  series.colour = -1;
  const std::size_t at = std::min<std::size_t>(1, steps.x.size() - 1);
  for (const std::size_t k : {std::size_t{0}, steps.x.size() - 1}) {
    series.x.push_back(steps.x[k]);
    series.y.push_back(steps.y[at] * std::pow(steps.x[k] / steps.x[at], order));
  }
  return series;
}

NamedChart error_step(const study::Accuracy& accuracy) {
  NamedChart named{"error_step", {}, {}};
  Chart& chart = named.chart;
  chart.title = "Error of the time step, on one and the same specimen";
  chart.x_label = "time step [dt_c]";
  chart.y_label = "|error of G_{ID}/G_{I0}| against the converged step [-]";
  chart.log_x = chart.log_y = true;
  int left_out = 0;
  for (const study::Knob knob : {study::Knob::time_step, study::Knob::precision}) {
    Points points;
    const bool in_double = knob == study::Knob::time_step;
    points.series.style = in_double ? ChartSeries::Style::line_points : ChartSeries::Style::points;
    points.series.colour = in_double ? 0 : 1;
    points.series.label = in_double ? "double" : "single";
    for (const study::AccuracyLine& line : accuracy.lines)
      if (line.knob == knob && line.cannot_be.empty()) points.add(line.value, line.step_error);
    left_out += points.left_out;
    if (!points.series.x.empty()) chart.series.push_back(std::move(points.series));
  }
  named.caption = "Error of the release rate over the step in parts of the critical one.";
  for (const study::KnobReference& r : accuracy.reference) {
    if (r.knob != study::Knob::time_step || chart.series.empty()) continue;
    const study::Convergence& c = r.convergence;
    named.caption += " In double: " + c.text + ".";
    ChartSeries& in_double = chart.series.front();
    if (c.clean) in_double.label = fmt::format("double, observed order {:.2f}", c.order);
    const ChartSeries guide = c.clean ? order_line(in_double, c.order, fmt::format("order {:.2f}", c.order))
                                      : order_line(in_double, 2.0, "order 2, for comparison");
    chart.series.push_back(guide);
  }
  named.caption += left_out_text(left_out);
  return named;
}

NamedChart ratio_elements(const std::vector<study::Tried>& tried, const study::Accuracy& accuracy) {
  NamedChart named{"ratio_elements",
                   "Ratio over the number of elements, mean of the specimens at each; bars: their standard "
                   "deviation, each specimen being packed at random.",
                   {}};
  Chart& chart = named.chart;
  chart.title = "Release rate against the number of elements";
  chart.x_label = "elements";
  chart.y_label = "G_{ID} / G_{I0} [-]";
  chart.log_x = true;
  ChartSeries mean, each;
  mean.label = "mean of the specimens", mean.style = ChartSeries::Style::line_points;
  each.label = "each specimen", each.style = ChartSeries::Style::points, each.colour = 1;
  for (const study::AccuracyLine& line : accuracy.lines) {
    if (line.knob != study::Knob::elements || !std::isfinite(line.ratio)) continue;
    mean.x.push_back(line.value), mean.y.push_back(line.ratio), mean.error.push_back(line.scatter);
    for (const int k : line.tried) {
      const study::SummaryRow& row = tried[static_cast<std::size_t>(k)].row;
      if (row.is_object())
        each.x.push_back(line.value), each.y.push_back(study::number_in(row, "ratio_with_damping"));
    }
  }
  if (mean.x.size() < 2) return named;
  const double broberg = study::number_in(tried.front().row, "broberg");
  const double first = mean.x.front(), last = mean.x.back();
  chart.series = {std::move(mean), std::move(each)};
  if (std::isfinite(broberg)) chart.series.push_back(level("Broberg", broberg, first, last));
  return named;
}

}  // namespace

std::vector<NamedChart> accuracy_charts(const std::vector<study::Tried>& tried,
                                        const study::Accuracy& accuracy, double goal) {
  std::vector<NamedChart> charts{work_precision(accuracy, goal), error_step(accuracy),
                                 ratio_elements(tried, accuracy)};
  std::erase_if(charts, [](const NamedChart& named) { return named.chart.series.empty(); });
  return charts;
}

}  // namespace rift::studio
