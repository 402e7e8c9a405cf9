#include "engine/scene/spline.hpp"

#include <cmath>

namespace rift::scene {
namespace {

using Point = std::array<double, 2>;

/// Where the line from a (at time s) to b (at time e) is at t.
Point between(const Point& a, const Point& b, double s, double e, double t) {
  const double part = (t - s) / (e - s);
  return {a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])};
}

Point mirrored(const Point& end, const Point& next) { return {2 * end[0] - next[0], 2 * end[1] - next[1]}; }

double time_between(const Point& a, const Point& b) {
  return std::sqrt(std::hypot(b[0] - a[0], b[1] - a[1]));
}

/// The stretch from b to c, by the pyramid of Barry and Goldman (1988).
Point on_stretch(const std::array<Point, 4>& p, double part) {
  std::array<double, 4> t{};
  for (std::size_t k = 1; k < 4; ++k) t[k] = t[k - 1] + time_between(p[k - 1], p[k]);
  const double now = t[1] + part * (t[2] - t[1]);
  const Point a1 = between(p[0], p[1], t[0], t[1], now), a2 = between(p[1], p[2], t[1], t[2], now),
              a3 = between(p[2], p[3], t[2], t[3], now);
  return between(between(a1, a2, t[0], t[2], now), between(a2, a3, t[1], t[3], now), t[1], t[2], now);
}

}  // namespace

std::vector<Point> spline_through(const std::vector<Point>& point, int pieces) {
  std::vector<Point> out{point.front()};
  const std::size_t last = point.size() - 1;
  for (std::size_t k = 0; k < last; ++k) {
    const Point before = k > 0 ? point[k - 1] : mirrored(point[0], point[1]);
    const Point after = k + 2 <= last ? point[k + 2] : mirrored(point[last], point[last - 1]);
    for (int n = 1; n < pieces; ++n)
      out.push_back(on_stretch({before, point[k], point[k + 1], after}, static_cast<double>(n) / pieces));
    out.push_back(point[k + 1]);
  }
  return out;
}

}  // namespace rift::scene
