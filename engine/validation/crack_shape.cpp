#include "engine/validation/crack_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift::validation {
namespace {

constexpr double stripe_radii = 8.0, together_radii = 4.0;
constexpr std::size_t fewest = 3;
constexpr double joined = 3.0;  // widths of a stripe: what is farther away has begun by itself

/// Middles of the groups of a stripe's beams, which lie together along y.
std::vector<Eigen::Vector2d> places_of(std::vector<Eigen::Vector2d> beams, double together) {
  std::sort(beams.begin(), beams.end(), [](const auto& a, const auto& b) { return a.y() < b.y(); });
  std::vector<Eigen::Vector2d> places;
  for (std::size_t first = 0; first < beams.size();) {
    std::size_t end = first + 1;
    Eigen::Vector2d sum = beams[first];
    while (end < beams.size() && beams[end].y() - beams[end - 1].y() < together) sum += beams[end++];
    if (end - first >= fewest) places.emplace_back(sum / static_cast<double>(end - first));
    first = end;
  }
  return places;
}

}  // namespace

CrackShape shape_of(const FreeCrack& crack) {
  const double way = crack.length - crack.notch;
  const int stripes = std::max(1, static_cast<int>(way / (stripe_radii * crack.mean_radius)));
  const double width = way / stripes;
  std::vector<std::vector<Eigen::Vector2d>> beams(stripes);
  for (const GoneBeam& beam : crack.gone) {
    const int stripe = static_cast<int>(std::floor((beam.at.x() - crack.notch) / width));
    if (stripe >= 0) beams[std::min(stripe, stripes - 1)].push_back(beam.at);
  }
  CrackShape shape;
  std::vector<Eigen::Vector2d> before{{crack.notch, 0.5 * crack.height}};
  for (int k = 0; k < stripes; ++k) {
    const std::vector<Eigen::Vector2d> places = places_of(beams[k], together_radii * crack.mean_radius);
    for (const Eigen::Vector2d& place : places) {
      double nearest = joined * width;
      for (const Eigen::Vector2d& other : before) nearest = std::min(nearest, (other - place).norm());
      shape.length += nearest < joined * width ? nearest : width;
      if (k + 1 == stripes) shape.length += crack.length - place.x();
    }
    before = places;
    if (k + 1 == stripes) shape.tips_at_edge = static_cast<int>(places.size());
  }
  return shape;
}

double fitted_speed(const FreeCrack& crack, double margin, double least) {
  constexpr int times = 200;
  const auto tips = tip_history(crack);
  const double first = crack.notch + margin, last = crack.length - margin;
  const double begin = time_reached(tips, first), end = time_reached(tips, last);
  if (!(end > begin) || last - first < least) return std::numeric_limits<double>::quiet_NaN();
  double mean_t = 0.0, mean_x = 0.0;
  std::vector<std::array<double, 2>> rows;
  for (int k = 0; k < times; ++k) {
    const double t = begin + (end - begin) * k / (times - 1);
    rows.push_back({t, value_at(tips, t)});
    mean_t += t / times, mean_x += rows.back()[1] / times;
  }
  double tx = 0.0, tt = 0.0;
  for (const auto& [t, x] : rows) tx += (t - mean_t) * (x - mean_x), tt += (t - mean_t) * (t - mean_t);
  return tx / tt;
}

}  // namespace rift::validation
