#pragma once

#include "engine/base/clock.hpp"
#include "engine/ensemble/ensemble.hpp"
#include "engine/fracture/equation_of_motion.hpp"
#include "engine/scene/derived.hpp"
#include "engine/simulation/kept_march.hpp"
#include "engine/simulation/march.hpp"
#include "engine/simulation/steering.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// A march while it goes: the loop (march.cpp), whether it goes well (march_watch.cpp), what is asked of it
/// on the way (march_steering.cpp), where it leads by itself (march_own_way.cpp), and how it goes on from a
/// checkpoint (march_resume.cpp).
namespace rift::simulation {

using Clock = std::chrono::steady_clock;

/// A lane and the scenario in it.
struct Seat {
  int scenario = -1;  // none: the lane is idle
  std::size_t next_sample = 0, next_frame = 0;
  std::int64_t framed_at = -1;  // the step of the last frame
  Rest rest = {};
  double since_s = 0;  // of the time that cracks have run for, when its own began
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
    for (int k = 0; k < static_cast<int>(lane_.size()); ++k) check_steering(prepared_, lane_, k, 0);
    result_.lanes = ensemble_.scenarios();
    result_.instructions = ensemble::name_of(ensemble::instruction_set());
  }

  RunResult march(const Resumption* from);

 private:
  static ensemble::Ensemble<Real> make_ensemble(const Prepared& p, const MarchOptions& options);

  const scene::Scene& scene() const { return prepared_.preset.scene; }
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

  results::Phase phase_at(std::int64_t step) const {
    return step < ramp()          ? results::Phase::loading
           : step < crack_start() ? results::Phase::hold
                                  : results::Phase::fracture;
  }

  bool ended(const Seat& seat) {
    return lane_of(seat).outcome != Outcome::finished || steps(seat) >= plan(seat).schedule.total();
  }

  /// Whether the grip moves in the march's time, so that no lane may begin later than the others.
  bool moves_grip() const { return ramp() > 0 || scene::grip_moves(scene()); }
  bool waiting() const {
    return !stopped_ && !moves_grip() && next_scenario_ < static_cast<int>(prepared_.lane.size());
  }

  /// Time spent marching in this phase, the ramp or the cracks, in earlier calls too; not waiting for orders.
  double marching_s() const { return base::seconds_since(phase_started_) - waited_; }
  void start_clock(double marched_before_s) { phase_started_ = Clock::now(), waited_ = -marched_before_s; }

  // The loop (march.cpp).
  void begin();
  /// The paper's way to pre-stress: pull, hold, both with numerical damping that is taken out afterwards.
  /// Goes on from the step that has been reached.
  void pull();
  void start_cracks();
  void judge_rest(Seat& seat);
  void step();
  /// Moves the grip as a load curve says.
  void follow_load();
  /// Leaves the lane idle.
  void end(Seat& seat);
  /// Idle lanes go on with the next scenarios in the queue.
  void refill();
  void observe(Seat& seat);
  void tell_frame(Seat& seat);
  void report_released();
  void read_books(Seat& seat);
  void read_gauges(const Seat& seat);
  /// Why a row cannot be of a plate that cracks; empty where it can.
  std::string what_is_wrong(const LaneResult& lane, const results::Sample& row);
  /// Ends the lane as diverged where something is wrong.
  void judge(Seat& seat, const results::Sample& row);
  /// Between two samples a divergence is not waited for.
  void watch();
  results::Sample books(const Seat& seat);
  results::Frame frame(const Seat& seat, const std::vector<std::string>& fields);
  /// The element that is lost first or fastest and its most strained beam, for the message.
  std::string where_it_diverges(int lane);
  /// What the crack has left, in the scenario's units.
  fracture::Wake wake(const Seat& seat);
  void tell_end(const Seat& seat) {
    if (observer_.ended) observer_.ended(seat.scenario, result_);
  }
  bool any_sound() {
    return std::any_of(seat_.begin(), seat_.end(),
                       [&](const Seat& seat) { return lane_of(seat).outcome == Outcome::finished; });
  }

  // Cracks that run by themselves (march_own_way.cpp).
  /// A new velocity where it is time for one; a stop where the windows agree on it; a restart.
  void find_velocity(Seat& seat);
  /// The tip's velocity in c_r by what it has released; none where it stops.
  std::optional<double> velocity_of(const Seat& seat, double tip) const;
  void turn(Seat& seat, double over_cr);
  void stop_tip(Seat& seat, double tip);
  void await_restart(Seat& seat);
  /// The strain energy that the beams of the path in a window ahead of the tip would have undamaged.
  double energy_ahead(const Seat& seat, double tip, double window) const;
  double toughness_window(const Seat& seat) const;  // [m]
  double runs_from(const Seat& seat) const;         // [m] crack.start, or where the tip restarted last
  /// The beams that the tip has released from a position on [m].
  std::vector<fracture::ReleasedBeam> released(const Seat& seat, double from) const;

  // What is asked of it on the way (march_steering.cpp).
  /// Whether to go on; if not, every lane stops where it is.
  void ask();
  /// Asks whoever steers and does what it says. @return whether to go on
  bool take_orders(const Progress& progress);
  void carry_out(Orders& orders);
  void stop_all();
  static void stop(LaneResult& lane, std::string where) {
    lane.outcome = Outcome::stopped;
    lane.where = std::move(where);
  }
  Seat* seat_of(int scenario) {
    const auto seat = std::find_if(seat_.begin(), seat_.end(),
                                   [&](const Seat& s) { return s.scenario >= 0 && s.scenario == scenario; });
    return seat == seat_.end() ? nullptr : &*seat;
  }
  /// Changes the scenario of a lane from the next step on. @return why not, or empty
  std::string make(Seat& seat, const scene::Change& change);
  /// Damps what the lanes want damped, as far as the step bears it.
  std::string damp(LanePlan& lane, const std::vector<LanePlan>& lanes);
  /// Makes what the preset says was changed at this step.
  void repeat_changes();
  bool was_made(const scene::Change& change) const {
    const std::vector<scene::Change>& made = result_.lane[change.lane].changes;
    return std::find(made.begin(), made.end(), change) != made.end();
  }

  // How it goes on from a checkpoint (march_resume.cpp).
  /// Where the march is; what the lanes' books tell is not repeated.
  results::Checkpoint checkpoint();
  void go_on(const Resumption& from);
  void check_fit(const MarchNotes& notes) const;

  const Prepared& prepared_;
  const Observer& observer_;
  std::vector<LanePlan> lane_;  // as they are after the changes so far
  ensemble::Ensemble<Real> ensemble_;
  RunResult result_;
  std::vector<Seat> seat_;
  int next_scenario_ = 0;
  std::int64_t marched_ = 0;  // steps of the ensemble
  std::int64_t total_ = 0;
  std::int64_t asked_again_at_ = 1;  // of marched_, so that orders come before all else; 0: by the clock
  std::size_t damped_ = 0;           // beams
  double waited_ = 0;                // [s] for orders in this phase, less what was marched in earlier calls
  bool stopped_ = false;
  Clock::time_point phase_started_ = Clock::now(), asked_ = phase_started_;
};

}  // namespace rift::simulation
