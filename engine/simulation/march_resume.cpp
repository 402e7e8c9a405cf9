#include "engine/simulation/change_lane.hpp"
#include "engine/simulation/march_run.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace rift::simulation {

template <class Real>
results::Checkpoint Run<Real>::checkpoint() {
  MarchNotes notes{.lanes = ensemble_.lanes(),
                   .instructions = result_.instructions,
                   .dt = prepared_.step.dt,
                   .marched = marched_,
                   .lane_steps = result_.lane_steps,
                   .next_scenario = next_scenario_,
                   .cracking = ensemble_.cracking(),
                   .wall_prestress_s = ensemble_.cracking() ? result_.wall_prestress_s : marching_s(),
                   .wall_fracture_s = ensemble_.cracking() ? marching_s() : 0.0};
  for (const Seat& seat : seat_)
    notes.seats.push_back(
        {seat.scenario, seat.next_sample, seat.next_frame, seat.framed_at, seat.rest, seat.since_s});
  notes.lane = result_.lane;
  return {to_json(notes), ensemble_.state(), 0};
}

template <class Real>
void Run<Real>::go_on(const Resumption& from) {
  MarchNotes notes = march_notes(from.checkpoint.notes);
  check_fit(notes);
  result_.lane = std::move(notes.lane);
  for (const results::Sample& row : from.books) {
    if (row.lane >= static_cast<int>(result_.lane.size()))
      throw std::invalid_argument("the journal holds rows of a lane that this run does not have");
    result_.lane[row.lane].books.push_back(row);
  }
  for (int k = 0; k < static_cast<int>(lane_.size()); ++k)
    for (const scene::Change& change : result_.lane[k].changes)
      (void)change_lane(lane_[k], change, prepared_, change.step);
  for (std::size_t k = 0; k < seat_.size(); ++k) {
    const MarchNotes::Seat& s = notes.seats[k];
    seat_[k] = {s.scenario, s.next_sample, s.next_frame, s.framed_at, s.rest, s.since_s};
    if (s.scenario >= 0) ensemble_.steer(static_cast<int>(k), lane_[s.scenario].scenario);
  }
  if (notes.cracking) {
    const std::vector<lattice::DampedBeam> damped = damped_beams(prepared_, lane_);
    damped_ = damped.size();
    ensemble_.set_beta(scene().solver.beta);
    ensemble_.start_crack(damped);
  }
  ensemble_.restore(from.checkpoint.state);
  marched_ = notes.marched, result_.lane_steps = notes.lane_steps, next_scenario_ = notes.next_scenario;
  total_ = 0;
  for (const LanePlan& lane : lane_) total_ += lane.schedule.total();
  start_clock(notes.cracking ? notes.wall_fracture_s : notes.wall_prestress_s);
  if (notes.cracking) {
    result_.wall_prestress_s = notes.wall_prestress_s;
  } else {
    pull();
    start_cracks();
  }
}

template <class Real>
void Run<Real>::check_fit(const MarchNotes& notes) const {
  const auto refuse = [](const std::string& why) { throw std::invalid_argument("the checkpoint " + why); };
  if (notes.lane.size() != lane_.size() || notes.seats.size() != seat_.size() ||
      notes.lanes != ensemble_.lanes())
    refuse(fmt::format("is of {} scenarios in {} lanes, and this run has {} in {}", notes.lane.size(),
                       notes.lanes, lane_.size(), ensemble_.lanes()));
  if (notes.dt != prepared_.step.dt) refuse("is of another time step");
  const int scenarios = static_cast<int>(lane_.size());
  if (notes.next_scenario < 0 || notes.next_scenario > scenarios)
    refuse("waits for a scenario that is not there");
  for (const MarchNotes::Seat& seat : notes.seats)
    if (seat.scenario < -1 || seat.scenario >= scenarios) refuse("marches a scenario that is not there");
  if (notes.instructions != result_.instructions)
    refuse(fmt::format("was made with {} and this machine marches with {}: the bits would differ",
                       notes.instructions, result_.instructions));
}

template results::Checkpoint Run<double>::checkpoint();
template results::Checkpoint Run<float>::checkpoint();
template void Run<double>::go_on(const Resumption&);
template void Run<float>::go_on(const Resumption&);

}  // namespace rift::simulation
