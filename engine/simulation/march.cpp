#include "engine/simulation/march.hpp"

#include "engine/ensemble/ensemble.hpp"
#include "engine/simulation/change_lane.hpp"
#include "engine/simulation/frame.hpp"
#include "engine/simulation/march_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>

namespace rift {
namespace {

using Clock = std::chrono::steady_clock;
using results::Phase;

constexpr double largest_residual_inertia = 0.01;  // of the ramp: kinetic over total energy   [physics.md §4]
constexpr auto between_questions = std::chrono::milliseconds(100),
               between_orders = std::chrono::milliseconds(50);
/// Steps from one moment at which idle lanes may be filled to the next: lanes that begin a power of two of
/// steps apart are looked at in the same steps, which costs one look.
constexpr std::int64_t between_refills = 64;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A lane and the scenario in it.
struct Seat {
  int scenario = -1;  // none: the lane is idle
  std::size_t next_sample = 0, next_frame = 0;
  std::int64_t framed_at = -1;  // the step of the last frame
  Clock::time_point since = Clock::now();
};

/// The run as it goes: what the loop needs beside the ensemble.
template <class Real>
class Run {
 public:
  Run(const Prepared& prepared, const Observer& observer, const MarchOptions& options)
      : prepared_(prepared),
        observer_(observer),
        lane_(prepared.lane),
        ensemble_(make_ensemble(prepared, options)) {
    result_.lane.resize(prepared.lane.size());
    seat_.resize(ensemble_.scenarios());
    for (int lane = 0; lane < ensemble_.scenarios(); ++lane) seat_[lane].scenario = next_scenario_++;
    for (const LanePlan& lane : lane_) total_ += lane.schedule.total();
    for (int k = 0; k < static_cast<int>(lane_.size()); ++k) check_steering(k, 0);
    result_.lanes = ensemble_.scenarios();
    result_.instructions = name_of(instruction_set());
  }

  RunResult march(const Resumption* from) {
    ensemble_.start_from(prepared_.displacement);
    result_.threads = ensemble_.threads();
    if (from)
      go_on(*from);
    else
      start_cracks();
    while (busy() || waiting()) {
      if (waiting() && (!busy() || marched_ % between_refills == 0)) refill();
      if (!prepared_.preset.steering.empty()) repeat_changes();
      step();
      for (Seat& seat : seat_)
        if (seat.scenario >= 0 && ended(seat)) end(seat);
    }
    result_.wall_fracture_s = seconds_since(crack_started_) - waited_;
    if (std::any_of(result_.lane.begin(), result_.lane.end(),
                    [](const LaneResult& lane) { return !lane.changes.empty(); }))
      result_.steered = std::move(lane_);
    for (const LaneResult& lane : result_.lane) result_.outcome = std::max(result_.outcome, lane.outcome);
    return std::move(result_);
  }

 private:
  static Ensemble<Real> make_ensemble(const Prepared& p, const MarchOptions& options) {
    const int threads =
        options.threads > 0 ? options.threads : static_cast<int>(std::thread::hardware_concurrency());
    const int most = options.lanes > 0 ? options.lanes : most_lanes<Real>;
    std::vector<LaneScenario> first;
    for (const LanePlan& lane : p.lane)
      if (static_cast<int>(first.size()) < most) first.push_back(lane.scenario);
    return Ensemble<Real>(p.lattice, p.path, p.preset.scene.crack.start, p.step.dt, first,
                          {.kinematics = p.preset.scene.solver.kinematics,
                           .threads = std::max(1, threads),
                           .lanes = options.lanes > 0 ? lanes_for<Real>(options.lanes) : 0});
  }

  const Scene& scene() const { return prepared_.preset.scene; }
  std::int64_t ramp() const { return prepared_.lane.front().schedule.ramp; }
  std::int64_t crack_start() const { return prepared_.lane.front().schedule.crack_start(); }
  int index(const Seat& seat) const { return static_cast<int>(&seat - seat_.data()); }
  LanePlan& plan(const Seat& seat) { return lane_[seat.scenario]; }
  LaneResult& lane_of(const Seat& seat) { return result_.lane[seat.scenario]; }
  double elastic_energy(const Seat& seat) {
    return plan(seat).units.energy * ensemble_.energy(index(seat)).elastic;
  }
  std::int64_t steps(const Seat& seat) const { return ensemble_.steps_done(index(seat)); }
  bool busy() const {
    return std::any_of(seat_.begin(), seat_.end(), [](const Seat& seat) { return seat.scenario >= 0; });
  }

