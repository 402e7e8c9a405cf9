#include "studio/report/echo_mark.hpp"

#include <algorithm>
#include <cmath>

namespace rift::studio {

ChartSeries echo_marks() { return {"first echo back", {}, {}, {}, ChartSeries::Style::points, -1}; }

void mark_echo(ChartSeries& marks, const ChartSeries& curve, double echo) {
  if (std::isnan(echo) || curve.x.empty() || echo < curve.x.front()) return;
  const auto after = std::lower_bound(curve.x.begin(), curve.x.end(), echo);
  if (after == curve.x.end()) return;
  marks.x.push_back(echo);
  marks.y.push_back(curve.y[static_cast<std::size_t>(after - curve.x.begin())]);
}

}  // namespace rift::studio
