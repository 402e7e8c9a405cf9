#include "engine/simulation/march_run.hpp"
#include "engine/simulation/steering.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace rift::simulation {
namespace {

constexpr auto between_questions = std::chrono::milliseconds(100),
               between_commands = std::chrono::milliseconds(50);

void stop(LaneResult& lane, std::string where) {
  lane.outcome = Outcome::stopped;
  lane.where = std::move(where);
}

}  // namespace

void Run::ask() {
  const bool told = observer_.steer && asked_again_at_ > 0;
  if (told ? marched_ < asked_again_at_
           : Clock::now() - asked_ < (observer_.steer ? between_commands : between_questions))
    return;
  asked_ = Clock::now();
  const auto working =
      std::find_if(slot_.begin(), slot_.end(), [](const LaneSlot& slot) { return slot.scenario >= 0; });
  if (working == slot_.end()) return;
  const Progress progress{phase_at(steps(*working)), result_.lane_steps, total_,
                          (ensemble_.cracking() ? result_.wall_prestress_s : 0.0) + marching_s()};
  const bool stop = (!observer_.go_on || observer_.go_on(progress)) ? !take_commands(progress) : true;
  if (observer_.checkpoint)
    observer_.checkpoint([this] { return checkpoint(); },
                         stop ? CheckpointMoment::before_stop : CheckpointMoment::on_the_way);
  if (stop) stop_all();
}

LaneSlot* Run::slot_of(int scenario) {
  const auto slot = std::find_if(slot_.begin(), slot_.end(), [&](const LaneSlot& s) {
    return s.scenario >= 0 && s.scenario == scenario;
  });
  return slot == slot_.end() ? nullptr : &*slot;
}

void Run::count_steps() {
  total_ = 0;
  for (const LanePlan& lane : lane_) total_ += lane.schedule.total();
}

void Run::stop_all() {
  stopped_ = next_scenario_ < static_cast<int>(lane_.size());
  for (LaneSlot& slot : slot_) {
    if (slot.scenario < 0 || ended(slot)) continue;
    stop(lane_of(slot), fmt::format("step {} of {}", steps(slot), plan(slot).schedule.total()));
    stopped_ = true;
  }
  for (int k = next_scenario_; k < static_cast<int>(lane_.size()); ++k)
    stop(result_.lane[k], fmt::format("step 0 of {}", lane_[k].schedule.total()));
}

void Run::carry_out(SteeringCommands& commands) {
  for (scene::Change& change : commands.changes) {
    LaneSlot* slot = slot_of(change.lane);
    if (slot) change.step = steps(*slot);
    const bool by_itself = slot && !plan(*slot).scene.crack.toughness.row.empty();
    const std::string refused = !slot ? "its crack is not running"
                                : by_itself && change.axis == "crack_velocity"
                                    ? "the velocity of this crack is predicted"
                                    : make(*slot, change);
    if (observer_.changed) observer_.changed(change, refused);
  }
  for (const int scenario : commands.frames)
    if (LaneSlot* slot = slot_of(scenario)) tell_frame(*slot);
}

RunSnapshot Run::snapshot(const Progress& progress) {
  RunSnapshot snapshot{progress, {}, {}};
  snapshot.sample = [this](int scenario) -> std::optional<results::Sample> {
    LaneSlot* slot = slot_of(scenario);
    return slot ? std::optional(sample(*slot)) : std::nullopt;
  };
  snapshot.frame = [this](int scenario, bool velocity) -> std::optional<results::Frame> {
    LaneSlot* slot = slot_of(scenario);
    std::vector<std::string> fields{"displacement"};
    if (velocity) fields.emplace_back("velocity");
    return slot ? std::optional(frame(*slot, fields)) : std::nullopt;
  };
  return snapshot;
}

bool Run::take_commands(const Progress& progress) {
  if (!observer_.steer) return true;
  const RunSnapshot now = snapshot(progress);
  SteeringCommands commands;
  do {
    const auto asked = Clock::now();
    commands = observer_.steer(now);
    waited_ += base::seconds_since(asked);
    carry_out(commands);
  } while (commands.wait && !commands.stop);
  asked_again_at_ = commands.steps > 0 ? marched_ + commands.steps : 0;
  return !commands.stop;
}

void Run::repeat_changes() {
  for (const scene::Change& change : prepared_.preset.steering) {
    LaneSlot* slot = slot_of(change.lane);
    if (!slot || change.step != steps(*slot)) continue;
    const std::vector<scene::Change>& made = result_.lane[change.lane].changes;
    if (std::find(made.begin(), made.end(), change) != made.end()) continue;
    if (const std::string refused = make(*slot, change); !refused.empty())
      refuse_change(prepared_, change, refused);
    check_steering(prepared_, lane_, change.lane, change.step + 1);
    if (observer_.changed) observer_.changed(change, {});
  }
}

std::string Run::make(LaneSlot& slot, const scene::Change& change) {
  std::vector<LanePlan> lanes = lane_;
  LanePlan& lane = lanes[slot.scenario];
  if (std::string wrong = change_lane(lane, change, prepared_, steps(slot)); !wrong.empty()) return wrong;
  if (change.axis == "damping_alpha") {
    if (std::string wrong = damp(lane, lanes); !wrong.empty()) return wrong;
  }
  ensemble_.steer(index(slot), lane.scenario);
  lane_ = std::move(lanes);
  count_steps();
  lane_of(slot).changes.push_back(change);
  return {};
}

