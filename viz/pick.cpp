#include "viz/pick.hpp"

#include "viz/front_layer.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rift::viz {
namespace {

using Point = std::array<double, 3>;

double along(const Point& direction, const Point& p) {
  return direction[0] * p[0] + direction[1] * p[1] + direction[2] * p[2];
}

/// Where an element is drawn, in metres from the middle of the picture: right, up, towards the eye.
Point seen_at(const Standing& s, std::int32_t i) {
  Point p{};
  for (int axis = 0; axis < 3; ++axis) {
    const float moved = s.displacement.empty() ? 0 : s.magnification[axis] * s.displacement[i][axis];
    p[axis] = s.geometry.position[i][axis] + moved;
  }
  p[0] -= s.window.x, p[1] -= s.window.y;
  return {along(s.axes.right, p), along(s.axes.up, p), along(s.axes.out, p)};
}

std::array<double, 2> from_middle(const Standing& s, const std::array<double, 2>& pixel) {
  return {s.window.width * ((pixel[0] - s.box.x0) / s.box.width() - 0.5),
          s.window.height * ((pixel[1] - s.box.y0) / s.box.height() - 0.5)};
}

double distance_to_line(const std::array<double, 2>& p, const Point& a, const Point& b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1], length2 = dx * dx + dy * dy;
  const double part =
      length2 > 0 ? std::clamp(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / length2, 0.0, 1.0) : 0.0;
  return std::hypot(p[0] - a[0] - part * dx, p[1] - a[1] - part * dy);
}

}  // namespace

float sphere_scale(const Look& look) {
  if (look.beams == Beams::all) return 0.6F;
  return look.camera == Camera::plate || look.camera == Camera::free ? 1.15F : 1.0F;
}

std::array<float, 3> magnification_of(const Look& look) {
  const auto m = static_cast<float>(look.magnification);
  return look.camera == Camera::side ? std::array{1.0F, 1.0F, m} : std::array{m, m, m};
}

std::vector<std::int32_t> elements_shown(const Look& look, const results::Geometry& geometry) {
  if (!look.spheres) return {};
  if (seen_from_front(look) && look.beams != Beams::all) return front_layer(geometry);
  std::vector<std::int32_t> all(geometry.position.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

std::optional<std::int32_t> element_at(const Standing& standing, std::span<const std::int32_t> shown,
                                       float scale, const std::array<double, 2>& pixel) {
  const auto at = from_middle(standing, pixel);
  std::optional<std::int32_t> nearest;
  double depth = 0;
  for (const std::int32_t i : shown) {
    const Point p = seen_at(standing, i);
    const double r = scale * standing.geometry.radius[i], dx = p[0] - at[0], dy = p[1] - at[1];
    const double under = r * r - dx * dx - dy * dy;
    if (under < 0) continue;
    const double surface = p[2] + std::sqrt(under);
    if (nearest && surface <= depth) continue;
    nearest = i;
    depth = surface;
  }
  return nearest;
}

std::optional<std::int32_t> beam_at(const Standing& standing, Beams shown,
                                    const std::array<double, 2>& pixel) {
  constexpr double near_px = 3;
  if (shown == Beams::none) return std::nullopt;
  const results::Geometry& g = standing.geometry;
  std::vector<std::int32_t> beams = g.crossing;
  if (shown == Beams::all) {
    beams.resize(g.beam.size());
    std::iota(beams.begin(), beams.end(), 0);
  }
  const auto at = from_middle(standing, pixel);
  double least = near_px * standing.window.height / standing.box.height();
  std::optional<std::int32_t> nearest;
  for (const std::int32_t b : beams) {
    const double distance =
        distance_to_line(at, seen_at(standing, g.beam[b][0]), seen_at(standing, g.beam[b][1]));
    if (distance > least) continue;
    nearest = b;
    least = distance;
  }
  return nearest;
}

std::optional<results::GaugeRow> nearest_gauge(std::span<const results::GaugeRow> rows, const Point& point,
                                               double time_s) {
  const auto away = [&](const results::GaugeRow& row) {
    return std::hypot(row.x_m - point[0], row.y_m - point[1]);
  };
  std::optional<results::GaugeRow> nearest;
  for (const results::GaugeRow& row : rows)
    if (row.time_s <= time_s && (!nearest || row.gauge == nearest->gauge || away(row) < away(*nearest)))
      nearest = row;
  return nearest;
}

}  // namespace rift::viz