  Phase phase_at(std::int64_t step) const {
    return step < ramp() ? Phase::loading : step < crack_start() ? Phase::hold : Phase::fracture;
  }

  bool ended(const Seat& seat) {
    return lane_of(seat).outcome != Outcome::finished || steps(seat) >= plan(seat).schedule.total();
  }

  bool waiting() const {
    return !stopped_ && ramp() == 0 && next_scenario_ < static_cast<int>(prepared_.lane.size());
  }

  void step() {
    ensemble_.step();
    ++marched_;
    for (Seat& seat : seat_)
      if (seat.scenario >= 0) ++result_.lane_steps;
    report_released();
    for (Seat& seat : seat_)
      if (seat.scenario >= 0) observe(seat);
    ask();
  }

  void start_cracks() {
    if (ramp() > 0) pull();
    crack_started_ = Clock::now();
    damped_ = prepared_.damped.size();
    ensemble_.set_beta(scene().solver.beta);
    ensemble_.start_crack(prepared_.damped);
    for (Seat& seat : seat_) {
      if (seat.scenario < 0) continue;
      seat.since = crack_started_;
      lane_of(seat).energy_at_crack_start = elastic_energy(seat);
      if (ramp() == 0) observe(seat);
    }
  }

  /// Where the march is; what the lanes' books tell is not repeated.
  results::Checkpoint checkpoint() {
    MarchNotes notes{.lanes = ensemble_.lanes(),
                     .instructions = result_.instructions,
                     .dt = prepared_.step.dt,
                     .marched = marched_,
                     .lane_steps = result_.lane_steps,
                     .next_scenario = next_scenario_,
                     .wall_prestress_s = result_.wall_prestress_s,
                     .wall_fracture_s = seconds_since(crack_started_) - waited_};
    for (const Seat& seat : seat_)
      notes.seats.push_back({seat.scenario, seat.next_sample, seat.next_frame, seat.framed_at});
    notes.lane = result_.lane;
    return {to_json(notes), ensemble_.state(), 0};
  }

  void go_on(const Resumption& from) {
    MarchNotes notes = march_notes(from.checkpoint.notes);
    check_fit(notes);
    result_.lane = std::move(notes.lane);
    for (const results::Sample& row : from.books) result_.lane.at(row.lane).books.push_back(row);
    for (int k = 0; k < static_cast<int>(lane_.size()); ++k)
      for (const Change& change : result_.lane[k].changes)
        (void)change_lane(lane_[k], change, prepared_, change.step);
    for (std::size_t k = 0; k < seat_.size(); ++k) {
      const MarchNotes::Seat& s = notes.seats[k];
      seat_[k] = {s.scenario, s.next_sample, s.next_frame, s.framed_at};
      if (s.scenario >= 0) ensemble_.steer(static_cast<int>(k), lane_[s.scenario].scenario);
    }
    const std::vector<DampedBeam> damped = damped_beams(prepared_, lane_);
    damped_ = damped.size();
    ensemble_.set_beta(scene().solver.beta);
    ensemble_.start_crack(damped);
    ensemble_.restore(from.checkpoint.state);
    marched_ = notes.marched, result_.lane_steps = notes.lane_steps, next_scenario_ = notes.next_scenario;
    result_.wall_prestress_s = notes.wall_prestress_s;
    waited_ = -notes.wall_fracture_s;  // it has marched for so long before
    total_ = 0;
    for (const LanePlan& lane : lane_) total_ += lane.schedule.total();
    crack_started_ = Clock::now();
  }

  void check_fit(const MarchNotes& notes) const {
    const auto refuse = [](const std::string& why) { throw std::invalid_argument("the checkpoint " + why); };
    if (notes.lane.size() != lane_.size() || notes.seats.size() != seat_.size() ||
        notes.lanes != ensemble_.lanes())
      refuse(fmt::format("is of {} scenarios in {} lanes, and this run has {} in {}", notes.lane.size(),
                         notes.lanes, lane_.size(), ensemble_.lanes()));
    if (notes.dt != prepared_.step.dt) refuse("is of another time step");
    if (notes.instructions != result_.instructions)
      refuse(fmt::format("was made with {} and this machine marches with {}: the bits would differ",
                         notes.instructions, result_.instructions));
  }

