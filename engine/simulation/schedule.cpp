#include "engine/simulation/schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace rift::simulation {
namespace {

using Steps = std::vector<std::int64_t>;

/// `count` steps spread evenly over [from, to], both among them (as far as there are that many).
void add_even(Steps& steps, std::int64_t from, std::int64_t to, int count) {
  const std::int64_t most = std::max<std::int64_t>(1, count - 1);
  for (std::int64_t k = 0; k <= most; ++k)
    steps.push_back(
        from + static_cast<std::int64_t>(std::llround(static_cast<double>(to - from) *
                                                      static_cast<double>(k) / static_cast<double>(most))));
}

/// `count` steps at which the tip has come equally far from one to the next, both ends among them.
void add_along(Steps& steps, std::int64_t first, const history::CrackHistory& history, double dt, double end,
               int count) {
  const double start = history::tip_at(history, 0.0);
  for (int k = 0; k < count; ++k) {
    const double time = history::time_of_arrival(history, start + k * (end - start) / std::max(1, count - 1));
    steps.push_back(first + static_cast<std::int64_t>(std::ceil(time / dt)));
  }
}

void sort_unique(Steps& steps) {
  std::sort(steps.begin(), steps.end());
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
}

}  // namespace

double default_step(double critical, double zone_length, double speed) {
  assert(std::isfinite(critical));
  double dt = 0.5 * critical;
  const double limit = zone_length > 0.0 ? zone_length / (5.0 * speed) : dt;
  while (dt > limit) dt *= 0.5;
  return dt;
}

TimeStep choose_step(const scene::Preset& preset, const lattice::StableStep& stable, const StepRequest& wish,
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

double steps_of_crack(const history::CrackHistory& history, double dt, double end) {
  return history::time_of_arrival(history, end) / dt;
}

Schedule make_schedule(const scene::Scene& scene, const history::CrackHistory& history, double dt, double end,
                       const std::array<double, 2>& window) {
  Schedule s;
  if (scene.loading.method == scene::LoadingMethod::ramp)
    s.ramp = scene.loading.ramp_steps, s.hold = scene.loading.hold_steps;
  const double steps = steps_of_crack(history, dt, end);
  assert(steps <= most_steps);
  s.fracture = static_cast<std::int64_t>(std::ceil(steps));
  if (s.ramp > 0) add_even(s.samples, 0, s.crack_start(), scene.output.samples);
  // How long a crack that runs by itself will take is not known: it is looked at where it is, not when.
  const bool by_itself = !scene.crack.toughness.row.empty();
  if (by_itself)
    add_along(s.samples, s.crack_start(), history, dt, end, scene.output.samples);
  else
    add_even(s.samples, s.crack_start(), s.total(), scene.output.samples);
  for (int k = 0; k <= fracture::sub_windows; ++k) {
    const double tip = window[0] + k * (window[1] - window[0]) / fracture::sub_windows;
    const double arrival = history::time_of_arrival(history, tip) / dt;
    if (!(arrival <= static_cast<double>(s.fracture) + 1.0)) continue;
    const auto step = static_cast<std::int64_t>(std::llround(arrival));
    if (step >= 0 && step <= s.fracture) s.samples.push_back(s.crack_start() + step);
  }
  sort_unique(s.samples);
  if (by_itself && scene.output.frames > 0)
    add_along(s.frames, s.crack_start(), history, dt, end, scene.output.frames);
  else if (scene.output.frames > 0)
    add_even(s.frames, s.crack_start(), s.total(), scene.output.frames);
  sort_unique(s.frames);
  return s;
}

Schedule schedule_of_duration(const scene::Scene& scene, double dt) {
  Schedule s;
  s.fracture = static_cast<std::int64_t>(std::ceil(*scene.breaking.duration / dt));
  add_even(s.samples, 0, s.total(), scene.output.samples);
  if (scene.output.frames > 0) add_even(s.frames, 0, s.total(), scene.output.frames);
  sort_unique(s.samples), sort_unique(s.frames);
  return s;
}

}  // namespace rift::simulation
