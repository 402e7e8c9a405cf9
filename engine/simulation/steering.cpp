#include "engine/simulation/steering.hpp"

#include "engine/scene/derived.hpp"
#include "engine/scene/issue.hpp"
#include "engine/simulation/march_run.hpp"

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
      return fmt::format("makes a run of {:.4g} steps, at most {:g} are taken", steps, most_steps);
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

namespace {

constexpr auto between_questions = std::chrono::milliseconds(100),
               between_orders = std::chrono::milliseconds(50);

}  // namespace

template <class Real>
void Run<Real>::ask() {
  const bool told = observer_.steer && asked_again_at_ > 0;
  if (told ? marched_ < asked_again_at_
           : Clock::now() - asked_ < (observer_.steer ? between_orders : between_questions))
    return;
  asked_ = Clock::now();
  const auto working =
      std::find_if(seat_.begin(), seat_.end(), [](const Seat& seat) { return seat.scenario >= 0; });
  if (working == seat_.end()) return;
  const Progress progress{phase_at(steps(*working)), result_.lane_steps, total_,
                          (ensemble_.cracking() ? result_.wall_prestress_s : 0.0) + marching_s()};
  const bool stop = (!observer_.go_on || observer_.go_on(progress)) ? !take_orders(progress) : true;
  if (observer_.checkpoint)
    observer_.checkpoint([this] { return checkpoint(); },
                         stop ? CheckpointMoment::before_stop : CheckpointMoment::on_the_way);
  if (stop) stop_all();
}

template <class Real>
void Run<Real>::stop_all() {
  stopped_ = true;
  for (Seat& seat : seat_)
    if (seat.scenario >= 0 && lane_of(seat).outcome == Outcome::finished)
      stop(lane_of(seat), fmt::format("step {} of {}", steps(seat), plan(seat).schedule.total()));
  for (int k = next_scenario_; k < static_cast<int>(lane_.size()); ++k)
    stop(result_.lane[k], fmt::format("step 0 of {}", lane_[k].schedule.total()));
}

template <class Real>
void Run<Real>::carry_out(Orders& orders) {
  for (scene::Change& change : orders.changes) {
    Seat* seat = seat_of(change.lane);
    if (seat) change.step = steps(*seat);
    const bool by_itself = seat && !plan(*seat).scene.crack.toughness.row.empty();
    const std::string refused = !seat                                          ? "its crack does not run"
                                : by_itself && change.axis == "crack_velocity" ? "the crack runs by itself"
                                                                               : make(*seat, change);
    if (observer_.changed) observer_.changed(change, refused);
  }
  for (const int scenario : orders.frames)
    if (Seat* seat = seat_of(scenario)) tell_frame(*seat);
}

template <class Real>
bool Run<Real>::take_orders(const Progress& progress) {
  if (!observer_.steer) return true;
  Moment moment{progress, {}, {}};
  moment.books = [this](int scenario) -> std::optional<results::Sample> {
    Seat* seat = seat_of(scenario);
    return seat ? std::optional(books(*seat)) : std::nullopt;
  };
  moment.frame = [this](int scenario, bool velocity) -> std::optional<results::Frame> {
    Seat* seat = seat_of(scenario);
    std::vector<std::string> fields{"displacement"};
    if (velocity) fields.emplace_back("velocity");
    return seat ? std::optional(frame(*seat, fields)) : std::nullopt;
  };
  Orders orders;
  do {
    const auto asked = Clock::now();
    orders = observer_.steer(moment);
    waited_ += base::seconds_since(asked);
    carry_out(orders);
  } while (orders.wait && !orders.stop);
  asked_again_at_ = orders.steps > 0 ? marched_ + orders.steps : 0;
  return !orders.stop;
}

template <class Real>
void Run<Real>::repeat_changes() {
  for (const scene::Change& change : prepared_.preset.steering) {
    Seat* seat = seat_of(change.lane);
    if (!seat || change.step != steps(*seat) || was_made(change)) continue;
    if (const std::string refused = make(*seat, change); !refused.empty())
      refuse_change(prepared_, change, refused);
    check_steering(prepared_, lane_, change.lane, change.step + 1);
    if (observer_.changed) observer_.changed(change, {});
  }
}

template <class Real>
std::string Run<Real>::make(Seat& seat, const scene::Change& change) {
  std::vector<LanePlan> lanes = lane_;
  LanePlan& lane = lanes[seat.scenario];
  if (std::string wrong = change_lane(lane, change, prepared_, steps(seat)); !wrong.empty()) return wrong;
  if (change.axis == "damping_alpha") {
    if (std::string wrong = damp(lane, lanes); !wrong.empty()) return wrong;
  }
  total_ += lane.schedule.total() - plan(seat).schedule.total();
  ensemble_.steer(index(seat), lane.scenario);
  lane_ = std::move(lanes);
  lane_of(seat).changes.push_back(change);
  return {};
}

template <class Real>
std::string Run<Real>::damp(LanePlan& lane, const std::vector<LanePlan>& lanes) {
  std::vector<lattice::DampedBeam> damped = damped_beams(prepared_, lanes);
  const double limit = damped_limit(prepared_, damped, lanes);
  if (prepared_.step.dt >= limit)
    return fmt::format("needs steps below {:.3g} s, and those of this run are {:.3g} s",
                       limit * lane.units.time, prepared_.step.dt * lane.units.time);
  lane.beams_damped = damped.size();
  lane.step.critical_damped = limit;
  if (damped.size() <= damped_) return {};
  damped_ = damped.size();
  ensemble_.damp(damped);
  return {};
}

template void Run<double>::ask();
template void Run<float>::ask();
template void Run<double>::repeat_changes();
template void Run<float>::repeat_changes();

}  // namespace rift::simulation
