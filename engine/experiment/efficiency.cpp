#include "engine/experiment/efficiency.hpp"

#include "engine/base/numbers.hpp"
#include "engine/simulation/summary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace rift::experiment {

std::vector<std::vector<history::HistoryPoint>> resampled(const scene::Scene& scene,
                                                          const history::SmoothedHistory& course, int count,
                                                          std::uint64_t seed) {
  std::vector<std::vector<history::HistoryPoint>> histories;
  if (scene.crack.smoothing == history::Smoothing::none) return histories;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const std::vector<double> fitted = history::positions_at_rows(course, scene.crack.history);
  for (int n = 0; n < count; ++n) {
    std::vector<history::HistoryPoint> rows = scene.crack.history;
    for (std::size_t k = 1; k < rows.size(); ++k) {
      const double noise = rows[k].uncertainty > 0.0 ? rows[k].uncertainty : course.scatter;
      rows[k].position = fitted[k] + noise * normal(random);
    }
    histories.push_back(std::move(rows));
  }
  return histories;
}

namespace {

/// Above 0.9 c_R what arrives within a plate's length is not yet what was stored   [model.md §9.4].
constexpr std::array velocities{0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9};

/// A plate of the same kind whose crack runs steadily along its middle.
scene::Scene steady(const scene::Scene& scene, double over_cr, double pulled) {
  scene::Scene s = scene;
  s.crack.history.clear();
  s.crack.toughness = {};
  s.crack.velocity = {{{over_cr, true}, {}}};
  s.crack.path = {}, s.crack.path_shape = scene::PathShape::polyline;
  s.crack.start = 0.0, s.crack.end.reset(), s.crack.tips = 1;
  s.loading.method = scene::LoadingMethod::static_solve, s.loading.tilt = s.loading.shear = 0.0;
  s.loading.displacement = std::abs(pulled), s.loading.force.reset(), s.loading.curve = {};
  s.crack.friction.reset();
  s.output.window.reset(), s.output.frames = 0, s.output.g_i0_reference = scene::ReleaseRateReference::strip;
  return s;
}

}  // namespace

std::vector<scene::Scene> steady_cracks(const scene::Scene& scene, double pulled, double lowest,
                                        double highest) {
  std::vector<scene::Scene> scenes;
  for (std::size_t k = 0; k < velocities.size(); ++k) {
    const bool below = k + 1 < velocities.size() && velocities[k + 1] <= lowest;
    const bool above = k > 0 && velocities[k - 1] >= highest;
    if (!below && !above) scenes.push_back(steady(scene, velocities[k], pulled));
  }
  return scenes;
}

std::vector<EfficiencyPoint> efficiency_of(const scene::Preset& preset, double pulled, double lowest,
                                           double highest, base::Cache& cache, const Parts& parts,
                                           const ExperimentProgress& progress) {
  const std::vector<scene::Scene> scenes = steady_cracks(preset.scene, pulled, lowest, highest);
  std::vector<EfficiencyPoint> points;
  for (const scene::Scene& scene : scenes) points.push_back({scene.crack.velocity.front().speed.value});
  scene::Preset strip = preset;
  strip.scene = scenes.front(), strip.steering.clear();
  const simulation::Prepared prepared = simulation::prepare(
      strip, scenes, cache, [&](std::string_view, double) { return progress("lattice efficiency", 0.0); });
  const simulation::RunResult run =
      parts.march("efficiency", prepared, [&](double done) { return progress("lattice efficiency", done); });
  for (std::size_t k = 0; k < points.size(); ++k) {
    const simulation::Rates rates = simulation::rates_of(prepared, run, static_cast<int>(k));
    points[k].efficiency = rates.plateau.mean.ratio, points[k].scatter = rates.plateau.scatter;
  }
  return points;
}

EfficiencyPoint efficiency_at(const std::vector<EfficiencyPoint>& points, double over_cr) {
  if (over_cr <= points.front().over_cr) return points.front();
  if (over_cr > points.back().over_cr) return points.back();
  const auto [k, part] = base::interval_at(points, over_cr, &EfficiencyPoint::over_cr);
  const EfficiencyPoint &a = points[k - 1], &b = points[k];
  return {over_cr, std::lerp(a.efficiency, b.efficiency, part), std::lerp(a.scatter, b.scatter, part)};
}

}  // namespace rift::experiment
