#pragma once

#include "engine/fracture/cohesive_law.hpp"
#include "engine/base/clock.hpp"
#include "engine/scene/derived.hpp"
#include "engine/simulation/application_phase.hpp"
#include "engine/simulation/kept_march.hpp"
#include "engine/simulation/march.hpp"

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace rift::simulation {

/// A march while it goes: the loop and what is observed of it (march.cpp), what is asked of it on the way and
/// how it goes on from a checkpoint (march_control.cpp).
class Run {
 public:
  Run(const Prepared& prepared, const Observer& observer, const MarchOptions& options);
  RunResult march(const Resumption* from);

 private:
  using Clock = base::Clock;

  const scene::Scene& scene() const { return prepared_.preset.scene; }
  std::int64_t ramp() const { return prepared_.lane.front().schedule.ramp; }
  std::int64_t crack_start() const { return prepared_.lane.front().schedule.crack_start(); }
  int index(const LaneSlot& slot) const { return static_cast<int>(&slot - slot_.data()); }
  LanePlan& plan(const LaneSlot& slot) { return lane_[slot.scenario]; }
  LaneResult& lane_of(const LaneSlot& slot) { return result_.lane[slot.scenario]; }
  std::int64_t steps(const LaneSlot& slot) const { return ensemble_.steps_done(index(slot)); }
  bool ended(const LaneSlot& slot) {
    return lane_of(slot).outcome != Outcome::finished || steps(slot) >= plan(slot).schedule.total();
  }
  bool any_lane(const auto& is) { return std::any_of(slot_.begin(), slot_.end(), is); }
  bool busy() {
    return any_lane([](const LaneSlot& slot) { return slot.scenario >= 0; });
  }
  /// Whether scenarios wait for a lane. Where the grip moves in the march's time, no lane may begin later
  /// than the others.
  bool waiting() const {
    return !stopped_ && ramp() == 0 && !scene::grip_moves(scene()) &&
           next_scenario_ < static_cast<int>(prepared_.lane.size());
  }
  results::Phase phase_at(std::int64_t step) const {
    return step < ramp()          ? results::Phase::loading
           : step < crack_start() ? results::Phase::hold
                                  : results::Phase::fracture;
  }
  /// Time spent marching in this phase, the ramp or the cracks, in earlier calls too; not waiting for
  /// commands.
  double marching_s() const { return base::seconds_since(phase_started_) - waited_; }
  void start_clock(double marched_before_s) { phase_started_ = Clock::now(), waited_ = -marched_before_s; }

  // The loop.
  void begin();
  /// Marches the paper's way to pre-stress: pull, hold, both with numerical damping that is taken out
  /// afterwards. Goes on from the step that has been reached.
  void pull();
  void start_cracks();
  /// What the ensemble needs of the crack's phase, at its start and when a run is resumed in it.
  void begin_cracking(const std::vector<lattice::DampedBeam>& damped);
  void judge_rest(LaneSlot& slot);
  void step();
  /// Moves the grip as a load curve says.
  void follow_load();
  /// Ends the lanes whose last step is done, and those that were stopped or diverged.
  void end_finished();
  /// Leaves the lane idle.
  void end(LaneSlot& slot);
  /// Gives idle lanes the next scenarios in the queue.
  void refill();

  // Its observation.
  void observe(LaneSlot& slot);
  void tell_frame(LaneSlot& slot);
  void report_released();
  void add_sample(LaneSlot& slot);
  void read_gauges(const LaneSlot& slot);
  /// Where a lane's crack is now [m]: its tip, or how far beams have broken by themselves.
  double tip(const LaneSlot& slot) const;
  /// Of its tip, in its own time [m/s]; 0 of one that nobody moves.
  double speed(const LaneSlot& slot);
  /// Takes note of a beam that broke by itself; of all that have so far, in a lane just put in.
  void note_gone(int lane, int k);
  void find_gone(const LaneSlot& slot);
  void count_broken(LaneSlot& slot);
  results::Sample sample(const LaneSlot& slot);
  results::Frame frame(const LaneSlot& slot, const std::vector<std::string>& fields);
  void tell_end(const LaneSlot& slot) {
    if (observer_.ended) observer_.ended(slot.scenario, result_);
  }
  /// Ends the lane as diverged where something is wrong.
  void judge(LaneSlot& slot, const results::Sample& now);
  /// Judges all lanes: between two samples a divergence is not waited for.
  void watch();

  // The application phase.
  OwnCrack own_crack(const LaneSlot& slot) {
    return {prepared_, plan(slot), ensemble_, *tips_, index(slot), slot.rest};
  }
  /// Gives the tip a new velocity where it is time for one; a stop where the windows agree on it; a restart.
  void find_velocity(LaneSlot& slot);
  void stop_tip(LaneSlot& slot);
  void make_own_change(LaneSlot& slot, std::string_view axis, const std::string& value);

  // What is asked of it on the way.
  /// Asks whether to go on; if not, every lane stops where it is.
  void ask();
  /// Asks whoever steers and does what it says. @return whether to go on
  RunSnapshot snapshot(const Progress& progress);
  bool take_commands(const Progress& progress);
  void carry_out(SteeringCommands& commands);
  void stop_all();
  LaneSlot* slot_of(int scenario);
  /// Changes the scenario of a lane from the next step on. @return why not, or empty
  std::string make(LaneSlot& slot, const scene::Change& change);
  /// Damps what the lanes want damped, as far as the step bears it.
  std::string damp(LanePlan& lane, const std::vector<LanePlan>& lanes);
  /// Makes what the preset says was changed at this step.
  void repeat_changes();
  void count_steps();

  // How it goes on from a checkpoint.
  /// Where the march is, but for the samples of the lanes so far.
  results::Checkpoint checkpoint();
  void go_on(const Resumption& from);
  void check_fit(const MarchNotes& notes) const;

  const Prepared& prepared_;
  const Observer& observer_;
  std::vector<LanePlan> lane_;                      // as they are after the changes so far
  std::shared_ptr<ensemble::PrescribedTips> tips_;  // null where beams break by themselves
  ensemble::Ensemble ensemble_;
  RunResult result_;
  std::vector<LaneSlot> slot_;
  std::vector<fracture::BrokenBeams> broken_;  // of each slot, where beams break by themselves
  int next_scenario_ = 0;
  std::int64_t marched_ = 0;  // steps of the ensemble
  std::int64_t total_ = 0;
  std::int64_t asked_again_at_ = 1;  // of marched_, so that commands come before all else; 0: by the clock
  std::size_t damped_ = 0;           // beams
  double waited_ = 0;                // [s] for commands in this phase, less what was marched in earlier calls
  bool stopped_ = false;
  Clock::time_point phase_started_ = Clock::now(), asked_ = phase_started_;
};

}  // namespace rift::simulation
