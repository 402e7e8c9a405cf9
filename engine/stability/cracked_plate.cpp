#include "engine/stability/cracked_plate.hpp"

#include "engine/cache.hpp"
#include "engine/scene/issue.hpp"
#include "engine/simulation/summary.hpp"

#include <filesystem>
#include <utility>

namespace rift {
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

/// What marching came to, of one lane.
Seen seen_of(const Prepared& p, const RunResult& result, int lane) {
  const LaneResult& r = result.lane[lane];
  const Scene& scene = p.lane[lane].scene;
  Seen seen;
  seen.residual = r.worst_residual;
  seen.limit = ledger_limit(scene.solver.kinematics, scene.solver.precision);
  seen.steps = r.steps;
  seen.wall_s = r.wall_s;
  if (r.outcome == Outcome::diverged) {
    seen.ending = Ending::diverges;
    seen.caught_within = r.steps - std::max<std::int64_t>(r.sound_at, 0);
    seen.said = r.where;
    return seen;
  }
  seen.ending = seen.residual <= seen.limit ? Ending::closes : Ending::open;
  const Plateau plateau = rates_of(p, result, lane).plateau;
  if (plateau.reached && plateau.mean.ratio_with_damping != 0.0) seen.ratio = plateau.mean.ratio_with_damping;
  return seen;
}

Seen refused(std::string said) {
  Seen seen;
  seen.ending = Ending::refused;
  seen.said = std::move(said);
  return seen;
}

Scene with(Scene scene, const SceneChange& change, Precision precision) {
  scene.solver.precision = precision;
  if (change) change(scene);
  return scene;
}

}  // namespace

Preset plate_preset(const std::vector<std::string>& overrides) {
  return read_preset_text(plate_text, "the suite's plate", overrides);
}

Seen crack(const std::vector<std::string>& overrides, const SceneChange& scene, const PlateChange& plate,
           Precision precision) try {
  Preset preset = plate_preset(overrides);
  if (!preset.issues.empty()) throw InputError(preset.issues);
  preset.scene = with(preset.scene, scene, precision);
  Cache none;
  Prepared p = prepare(preset, none);
  if (plate) plate(p);
  return seen_of(p, march(p, {}), 0);
} catch (const InputError& error) {
  return refused(error.what());
}

Seen SideBySide::of(int lane, Precision precision) {
  std::vector<Seen>& seen = seen_[precision == Precision::single_precision];
  if (seen.empty()) {
    Preset preset = plate_preset();
    preset.scene.solver.precision = precision;
    std::vector<Scene> scenes;
    for (const SceneChange& change : lanes_) scenes.push_back(with(preset.scene, change, precision));
    Cache none;
    const Prepared p = prepare(preset, scenes, none);
    const RunResult result = march(p, {});
    for (int k = 0; k < static_cast<int>(lanes_.size()); ++k) seen.push_back(seen_of(p, result, k));
  }
  return seen.at(static_cast<std::size_t>(lane));
}

void force_step(Prepared& prepared, double dt) {
  std::vector<LanePlan> lanes = prepared.lane;
  for (LanePlan& lane : lanes) lane.step.dt = dt;
  take_lanes(prepared, std::move(lanes));
}

}  // namespace rift
