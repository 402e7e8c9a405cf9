#include "studio/report/calibration_charts.hpp"

#include "engine/calibration/calibrate.hpp"
#include "engine/study/curve.hpp"

#include <fmt/format.h>

#include <map>

namespace rift::studio {
namespace {

using Style = ChartSeries::Style;

/// Mean and deviation of one number over the rows that share another.
ChartSeries series_of(const std::vector<study::SummaryRow>& rows, const std::string& of,
                      const std::string& label, const std::string& x, const std::string& y, double scale,
                      int colour) {
  std::map<double, std::vector<double>> values;
  for (const study::SummaryRow& row : rows)
    if (row.at("series") == of && row.at(y).is_number())
      values[study::number_in(row, x.c_str())].push_back(scale * study::number_in(row, y.c_str()));
  ChartSeries series{label, {}, {}, {}, Style::line_points, colour};
  for (const auto& [at, all] : values) {
    const calibration::Scattered s = calibration::scattered(all);
    series.x.push_back(at), series.y.push_back(s.mean), series.error.push_back(s.deviation);
  }
  return series;
}

/// One point a packing, for what has no two packings of the same abscissa.
ChartSeries cloud_of(const std::vector<study::SummaryRow>& rows, const std::string& of,
                     const std::string& label, const std::string& x, const std::string& y, double scale,
                     int colour) {
  ChartSeries series{label, {}, {}, {}, Style::points, colour};
  for (const study::SummaryRow& row : rows)
    if (row.at("series") == of)
      series.x.push_back(study::number_in(row, x.c_str())),
          series.y.push_back(scale * study::number_in(row, y.c_str()));
  return series;
}

ChartSeries level(const std::string& label, double value, const AxisRange& x) {
  return {label, {*x.min, *x.max}, {value, value}, {}, Style::dashed, -1};
}

Chart against_size(const std::vector<study::SummaryRow>& rows, const std::string& y_label) {
  Chart chart;
  chart.x_label = "elements N [-]";
  chart.y_label = y_label;
  chart.log_x = true;
  double low = 1e300, high = 0.0;
  for (const study::SummaryRow& row : rows)
    if (row.at("series") == "size")
      low = std::min(low, study::number_in(row, "elements")),
      high = std::max(high, study::number_in(row, "elements"));
  chart.x_range = {0.8 * low, 1.25 * high};
  return chart;
}

NamedChart young_against_size(const std::vector<study::SummaryRow>& rows, double micro) {
  Chart chart = against_size(rows, "E_M [GPa]");
  chart.title = fmt::format(
      "Young's modulus of cylinders, E_{{/Symbol m}} = {:.0f} GPa, r_{{/Symbol m}} = 0.3", micro / 1e9);
  chart.series = {
      series_of(rows, "size", "strain of the middle half", "elements", "young_over_micro", micro / 1e9, 0),
      series_of(rows, "size", "shortening between the ends", "elements", "young_ends_over_micro", micro / 1e9,
                1),
      level("paper, Table 2", 10.3, chart.x_range)};
  return {"calibration_young",
          "E of compressed cylinders against their number of elements; bars: standard deviation over the "
          "packings.",
          chart};
}

NamedChart poisson_against_size(const std::vector<study::SummaryRow>& rows) {
  Chart chart = against_size(rows, "{/Symbol n}_M [-]");
  chart.title = "Poisson's ratio of cylinders, r_{/Symbol m} = 0.3";
  chart.series = {series_of(rows, "size", "cylinders", "elements", "poisson_ratio", 1.0, 0),
                  level("paper, Table 2", 0.3, chart.x_range)};
  return {"calibration_poisson",
          "nu of compressed cylinders against their number of elements; bars: standard deviation over the "
          "packings.",
          chart};
}

NamedChart young_against_core(const std::vector<study::SummaryRow>& rows, double micro) {
  Chart chart;
  chart.title = "Young's modulus against the coordination of the core";
  chart.x_label = "coordination away from the walls [-]";
  chart.y_label = "E_M [GPa]";
  chart.series = {
      cloud_of(rows, "size", "cylinders", "core_coordination", "young_over_micro", micro / 1e9, 0),
      cloud_of(rows, "box", "periodic boxes", "core_coordination", "young_over_micro", micro / 1e9, 1)};
  return {"calibration_core",
          "A coordination of 6 over all elements, which have fewer contacts at the walls, leaves more of "
          "them to the "
          "core the smaller the cylinder: this, not the number of elements, is what E follows.",
          chart};
}

NamedChart young_of_scan(const std::vector<study::SummaryRow>& rows) {
  Chart chart;
  chart.title = "Scan of the beams' radius: modulus";
  chart.x_label = "radius ratio r_{/Symbol m} [-]";
  chart.y_label = "E_M / E_{/Symbol m} [-]";
  chart.log_x = chart.log_y = true;
  chart.series = {series_of(rows, "scan", "cylinders, {/Symbol n}_{/Symbol m} = 0.3", "micro_radius_ratio",
                            "young_over_micro", 1.0, 0)};
  return {"calibration_scan_young",
          "Every modulus is proportional to E_mu, which is not scanned: E_M = E_mu times what is shown.",
          chart};
}

NamedChart poisson_of_scan(const std::vector<study::SummaryRow>& rows) {
  Chart chart;
  chart.title = "Scan of the beams' radius: Poisson's ratio";
  chart.x_label = "radius ratio r_{/Symbol m} [-]";
  chart.y_label = "{/Symbol n}_M [-]";
  chart.series = {
      series_of(rows, "scan", "{/Symbol n}_{/Symbol m} = 0.3", "micro_radius_ratio", "poisson_ratio", 1.0, 0),
      cloud_of(rows, "twisted", "{/Symbol n}_{/Symbol m} = 0 and 0.45", "micro_radius_ratio", "poisson_ratio",
               1.0, 1),
      {"paper, Table 2", {0.3}, {0.3}, {}, Style::points, -1}};
  return {"calibration_scan_poisson", "nu follows r_mu and hardly knows nu_mu, which only twists beams.",
          chart};
}

}  // namespace

std::vector<NamedChart> calibration_charts(const std::vector<study::SummaryRow>& rows,
                                           double micro_young_modulus) {
  return {young_against_size(rows, micro_young_modulus), poisson_against_size(rows),
          young_against_core(rows, micro_young_modulus), young_of_scan(rows), poisson_of_scan(rows)};
}

}  // namespace rift::studio
