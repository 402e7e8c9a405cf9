#include "engine/experiment/resampling.hpp"

#include <random>

namespace rift::experiment {

std::vector<std::vector<history::HistoryPoint>> resampled(const scene::Scene& scene,
                                                          const history::Course& course, int count,
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

}  // namespace rift::experiment
