#include "studio/report/stability_charts.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rift::studio {
namespace {

NamedChart growth_chart(const stability::GrowthCurve& curve) {
  NamedChart named{"growth", {}, {}};
  Chart& chart = named.chart;
  chart.title = "Where explicit integration ends";
  chart.x_label = "time step [2/{/Symbol w}_{max}]";
  chart.y_label = "growth of the highest mode [ln per step]";
  ChartSeries expected, seen;
  expected.label = "theory, arcosh(2 x^2 - 1)";
  expected.x = curve.step, expected.y = curve.expected;
  seen.label = "measured", seen.style = ChartSeries::Style::points, seen.colour = 1;
  seen.x = curve.step, seen.y = curve.seen;
  chart.series = {std::move(expected), std::move(seen)};
  chart.marks.push_back({curve.element_bound, curve.element_bound, "element bound"});
  chart.marks.push_back({curve.iterated, curve.iterated, "Lanczos"});
  double farthest = 0.0;
  for (std::size_t k = 0; k < curve.step.size(); ++k)
    farthest = std::max(farthest, std::abs(curve.seen[k] - curve.expected[k]));
  named.caption = fmt::format(
      "A lattice of 75 elements released in its highest mode: what a step does to its amplitude, fitted over "
      "all "
      "steps, against theory (largest distance {:.1e}). Up to the critical step nothing grows. The bound of "
      "the "
      "stiffest element is safe at {:.4f} of it; Lanczos iteration gives {:.6f}.",
      farthest, curve.element_bound, curve.iterated);
  return named;
}

/// Case by case, in the order of the table; zero residuals cannot be drawn.
ChartSeries residuals(const std::vector<stability::StabilityRow>& rows, const char* label, int colour,
                      stability::Seen stability::StabilityRow::*seen) {
  ChartSeries series;
  series.label = label, series.style = ChartSeries::Style::points, series.colour = colour;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const stability::Seen& s = rows[k].*seen;
    const bool kept = s.ending == stability::Ending::closes || s.ending == stability::Ending::open;
    if (!kept || !(s.residual > 0.0) || !std::isfinite(s.residual)) continue;
    series.x.push_back(static_cast<double>(k + 1)), series.y.push_back(s.residual);
  }
  return series;
}

NamedChart residual_chart(const std::vector<stability::StabilityRow>& rows) {
  NamedChart named{
      "residuals",
      "How far the energy books of each case that ran to its end are open, over the largest energy; the "
      "numbers are those of the table's rows. Corotational books close as the square of the step does.",
      {}};
  Chart& chart = named.chart;
  chart.title = "Books of stiff and extreme cases";
  chart.x_label = "case";
  chart.y_label = "largest residual of the books [-]";
  chart.log_y = true;
  chart.key_outside = true;
  chart.series = {residuals(rows, "double", 0, &stability::StabilityRow::in_double),
                  residuals(rows, "single", 1, &stability::StabilityRow::in_single)};
  std::erase_if(chart.series, [](const ChartSeries& s) { return s.x.empty(); });
  if (chart.series.empty()) return named;
  for (const auto& [limit, label] : {std::pair{1e-10, "limit, double"}, std::pair{1e-3, "limit, single"}}) {
    ChartSeries line{
        .label = label, .x = {1.0, static_cast<double>(rows.size())}, .y = {limit, limit}, .error = {}};
    line.colour = -1;
    chart.series.push_back(std::move(line));
  }
  return named;
}

}  // namespace

std::vector<NamedChart> stability_charts(const StabilityReport& report) {
  std::vector<NamedChart> charts;
  if (report.growth) charts.push_back(growth_chart(*report.growth));
  charts.push_back(residual_chart(report.rows));
  std::erase_if(charts, [](const NamedChart& named) { return named.chart.series.empty(); });
  return charts;
}

}  // namespace rift::studio