  /// Leaves the lane idle.
  void end(Seat& seat) {
    LaneResult& lane = lane_of(seat);
    lane.steps = steps(seat);
    lane.wall_s = (seconds_since(seat.since) - waited_) / static_cast<double>(seat_.size());
    result_.wall_fracture_s = seconds_since(crack_started_) - waited_;
    if (lane.outcome == Outcome::finished) lane.wake = wake(seat);
    tell_end(seat);
    seat.scenario = -1;
  }

  /// Idle lanes go on with the next scenarios in the queue.
  void refill() {
    for (Seat& seat : seat_) {
      if (seat.scenario >= 0 || !waiting()) continue;
      seat = {.scenario = next_scenario_++};
      ensemble_.refill(index(seat), plan(seat).scenario);
      lane_of(seat).energy_at_crack_start = elastic_energy(seat);
      observe(seat);
    }
  }

  void tell_end(const Seat& seat) {
    if (observer_.ended) observer_.ended(seat.scenario, result_);
  }

  void observe(Seat& seat) {
    const Schedule& schedule = plan(seat).schedule;
    const std::int64_t n = steps(seat);
    if (seat.next_sample < schedule.samples.size() && n == schedule.samples[seat.next_sample]) {
      ++seat.next_sample;
      read_books(seat);
    }
    if (seat.next_frame < schedule.frames.size() && n == schedule.frames[seat.next_frame]) {
      ++seat.next_frame;
      tell_frame(seat);
    }
  }

  void tell_frame(Seat& seat) {
    if (seat.framed_at == steps(seat)) return;  // as often as it is asked for, once
    seat.framed_at = steps(seat);
    if (observer_.frame) observer_.frame(frame(seat, scene().output.fields));
  }

  results::Frame frame(const Seat& seat, const std::vector<std::string>& fields) {
    results::Frame frame = frame_of(ensemble_, index(seat), fields, plan(seat).units);
    frame.lane = seat.scenario;
    return frame;
  }

  results::Sample books(const Seat& seat) {
    results::Sample row = plan(seat).units.of_lane(ensemble_.sample(index(seat), phase_at(steps(seat))));
    row.lane = seat.scenario;
    return row;
  }

  void read_books(Seat& seat) {
    LaneResult& lane = lane_of(seat);
    const results::Sample row = books(seat);
    lane.books.push_back(row);
    if (observer_.sample) observer_.sample(row);
    const double residual = std::abs(row.residual);
    if (!(residual <= lane.worst_residual)) lane.worst_residual = residual;
    const bool exact = scene().solver.kinematics == Kinematics::linear &&
                       scene().solver.precision == Precision::double_precision;
    if (residual <= (exact ? 1e-6 : 0.1)) return;
    lane.outcome = Outcome::diverged;
    lane.where = fmt::format("step {}: the books are open by {:.3g} of the energy{}", row.step, row.residual,
                             first_lost_element(index(seat)));
  }

  /// The first element whose motion is no number any more, for the message.
  std::string first_lost_element(int lane) {
    for (int i = 0; i < static_cast<int>(prepared_.lattice.centre.size()); ++i)
      if (!ensemble_.motion(i, lane).allFinite()) return fmt::format(", first at element {}", i);
    return "";
  }

  /// What the crack has left, in the scenario's units.
  Wake wake(const Seat& seat) {
    const int lane = index(seat);
    const LaneUnits& units = plan(seat).units;
    const double tip = ensemble_.tip(lane);
    std::vector<Vector6> velocity(prepared_.lattice.centre.size());
    std::vector<double> moved(velocity.size());
    for (int i = 0; i < static_cast<int>(velocity.size()); ++i) {
      velocity[i] = ensemble_.velocity(i, lane) / units.time;
      moved[i] = ensemble_.motion(i, lane).z() - prepared_.displacement[i].z();
    }
    const Box& box = prepared_.lattice.box;
    const std::array<double, 2> behind = prepared_.path.tips == 2
                                             ? std::array{0.5 * box.length - tip, 0.5 * box.length + tip}
                                             : std::array{tip - 2.0 * box.height, tip};
    return wake_of(prepared_.lattice, behind, velocity, moved);
  }

