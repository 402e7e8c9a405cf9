#include "studio/report/echo_mark.hpp"

#include <algorithm>
#include <cmath>

namespace rift::studio {

ChartSeries echo_marks() { return {"first echo back", {}, {}, {}, ChartSeries::Style::points, -1}; }

void mark_echo(ChartSeries& marks, const ChartSeries& curve, double echo) {
  if (std::isnan(echo) || curve.x.empty() || echo < curve.x.front()) return;
  const auto after = std::lower_bound(curve.x.begin() + 1, curve.x.end(), echo) - curve.x.begin();
  const auto k = static_cast<std::size_t>(after);
  if (k >= curve.x.size()) return;
  const double part = (echo - curve.x[k - 1]) / (curve.x[k] - curve.x[k - 1]);
  marks.x.push_back(echo);
  marks.y.push_back(curve.y[k - 1] + part * (curve.y[k] - curve.y[k - 1]));
}

}  // namespace rift::studio
