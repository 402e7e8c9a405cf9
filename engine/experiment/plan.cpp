#include "engine/experiment/plan.hpp"

#include "engine/experiment/efficiency.hpp"
#include "engine/scene/derived.hpp"

#include <algorithm>
#include <array>

namespace rift::experiment {
namespace {

/// The slowest and the fastest of the measured course between its ends, in c_R.
std::array<double, 2> ends_of_velocity(const scene::Scene& scene) {
  constexpr int moments = 60;
  const history::SmoothedHistory course = scene::smoothed_history(scene);
  const double from = history::time_of_arrival(course.history, scene.crack.start),
               to = history::time_of_arrival(course.history, scene::crack_end(scene));
  std::vector<double> speeds;
  for (int k = 1; k < moments; ++k)
    speeds.push_back(history::speed_at(course.history, from + k * (to - from) / moments) /
                     scene::rayleigh_speed(scene));
  const auto [slowest, fastest] = std::minmax_element(speeds.begin(), speeds.end());
  return {*slowest, *fastest};
}

}  // namespace

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
      {.name = "other packings", .scenes = packings},
      {.name = "quasi-static", .solutions = static_parts + 1},
      {.name = "efficiency",
       .scenes = steady_cracks(scene, scene::displacement_at_start(scene), slowest, fastest)}};
  if (options.application) parts.push_back({.name = "application", .scenes = {unseen}});
  return parts;
}

}  // namespace rift::experiment
