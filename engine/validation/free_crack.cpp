#include "engine/validation/free_crack.hpp"

#include "engine/base/interrupted.hpp"
#include "engine/scene/derived.hpp"
#include "engine/simulation/march.hpp"
#include "engine/simulation/own_constants.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift::validation {
namespace {

constexpr int energy_samples = 400;
constexpr double near_radii = 2.0;  // within which a tip has two other gone beams

/// Marches the lanes, with what is asked for noted in `cracks`.
void march_into(std::vector<FreeCrack>& cracks, const simulation::Prepared& p,
                const simulation::StageProgress& progress, int threads) {
  simulation::Observer observer;
  observer.event = [&](const results::ReleaseEvent& e) {
    FreeCrack& crack = cracks[e.lane];
    const double x = crack.realisation.mirrored ? crack.length - e.x_m : e.x_m;
    crack.gone.push_back({e.time_s, {x, e.y_m}});
  };
  observer.go_on = [&](const simulation::Progress& now) {
    return !progress || progress("crack", static_cast<double>(now.step) / static_cast<double>(now.total));
  };
  const simulation::RunResult result = simulation::march(p, observer, {.threads = threads});
  if (result.outcome == simulation::Outcome::stopped) throw base::Interrupted("marching a crack");
  for (std::size_t k = 0; k < cracks.size(); ++k) {
    const simulation::LaneResult& lane = result.lane[k];
    for (const results::Sample& sample : lane.samples)
      cracks[k].fracture.push_back({sample.time_s, sample.fracture_j});
    cracks[k].balance_error = lane.worst_residual;
    if (lane.outcome == simulation::Outcome::diverged) cracks[k].diverged = lane.where;
  }
}

}  // namespace

std::vector<std::string> overrides_of(const scene::Scene& scene, const Realisation& realisation) {
  std::vector<std::string> overrides{fmt::format("specimen.elements={}", realisation.elements),
                                     fmt::format("specimen.seed={}", realisation.seed), "output.frames=0",
                                     fmt::format("output.samples={}", energy_samples)};
  if (realisation.mirrored)
    overrides.push_back(fmt::format("crack.path=[[{:.17g}, {:.17g}], [0, {:.17g}]]", scene.specimen.length,
                                    0.5 * scene.specimen.height, 0.5 * scene.specimen.height));
  return overrides;
}

std::vector<FreeCrack> run_free_cracks(const scene::Preset& preset, const std::vector<scene::Scene>& lanes,
                                       const Realisation& realisation, bool with_constants,
                                       base::Cache& cache, const simulation::StageProgress& progress,
                                       int threads) {
  const simulation::Prepared p = simulation::prepare(preset, lanes, cache, progress);
  FreeCrack crack;
  crack.realisation = realisation;
  crack.length = p.lattice.box.length, crack.height = p.lattice.box.height;
  crack.thickness = p.lattice.box.thickness, crack.mean_radius = p.lattice.mean_radius;
  crack.notch = preset.scene.crack.start;
  crack.young_modulus = preset.scene.material.young_modulus;
  crack.poisson_ratio = preset.scene.material.poisson_ratio;
  if (with_constants) {
    const simulation::OwnConstants own =
        simulation::own_constants(p, cache, simulation::stage(progress, "own constants"), threads);
    crack.young_modulus = own.young_modulus(), crack.poisson_ratio = own.poisson_ratio();
  }
  std::vector<FreeCrack> cracks(lanes.size(), crack);
  for (std::size_t k = 0; k < lanes.size(); ++k) {
    cracks[k].kappa = lanes[k].breaking.kappa;
    cracks[k].strength = p.lane[k].scenario.material.value().strength * p.lane[k].units.energy;
  }
  march_into(cracks, p, progress, threads);
  return cracks;
}

std::vector<std::array<double, 2>> tip_history(const FreeCrack& crack) {
  fracture::BrokenBeams broken(near_radii * crack.mean_radius);
  std::vector<std::array<double, 2>> history;
  for (const GoneBeam& beam : crack.gone) {
    broken.add(beam.at);
    if (const auto tip = broken.leading(); tip && (history.empty() || *tip > history.back()[1]))
      history.push_back({beam.time, *tip});
  }
  return history;
}

double time_reached(const std::vector<std::array<double, 2>>& rows, double value, bool at_rows) {
  const auto at = std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return row[1] >= value; });
  if (at == rows.end()) return std::numeric_limits<double>::quiet_NaN();
  if (at_rows || at == rows.begin()) return (*at)[0];
  const auto& before = *(at - 1);
  return before[0] + ((*at)[0] - before[0]) * (value - before[1]) / ((*at)[1] - before[1]);
}

double value_at(const std::vector<std::array<double, 2>>& rows, double time) {
  const auto above =
      std::upper_bound(rows.begin(), rows.end(), time, [](double t, const auto& row) { return t < row[0]; });
  if (above == rows.begin()) return rows.front()[1];
  if (above == rows.end()) return rows.back()[1];
  const auto& before = *(above - 1);
  return before[1] + ((*above)[1] - before[1]) * (time - before[0]) / ((*above)[0] - before[0]);
}

}  // namespace rift::validation