std::string Run::damp(LanePlan& lane, const std::vector<LanePlan>& lanes) {
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

void Run::find_velocity(LaneSlot& slot) {
  if (plan(slot).scene.crack.toughness.row.empty() || !ensemble_.cracking() || ended(slot)) return;
  const double tip = tips_->tip(index(slot));
  std::optional<double> velocity;
  if (slot.rest.since >= 0) {
    velocity = restart_of(own_crack(slot), slot.rest, steps(slot) - slot.rest.since);
    if (!velocity) return;
    add_sample(slot);
    slot.rest = {.restarted_m = tip};
    lane_of(slot).arrested_m = std::numeric_limits<double>::quiet_NaN();
  } else {
    if (!asks_for_velocity(own_crack(slot))) return;
    velocity = velocity_of(own_crack(slot));
  }
  if (velocity)
    make_own_change(slot, "crack_velocity", fmt::format("{} c_r", *velocity));
  else
    stop_tip(slot);
}

void Run::stop_tip(LaneSlot& slot) {
  const double tip = tips_->tip(index(slot));
  slot.rest = {.since = steps(slot),
               .driving = driving_at_stop(own_crack(slot)),
               .restarted_m = slot.rest.restarted_m};
  make_own_change(slot, tip_stops, "");
  lane_of(slot).arrested_m = tip;
  if (lane_of(slot).samples.empty() || lane_of(slot).samples.back().step != steps(slot)) add_sample(slot);
}

void Run::make_own_change(LaneSlot& slot, std::string_view axis, const std::string& value) {
  const std::string refused = make(slot, {slot.scenario, steps(slot), std::string(axis), value});
  if (!refused.empty()) throw std::logic_error("predicted crack: " + refused);
}

results::Checkpoint Run::checkpoint() {
  MarchNotes notes{.lanes = ensemble_.lanes(),
                   .instructions = result_.instructions,
                   .dt = prepared_.step.dt,
                   .marched = marched_,
                   .lane_steps = result_.lane_steps,
                   .next_scenario = next_scenario_,
                   .cracking = ensemble_.cracking(),
                   .wall_prestress_s = ensemble_.cracking() ? result_.wall_prestress_s : marching_s(),
                   .wall_fracture_s = ensemble_.cracking() ? marching_s() : 0.0,
                   .seats = slot_,
                   .lane = result_.lane};
  return {to_json(notes), ensemble_.state(), 0};
}

void Run::begin_cracking(const std::vector<lattice::DampedBeam>& damped) {
  damped_ = damped.size();
  ensemble_.set_beta(scene().solver.beta);
  ensemble_.start_crack(damped);
}

void Run::go_on(const Resumption& from) {
  MarchNotes notes = march_notes(from.checkpoint.notes);
  check_fit(notes);
  result_.lane = std::move(notes.lane);
  for (const results::Sample& row : from.samples) {
    if (row.lane >= static_cast<int>(result_.lane.size()))
      throw std::invalid_argument("the journal holds rows of a lane that this run does not have");
    result_.lane[row.lane].samples.push_back(row);
  }
  for (int k = 0; k < static_cast<int>(lane_.size()); ++k)
    for (const scene::Change& change : result_.lane[k].changes)
      (void)change_lane(lane_[k], change, prepared_, change.step);
  slot_ = notes.seats;
  for (const LaneSlot& slot : slot_) {
    if (slot.scenario < 0) continue;
    ensemble_.set_units(index(slot), plan(slot).units);
    ensemble_.steer(index(slot), plan(slot).scenario);
  }
  if (notes.cracking) begin_cracking(damped_beams(prepared_, lane_));
  ensemble_.restore(from.checkpoint.state);
  for (const LaneSlot& slot : slot_)
    if (!tips_ && slot.scenario >= 0) find_gone(slot);
  marched_ = notes.marched, result_.lane_steps = notes.lane_steps, next_scenario_ = notes.next_scenario;
  count_steps();
  start_clock(notes.cracking ? notes.wall_fracture_s : notes.wall_prestress_s);
  if (notes.cracking) {
    result_.wall_prestress_s = notes.wall_prestress_s;
  } else {
    pull();
    start_cracks();
  }
}

void Run::check_fit(const MarchNotes& notes) const {
  const auto refuse = [](const std::string& why) { throw std::invalid_argument("the checkpoint " + why); };
  if (notes.lane.size() != lane_.size() || notes.seats.size() != slot_.size() ||
      notes.lanes != ensemble_.lanes())
    refuse(fmt::format("is of {} scenarios in {} lanes, and this run has {} in {}", notes.lane.size(),
                       notes.lanes, lane_.size(), ensemble_.lanes()));
  if (notes.dt != prepared_.step.dt) refuse("is of another time step");
  const int scenarios = static_cast<int>(lane_.size());
  if (notes.next_scenario < 0 || notes.next_scenario > scenarios)
    refuse("names a waiting scenario that does not exist");
  for (const LaneSlot& slot : notes.seats)
    if (slot.scenario < -1 || slot.scenario >= scenarios)
      refuse("names a marching scenario that does not exist");
  if (notes.instructions != result_.instructions)
    refuse(fmt::format("was made with {} and this machine marches with {}: the bits would differ",
                       notes.instructions, result_.instructions));
}

}  // namespace rift::simulation
