#include "studio/report/velocity_chart.hpp"

#include "engine/theory/references.hpp"

namespace rift::studio {
namespace {

ChartSeries reference(const std::string& label, theory::Factor (*of)(double, double, theory::Plane)) {
  ChartSeries series{label, {}, {}, {}, ChartSeries::Style::dashed, -1};
  for (int k = 0; k <= 100; ++k) {
    series.x.push_back(0.01 * k);
    series.y.push_back(of(0.01 * k, 0.3, theory::Plane::stress).g);
  }
  return series;
}

}  // namespace

Chart chart_of_references(const std::string& title) {
  Chart chart;
  chart.title = title;
  chart.x_label = "crack velocity v / c_r [-]";
  chart.y_label = "G_{ID} / G_{I0} [-]";
  chart.x_range = {0.0, 1.05};
  chart.y_range = {0.0, {}};
  chart.key_outside = true;
  chart.series = {reference("Broberg", theory::broberg), reference("Freund", theory::freund),
                  reference("strip", theory::strip)};
  return chart;
}

}  // namespace rift::studio
