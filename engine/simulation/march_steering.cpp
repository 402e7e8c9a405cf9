#include "engine/simulation/change_lane.hpp"
#include "engine/simulation/march_run.hpp"

#include <fmt/format.h>

#include <utility>

namespace rift::simulation {
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
