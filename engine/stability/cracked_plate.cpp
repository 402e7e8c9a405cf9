#include "engine/stability/cracked_plate.hpp"

#include "engine/base/cache.hpp"
#include "engine/scene/issue.hpp"
#include "engine/simulation/summary.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>
#include <vector>

namespace rift::stability {
namespace {

constexpr const char* plate_text = R"(
[specimen]
length = "24 mm"
height = "12 mm"
layers = 2
elements = 300
coordination = 5.4   # walls everywhere: 6 is out of reach of so few elements
[loading]
displacement = "0.6 mm"
[crack]
end = "12 mm"
[output]
samples = 50
frames = 0
window = [0.2, 0.5]
)";

/// The beams of the plate that a tip on the straight path has passed, by their ends alone.
std::int64_t beams_passed(const simulation::Prepared& p, double tip) {
  const double height = p.path.point.front().y();
  std::int64_t passed = 0;
  for (const auto& [i, j] : p.lattice.ends) {
    const Eigen::Vector3d &a = p.lattice.centre[i], &b = p.lattice.centre[j];
    if ((a.y() >= height) == (b.y() >= height)) continue;
    const double x = a.x() + (height - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    passed += x <= tip;
  }
  return passed;
}

/// The releases of each lane, counted as the march reports them.
struct Releases {
  std::vector<std::int64_t> of_lane;
  explicit Releases(const simulation::Prepared& p) : of_lane(p.lane.size(), 0) {}
  simulation::Observer observer() {
    simulation::Observer observer;
    observer.event = [this](const results::ReleaseEvent& event) { ++of_lane[event.lane]; };
    return observer;
  }
};

/// What marching came to, of one lane.
Observed seen_of(const simulation::Prepared& p, const simulation::RunResult& result, const Releases& releases,
                 int lane) {
  const simulation::LaneResult& r = result.lane[lane];
  const scene::Scene& scene = p.lane[lane].scene;
  Observed seen;
  seen.residual = r.worst_residual;
  seen.limit = simulation::ledger_limit(scene.solver.kinematics, scene.solver.precision);
  seen.steps = r.steps;
  seen.wall_s = r.wall_s;
  if (r.outcome == simulation::Outcome::diverged) {
    seen.ending = CaseEnd::diverges;
    seen.caught_within = r.steps - std::max<std::int64_t>(r.last_good_step, 0);
    seen.said = r.where;
    return seen;
  }
  seen.ending = seen.residual <= seen.limit ? CaseEnd::closes : CaseEnd::open;
  const results::Sample& last = r.samples.back();
  seen.stored = r.energy_at_crack_start;
  seen.damped = last.damping_j / r.energy_at_crack_start;
  seen.time_s = last.time_s;
  const auto passed = static_cast<double>(beams_passed(p, last.tip_m));
  seen.claims.push_back({"beams released", passed, passed, static_cast<double>(releases.of_lane[lane])});
  const simulation::Rates rates = simulation::rates_of(p, result, lane);
  if (rates.plateau.reached) {
    seen.ratio = rates.plateau.mean.ratio;
    return seen;
  }
  // Rows of large steps lie beside the window's ends.
  std::vector<results::Sample> rows;
  std::copy_if(r.samples.begin(), r.samples.end(), std::back_inserter(rows),
               [](const results::Sample& row) { return row.phase == results::Phase::fracture; });
  const auto& [from, to] = p.lane[lane].window;
  seen.ratio =
      fracture::rate_around(rows, 0.5 * (from + to), to - from, simulation::scale_of(p, p.lane[lane])).ratio;
  return seen;
}

Observed refused(std::string said) {
  Observed seen;
  seen.ending = CaseEnd::refused;
  seen.said = std::move(said);
  return seen;
}

scene::Scene with(scene::Scene scene, const SceneChange& change, ensemble::Precision precision) {
  scene.solver.precision = precision;
  if (change) change(scene);
  return scene;
}

}  // namespace

scene::Preset plate_preset(const std::vector<std::string>& overrides) {
  return scene::read_preset_text(plate_text, "the suite's plate", overrides);
}

Observed crack(const std::vector<std::string>& overrides, const SceneChange& scene, const PlateChange& plate,
               ensemble::Precision precision) try {
  scene::Preset preset = plate_preset(overrides);
  if (!preset.issues.empty()) throw scene::InputError(preset.issues);
  preset.scene = with(preset.scene, scene, precision);
  base::Cache none;
  simulation::Prepared p = simulation::prepare(preset, none);
  if (plate) plate(p);
  Releases releases(p);
  return seen_of(p, simulation::march(p, releases.observer()), releases, 0);
} catch (const scene::InputError& error) {
  return refused(error.what());
}

Observed LaneBatch::of(int lane, ensemble::Precision precision) {
  std::vector<Observed>& seen = seen_[precision == ensemble::Precision::single_precision];
  if (seen.empty()) {
    scene::Preset preset = plate_preset();
    preset.scene.solver.precision = precision;
    std::vector<scene::Scene> scenes;
    for (const SceneChange& change : lanes_) scenes.push_back(with(preset.scene, change, precision));
    base::Cache none;
    const simulation::Prepared p = simulation::prepare(preset, scenes, none);
    Releases releases(p);
    const simulation::RunResult result = simulation::march(p, releases.observer());
    for (int k = 0; k < static_cast<int>(lanes_.size()); ++k) seen.push_back(seen_of(p, result, releases, k));
  }
  return seen.at(static_cast<std::size_t>(lane));
}

void force_step(simulation::Prepared& prepared, double dt) {
  std::vector<simulation::LanePlan> lanes = prepared.lane;
  for (simulation::LanePlan& lane : lanes) lane.step.dt = dt;
  simulation::take_lanes(prepared, std::move(lanes));
}

}  // namespace rift::stability