  void report_released() {
    if (!observer_.event) return;
    for (const Softening& c : ensemble_.softening()) {
      if (c.after != 0.0 || seat_[c.lane].scenario < 0) continue;
      const LaneUnits& units = plan(seat_[c.lane]).units;
      observer_.event({.beam = ensemble_.met()[c.crossing].beam,
                       .lane = seat_[c.lane].scenario,
                       .time_s = ensemble_.time(c.lane) * units.time,
                       .position_m = ensemble_.met()[c.crossing].position,
                       .energy_j = ensemble_.booked(c.crossing, c.lane) * units.energy});
    }
  }

  /// Whether to go on; if not, every lane stops where it is.
  void ask() {
    const bool told = observer_.steer && asked_again_at_ > 0;
    if (told ? marched_ < asked_again_at_
             : Clock::now() - asked_ < (observer_.steer ? between_orders : between_questions))
      return;
    asked_ = Clock::now();
    const auto working =
        std::find_if(seat_.begin(), seat_.end(), [](const Seat& seat) { return seat.scenario >= 0; });
    if (working == seat_.end()) return;
    const Progress progress{phase_at(steps(*working)), result_.lane_steps, total_,
                            seconds_since(started_) - waited_};
    const bool stop = (!observer_.go_on || observer_.go_on(progress)) ? !take_orders(progress) : true;
    if (observer_.checkpoint && progress.phase == Phase::fracture)
      observer_.checkpoint([this] { return checkpoint(); }, stop);
    if (stop) stop_all();
  }

  void stop_all() {
    stopped_ = true;
    for (Seat& seat : seat_)
      if (seat.scenario >= 0 && lane_of(seat).outcome == Outcome::finished)
        stop(lane_of(seat), fmt::format("step {} of {}", steps(seat), plan(seat).schedule.total()));
    for (int k = next_scenario_; k < static_cast<int>(lane_.size()); ++k)
      stop(result_.lane[k], fmt::format("step 0 of {}", lane_[k].schedule.total()));
  }

  Seat* seat_of(int scenario) {
    const auto seat = std::find_if(seat_.begin(), seat_.end(),
                                   [&](const Seat& s) { return s.scenario >= 0 && s.scenario == scenario; });
    return seat == seat_.end() ? nullptr : &*seat;
  }

  void carry_out(Orders& orders) {
    for (Change& change : orders.changes) {
      Seat* seat = seat_of(change.lane);
      if (seat) change.step = steps(*seat);
      const std::string refused = seat ? make(*seat, change) : "its crack does not run";
      if (observer_.changed) observer_.changed(change, refused);
    }
    for (const int scenario : orders.frames)
      if (Seat* seat = seat_of(scenario)) tell_frame(*seat);
  }

  /// Asks whoever steers and does what it says. @return whether to go on
  bool take_orders(const Progress& progress) {
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
      waited_ += seconds_since(asked);
      carry_out(orders);
    } while (orders.wait && !orders.stop);
    asked_again_at_ = orders.steps > 0 ? marched_ + orders.steps : 0;
    return !orders.stop;
  }

  [[noreturn]] void refuse(const Change& change, const std::string& why) const {
    throw InputError(
        {issue_at(prepared_.preset, "steering." + change.axis,
                  fmt::format("lane {}, step {}, {}: {}", change.lane, change.step, change.value, why))});
  }

  /// What the preset says is changed must come to pass; a new velocity changes how many steps there are.
  void check_steering(int scenario, std::int64_t now) const {
    for (const Change& change : prepared_.preset.steering) {
      if (change.lane != scenario || change.step < now) continue;
      const std::int64_t total = lane_[scenario].schedule.total();
      if (change.step >= total) refuse(change, fmt::format("the lane ends at step {}", total));
      if (change.axis == "crack_velocity") return;
    }
  }

  bool was_made(const Change& change) const {
    const std::vector<Change>& made = result_.lane[change.lane].changes;
    return std::find(made.begin(), made.end(), change) != made.end();
  }

