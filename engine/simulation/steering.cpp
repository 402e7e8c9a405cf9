#include "engine/simulation/steering.hpp"

#include "engine/scene/derived.hpp"
#include "engine/scene/issue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace rift::simulation {
namespace {

/// The steps of a new plan that are to come, after those of the old one that are past.
std::vector<std::int64_t> joined(const std::vector<std::int64_t>& before,
                                 const std::vector<std::int64_t>& planned, std::int64_t now) {
  std::vector<std::int64_t> steps;
  std::copy_if(before.begin(), before.end(), std::back_inserter(steps), [&](auto n) { return n <= now; });
  std::copy_if(planned.begin(), planned.end(), std::back_inserter(steps), [&](auto n) { return n > now; });
  return steps;
}

void plan_anew(LanePlan& lane, const Prepared& prepared, std::int64_t now) {
  Schedule planned =
      make_schedule(lane.scene, lane.scenario.history, prepared.step.dt, lane.crack_end, lane.window);
  planned.samples = joined(lane.schedule.samples, planned.samples, now);
  planned.frames = joined(lane.schedule.frames, planned.frames, now);
  lane.schedule = std::move(planned);
}

/// Until the slowest waves have been to the far end and back, or so long after the load has stopped to
/// change: nothing comes after them.
std::int64_t steps_of_rest(const LanePlan& lane, const Prepared& prepared, double time) {
  const scene::LoadCurve& curve = lane.scene.loading.curve;
  double rest = 2.0 * prepared.lattice.box.length / (prepared.rayleigh_speed * lane.units.time);
  if (scene::grip_moves(lane.scene)) {
    const double clock = scene::load_time(lane.scene) + std::max(0.0, time * lane.units.time - lane.lead);
    rest += std::max(0.0, curve.row.back()[0] - clock) / lane.units.time;
  }
  return static_cast<std::int64_t>(std::ceil(rest / prepared.step.dt));
}

void stop(LanePlan& lane, const Prepared& prepared, double time, std::int64_t now) {
  history::turn_to(lane.scenario.history, time, 0.0);
  const std::int64_t end = now + steps_of_rest(lane, prepared, time);
  lane.schedule.fracture = end - lane.schedule.crack_start();
  lane.schedule.samples = joined(lane.schedule.samples, {end}, now);
  if (!lane.schedule.frames.empty()) lane.schedule.frames = joined(lane.schedule.frames, {end}, now);
}

}  // namespace

std::string change_lane(LanePlan& lane, const scene::Change& change, const Prepared& prepared,
                        std::int64_t step) {
  if (step < lane.schedule.crack_start()) return "the crack has not started yet";
  const double time = static_cast<double>(step - lane.schedule.crack_start()) * prepared.step.dt;
  const double tip = history::tip_at(lane.scenario.history, time);
  if (change.axis == tip_stops) {
    stop(lane, prepared, time, step);
    return {};
  }
  if (std::string wrong = scene::steer(lane.scene, change, tip); !wrong.empty()) return wrong;
  if (change.axis == "damping_alpha") {
    set_damping(lane.scenario, lane.scene);
  } else if (change.axis == "crack_velocity") {
    history::turn_to(lane.scenario.history, time,
                     lattice_speed(prepared, lane.scene.crack.velocity.back().speed, lane.units));
    const double steps = steps_of_crack(lane.scenario.history, prepared.step.dt, lane.crack_end);
    if (!(steps <= most_steps))
      return fmt::format("makes a run of {:.4g} steps; the limit is {:g}", steps, most_steps);
    plan_anew(lane, prepared, step);
  } else {
    fracture::change_law(lane.scenario, release_law(lane.scene, prepared.lattice), tip);
  }
  return {};
}

void refuse_change(const Prepared& prepared, const scene::Change& change, const std::string& why) {
  throw scene::InputError({scene::issue_at(
      prepared.preset, "steering." + change.axis,
      fmt::format("lane {}, step {}, {}: {}", change.lane, change.step, change.value, why))});
}

void check_steering(const Prepared& prepared, const std::vector<LanePlan>& lanes, int lane,
                    std::int64_t now) {
  for (const scene::Change& change : prepared.preset.steering) {
    if (change.lane != lane || change.step < now) continue;
    const std::int64_t total = lanes[lane].schedule.total();
    if (change.step >= total) refuse_change(prepared, change, fmt::format("the lane ends at step {}", total));
    if (change.axis == "crack_velocity") return;
  }
}

}  // namespace rift::simulation
