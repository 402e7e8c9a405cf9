#include "engine/simulation/time_step.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

namespace rift::simulation {

double default_step(double critical, double zone_length, double speed) {
  assert(std::isfinite(critical));
  double dt = 0.5 * critical;
  const double limit = zone_length > 0.0 ? zone_length / (5.0 * speed) : dt;
  while (dt > limit) dt *= 0.5;
  return dt;
}

TimeStep choose_step(const scene::Preset& preset, const lattice::StableStep& stable, const StepWish& wish,
                     double time_unit) {
  const scene::Scene& scene = preset.scene;
  TimeStep step{.dt = default_step(stable.critical, wish.zone_length, wish.speed),
                .critical = stable.critical,
                .critical_damped = wish.critical_damped.value_or(stable.critical),
                .element_bound = stable.element_bound};
  if (scene.solver.dt) step.dt = *scene.solver.dt / time_unit;
  if (scene.solver.dt_fraction) step.dt = *scene.solver.dt_fraction * stable.critical;
  if (step.dt < step.critical_damped) return step;
  const char* key = scene.solver.dt            ? "solver.dt"
                    : scene.solver.dt_fraction ? "solver.dt_fraction"
                                               : "damping.alpha";
  const std::string limit =
      !wish.critical_damped
          ? fmt::format("the critical step of this lattice is {:.4g} s", step.critical * time_unit)
          : fmt::format(
                "the critical step of this lattice with this damping is "
                "{:.4g} s ({:.4g} s undamped)",
                step.critical_damped * time_unit, step.critical * time_unit);
  throw scene::InputError({scene::issue_at(
      preset, key, fmt::format("makes a step of {:.4g} s, and {}", step.dt * time_unit, limit))});
}

}  // namespace rift::simulation
