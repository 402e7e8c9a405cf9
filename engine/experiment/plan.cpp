#include "engine/experiment/plan.hpp"

#include "engine/experiment/efficiency.hpp"
#include "engine/scene/derived.hpp"

#include <algorithm>
#include <array>

namespace rift::experiment {
namespace {

/// The slowest and the fastest of the points that are to be expected, in c_R.
std::array<double, 2> ends_of_velocity(const scene::Scene& scene) {
  const std::vector<CriticalPoint> points = planned_points(scene);
  if (points.empty()) return {0.0, 0.0};
  const auto [slowest, fastest] = std::minmax_element(
      points.begin(), points.end(),
      [](const CriticalPoint& a, const CriticalPoint& b) { return a.over_cr < b.over_cr; });
  return {slowest->over_cr, fastest->over_cr};
}

}  // namespace

std::vector<CriticalPoint> points_of(const scene::Scene& scene, const history::SmoothedHistory& course,
                                     double zone_length, double mean_radius) {
  constexpr int count = 60;
  const double half = 0.5 * scene.crack.toughness_window * mean_radius,
               start = scene.crack.start + zone_length + half, end = scene::crack_end(scene) - half;
  std::vector<CriticalPoint> points;
  if (!(end > start)) return points;
  for (int k = 0; k < count; ++k) {
    CriticalPoint& point = points.emplace_back();
    point.position = start + k * (end - start) / (count - 1);
    const double since = history::time_of_arrival(course.history, point.position);
    point.time = course.first_time + since;
    point.over_cr = history::speed_at(course.history, since) / scene::rayleigh_speed(scene);
  }
  return points;
}

std::vector<CriticalPoint> planned_points(const scene::Scene& scene) {
  return points_of(scene, scene::smoothed_history(scene), scene::expected_zone_m(scene),
                   scene::expected_mean_radius_m(scene));
}

std::vector<PlannedPart> planned_parts(const scene::Preset& preset, const ExperimentOptions& options) {
  const scene::Scene& scene = preset.scene;
  scene::Scene unseen = scene;
  unseen.output.frames = 0;
  const bool noise = scene.crack.smoothing != history::Smoothing::none;
  std::vector<scene::Scene> packings;
  for (int k = 1; k < options.specimens; ++k) {
    packings.push_back(unseen);
    packings.back().specimen.seed += k;
  }
  const auto [slowest, fastest] = ends_of_velocity(scene);
  std::vector<PlannedPart> parts{
      {.name = "measured crack", .scenes = {scene}},
      {.name = "resampled histories", .scenes = std::vector(noise ? options.resamples : 0, unseen)},
      {.name = "other specimens", .scenes = packings},
      {.name = "quasi-static", .solutions = options.specimens * (static_parts + 1) + 2},  // and two pulls
      {.name = "lattice efficiency",
       .scenes = steady_cracks(scene, scene::displacement_at_start(scene), slowest, fastest),
       .solutions = 1}};
  if (options.application) parts.push_back({.name = "forward check", .scenes = {unseen}});
  return parts;
}

}  // namespace rift::experiment
