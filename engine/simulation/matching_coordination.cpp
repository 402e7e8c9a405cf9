#include "engine/simulation/matching_coordination.hpp"

#include "engine/scene/issue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rift::simulation {
namespace {

/// Where it is looked for: looser packings have too many elements that nothing holds.
constexpr double loosest = 4.4, densest = 6.0;
constexpr double modulus_tolerance = 0.01;
constexpr int trials = 8;

double modulus_at(scene::Preset preset, double coordination, std::span<const int> seeds, base::Cache& cache,
                  const StageProgress& progress) {
  double sum = 0.0;
  preset.scene.material.stiffness = scene::StiffnessChoice::bulk;
  preset.scene.specimen.coordination = coordination;
  for (const int seed : seeds) {
    preset.scene.specimen.seed = seed;
    const Prepared plate = prepare(preset, cache, progress);
    sum += plate.strip_modulus * plate.lane.front().units.energy;
  }
  return sum / static_cast<double>(seeds.size());
}

}  // namespace

MatchedCoordination matching_coordination(const scene::Preset& preset, std::span<const int> seeds,
                                          base::Cache& cache, const StageProgress& progress) {
  MatchedCoordination found{.wanted = continuum_strip_modulus(preset.scene)};
  const auto over = [&](double coordination) {
    found.coordination = coordination;
    found.strip_modulus = modulus_at(preset, coordination, seeds, cache, progress);
    found.packings += static_cast<int>(seeds.size());
    return found.strip_modulus / found.wanted - 1.0;
  };
  double former = densest, of_former = over(former), now = 5.2, of_now = over(now);
  for (int k = 0; k < trials && std::abs(of_now) > modulus_tolerance; ++k) {
    const double next = std::clamp(now - of_now * (now - former) / (of_now - of_former), loosest, densest);
    if (next == now) break;
    former = now, of_former = of_now;
    // To a hundredth: a packing that another trial made serves.
    now = 0.01 * std::round(100.0 * next), of_now = over(now);
    if (now == former) break;
  }
  if (std::abs(of_now) > modulus_tolerance)
    throw scene::InputError({scene::issue_at(
        preset, "specimen.coordination",
        fmt::format(
            "no coordination from {:g} to {:g} makes the plate as stiff as its beams' cylinder: {:.4g} "
            "GPa at {:g} where {:.4g} GPa are wanted",
            loosest, densest, 1e-9 * found.strip_modulus, found.coordination, 1e-9 * found.wanted))});
  return found;
}

}  // namespace rift::simulation