  /// Makes what the preset says was changed at this step.
  void repeat_changes() {
    for (const Change& change : prepared_.preset.steering) {
      Seat* seat = seat_of(change.lane);
      if (!seat || change.step != steps(*seat) || was_made(change)) continue;
      if (const std::string refused = make(*seat, change); !refused.empty()) refuse(change, refused);
      check_steering(change.lane, change.step + 1);
      if (observer_.changed) observer_.changed(change, {});
    }
  }

  /// Changes the scenario of a lane from the next step on. @return why not, or empty
  std::string make(Seat& seat, const Change& change) {
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

  /// Damps what the lanes want damped, as far as the step bears it.
  std::string damp(LanePlan& lane, const std::vector<LanePlan>& lanes) {
    std::vector<DampedBeam> damped = damped_beams(prepared_, lanes);
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

  static void stop(LaneResult& lane, std::string where) {
    lane.outcome = Outcome::stopped;
    lane.where = std::move(where);
  }

  /// The paper's way to pre-stress: pull, hold, both with numerical damping that is taken out afterwards.
  void pull() {
    const Scene::Loading& loading = scene().loading;
    ensemble_.set_beta(loading.ramp_beta);
    ensemble_.set_grip_speed(loading.displacement / (static_cast<double>(ramp()) * ensemble_.dt()));
    for (Seat& seat : seat_) observe(seat);
    for (std::int64_t n = 0; n < crack_start() && !stopped_ && any_sound(); ++n) {
      if (n == ramp()) ensemble_.set_grip_speed(0.0);
      step();
    }
    ensemble_.set_grip_speed(0.0);
    result_.wall_prestress_s = seconds_since(started_);
    for (Seat& seat : seat_) judge_rest(seat);
  }

  bool any_sound() {
    return std::any_of(seat_.begin(), seat_.end(),
                       [&](const Seat& seat) { return lane_of(seat).outcome == Outcome::finished; });
  }

  void judge_rest(Seat& seat) {
    LaneResult& lane = lane_of(seat);
    const LatticeEnergy e = ensemble_.energy(index(seat));
    lane.prestress_kinetic = (e.kinetic_translation + e.kinetic_rotation) / e.total();
    if (lane.outcome == Outcome::finished && !(lane.prestress_kinetic <= largest_residual_inertia)) {
      lane.outcome = Outcome::diverged;
      lane.where = fmt::format(
          "after the ramp {:.2g} of the energy is kinetic (limit {:g}): not quasi-static; "
          "raise loading.ramp_steps or loading.hold_steps",
          lane.prestress_kinetic, largest_residual_inertia);
    }
    lane.steps = steps(seat);
    if (lane.outcome == Outcome::finished) return;
    tell_end(seat);
    seat.scenario = -1;
  }

  const Prepared& prepared_;
  const Observer& observer_;
  std::vector<LanePlan> lane_;  // as they are after the changes so far
  Ensemble<Real> ensemble_;
  RunResult result_;
  std::vector<Seat> seat_;
  int next_scenario_ = 0;
  std::int64_t marched_ = 0;  // steps of the ensemble
  std::int64_t total_ = 0;
  std::int64_t asked_again_at_ = 1;  // of marched_, so that orders come before all else; 0: by the clock
  std::size_t damped_ = 0;           // beams
  double waited_ = 0;                // [s] for orders
  bool stopped_ = false;
  Clock::time_point started_ = Clock::now(), asked_ = started_, crack_started_ = started_;
};

}  // namespace

const char* name_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::finished:
      return "finished";
    case Outcome::stopped:
      return "stopped";
    case Outcome::diverged:
      return "diverged";
  }
  return "";
}

double ledger_limit(Kinematics kinematics, Precision precision) {
  if (precision == Precision::single_precision) return 1e-3;
  return kinematics == Kinematics::corotational ? 1e-4 : 1e-10;
}

RunResult march(const Prepared& prepared, const Observer& observer, const MarchOptions& options,
                const Resumption* from) {
  if (prepared.preset.scene.solver.precision == Precision::single_precision)
    return Run<float>(prepared, observer, options).march(from);
  return Run<double>(prepared, observer, options).march(from);
}

}  // namespace rift
