#include "engine/simulation/march.hpp"

#include "engine/base/process_limits.hpp"
#include "engine/scene/derived.hpp"
#include "engine/scene/issue.hpp"
#include "engine/simulation/march_run.hpp"
#include "engine/simulation/schedule.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rift::simulation {
namespace {

constexpr double largest_residual_inertia = 0.01;  // of the ramp: kinetic over total energy   [physics.md §4]
/// Steps from one moment at which idle lanes may be filled to the next: lanes that begin a power of two of
/// steps apart are looked at in the same steps, which costs one look.
constexpr std::int64_t between_refills = 64;
/// Steps from one look at the books to the next where no sample is due. A look costs about two steps.
constexpr std::int64_t between_watches = 128;

/// Whether the grip, which all lanes have, moves as they march: they must start together then.
bool moves_one_grip(const Prepared& p) {
  return p.lane.front().schedule.ramp > 0 || scene::grip_moves(p.preset.scene);
}

/// Scenarios side by side: as many as fill a register, beyond which a lane is slower and waits better. Those
/// that share a moving grip cannot wait.
template <class Real>
int most_side_by_side(const Prepared& p, int wished) {
  if (wished > 0) return wished;
  return moves_one_grip(p) ? ensemble::most_lanes<Real>
                           : ensemble::lanes_in_register<Real>(ensemble::instruction_set());
}

}  // namespace

template <class Real>
RunResult Run<Real>::march(const Resumption* from) {
  ensemble_.start_from(prepared_.displacement);
  result_.threads = ensemble_.threads();
  if (from)
    go_on(*from);
  else
    begin();
  while (busy() || waiting()) {
    if (waiting() && (!busy() || marched_ % between_refills == 0)) refill();
    if (!prepared_.preset.steering.empty()) repeat_changes();
    if (scene::grip_moves(scene())) follow_load();
    step();
    for (Seat& seat : seat_)
      if (seat.scenario >= 0 && ended(seat)) end(seat);
  }
  result_.wall_fracture_s = marching_s();
  if (observer_.checkpoint && !stopped_)
    observer_.checkpoint([this] { return checkpoint(); }, CheckpointMoment::at_end);
  if (std::any_of(result_.lane.begin(), result_.lane.end(),
                  [](const LaneResult& lane) { return !lane.changes.empty(); }))
    result_.steered = std::move(lane_);
  for (const LaneResult& lane : result_.lane) result_.outcome = std::max(result_.outcome, lane.outcome);
  return std::move(result_);
}

template <class Real>
ensemble::Ensemble<Real> Run<Real>::make_ensemble(const Prepared& p, const MarchOptions& options) {
  const int most = most_side_by_side<Real>(p, options.lanes);
  std::vector<fracture::LaneScenario> first;
  for (const LanePlan& lane : p.lane)
    if (static_cast<int>(first.size()) < most) first.push_back(lane.scenario);
  const bool touching = std::any_of(p.lane.begin(), p.lane.end(),
                                    [](const LanePlan& lane) { return lane.scenario.friction.has_value(); });
  return ensemble::Ensemble<Real>(p.lattice, p.path, p.preset.scene.crack.start, p.step.dt, first,
                                  {.kinematics = p.preset.scene.solver.kinematics,
                                   .threads = base::threads_or_all_cpus(options.threads),
                                   .lanes = options.lanes > 0 ? ensemble::lanes_for<Real>(options.lanes) : 0,
                                   .contact = touching});
}

template <class Real>
void Run<Real>::step() {
  ensemble_.step();
  ++marched_;
  for (Seat& seat : seat_)
    if (seat.scenario >= 0) ++result_.lane_steps;
  report_released();
  for (Seat& seat : seat_)
    if (seat.scenario >= 0) observe(seat), find_velocity(seat);
  if (marched_ % between_watches == 0) watch();
  ask();
}

/// A load curve moves the one grip that all lanes have, by a clock that all lanes have (check_grip).
template <class Real>
void Run<Real>::follow_load() {
  const LanePlan& first = prepared_.lane.front();
  const auto displacement = [&](std::int64_t steps) {  // the clock stands until the crack starts
    const double since = static_cast<double>(steps) * ensemble_.dt() * first.units.time - first.lead;
    return scene::load_at(scene().loading.curve, scene::load_time(scene()) + std::max(0.0, since));
  };
  ensemble_.set_grip_speed((displacement(marched_ + 1) - displacement(marched_)) / ensemble_.dt());
}

template <class Real>
void Run<Real>::begin() {
  if (ramp() > 0) {
    ensemble_.set_beta(scene().loading.ramp_beta);
    ensemble_.set_grip_speed(prepared_.pulled / (static_cast<double>(ramp()) * ensemble_.dt()));
    for (Seat& seat : seat_) observe(seat);
    pull();
  }
  start_cracks();
}

template <class Real>
void Run<Real>::start_cracks() {
  start_clock(0.0);
  damped_ = prepared_.damped.size();
  ensemble_.set_beta(scene().solver.beta);
  ensemble_.start_crack(prepared_.damped);
  for (Seat& seat : seat_) {
    if (seat.scenario < 0) continue;
    lane_of(seat).energy_at_crack_start = elastic_energy(seat);
    if (ramp() == 0) observe(seat);
  }
}

template <class Real>
void Run<Real>::end(Seat& seat) {
  LaneResult& lane = lane_of(seat);
  lane.steps = steps(seat);
  lane.wall_s = (marching_s() - seat.since_s) / static_cast<double>(seat_.size());
  result_.wall_fracture_s = marching_s();
  if (lane.outcome == Outcome::finished) lane.wake = wake(seat);
  tell_end(seat);
  seat.scenario = -1;
}

template <class Real>
void Run<Real>::refill() {
  for (Seat& seat : seat_) {
    if (seat.scenario >= 0 || !waiting()) continue;
    seat = {.scenario = next_scenario_++, .since_s = marching_s()};
    ensemble_.refill(index(seat), plan(seat).scenario);
    lane_of(seat).energy_at_crack_start = elastic_energy(seat);
    observe(seat);
  }
}

template <class Real>
void Run<Real>::observe(Seat& seat) {
  const Schedule& schedule = plan(seat).schedule;
  const std::int64_t n = steps(seat);
  if (seat.next_sample < schedule.samples.size() && n == schedule.samples[seat.next_sample]) {
    ++seat.next_sample;
    read_books(seat);
    read_gauges(seat);
  }
  if (seat.next_frame < schedule.frames.size() && n == schedule.frames[seat.next_frame]) {
    ++seat.next_frame;
    tell_frame(seat);
  }
}

template <class Real>
void Run<Real>::read_gauges(const Seat& seat) {
  if (!observer_.gauge) return;
  const int lane = index(seat);
  const LaneUnits& units = plan(seat).units;
  for (std::size_t g = 0; g < prepared_.gauge.size(); ++g) {
    const auto& [point, plane] = prepared_.gauge[g];
    const lattice::PlaneMotion moved = lattice::motion_in(
        plane, [&](int i) -> Eigen::Vector3d { return ensemble_.motion(i, lane).template head<3>(); });
    const lattice::PlaneMotion rate = lattice::motion_in(plane, [&](int i) -> Eigen::Vector3d {
      return ensemble_.velocity(i, lane).template head<3>() / units.time;
    });
    observer_.gauge({.step = steps(seat),
                     .time_s = ensemble_.time(lane) * units.time,
                     .lane = seat.scenario,
                     .gauge = static_cast<std::int32_t>(g),
                     .x_m = point[0],
                     .y_m = point[1],
                     .ux_m = moved.u.x(),
                     .uy_m = moved.u.y(),
                     .uz_m = moved.u.z(),
                     .vx_m_s = rate.u.x(),
                     .vy_m_s = rate.u.y(),
                     .vz_m_s = rate.u.z(),
                     .strain_xx = moved.strain_xx(),
                     .strain_yy = moved.strain_yy(),
                     .strain_xy = moved.strain_xy()});
  }
}

template <class Real>
void Run<Real>::tell_frame(Seat& seat) {
  if (seat.framed_at == steps(seat)) return;  // as often as it is asked for, once
  seat.framed_at = steps(seat);
  if (observer_.frame) observer_.frame(frame(seat, scene().output.fields));
}

template <class Real>
results::Sample Run<Real>::books(const Seat& seat) {
  results::Sample row = plan(seat).units.of_lane(ensemble_.sample(index(seat), phase_at(steps(seat))));
  row.lane = seat.scenario;
  return row;
}

template <class Real>
results::Frame Run<Real>::frame(const Seat& seat, const std::vector<std::string>& fields) {
  results::Frame frame = frame_of(ensemble_, index(seat), fields, plan(seat).units);
  frame.lane = seat.scenario;
  return frame;
}

template <class Real>
fracture::Wake Run<Real>::wake(const Seat& seat) {
  const int lane = index(seat);
  const LaneUnits& units = plan(seat).units;
  const double tip = ensemble_.tip(lane);
  std::vector<lattice::Vector6> velocity(prepared_.lattice.centre.size());
  std::vector<double> moved(velocity.size());
  for (int i = 0; i < static_cast<int>(velocity.size()); ++i) {
    velocity[i] = ensemble_.velocity(i, lane) / units.time;
    moved[i] = ensemble_.motion(i, lane).z() - prepared_.displacement[i].z();
  }
  const packing::Box& box = prepared_.lattice.box;
  const double middle = 0.5 * fracture::length_of(prepared_.path);
  const auto x = [&](double arc) { return fracture::point_on(prepared_.path, arc).x(); };
  const std::array<double, 2> behind = prepared_.path.tips == 2
                                           ? std::array{x(middle - tip), x(middle + tip)}
                                           : std::array{x(tip) - 2.0 * box.height, x(tip)};
  return fracture::wake_of(prepared_.lattice, behind, velocity, moved);
}

template <class Real>
void Run<Real>::report_released() {
  if (!observer_.event) return;
  for (const ensemble::Softening& c : ensemble_.softening()) {
    if (c.after != 0.0 || seat_[c.lane].scenario < 0) continue;
    const LaneUnits& units = plan(seat_[c.lane]).units;
    observer_.event({.beam = ensemble_.met()[c.crossing].beam,
                     .lane = seat_[c.lane].scenario,
                     .time_s = ensemble_.time(c.lane) * units.time,
                     .position_m = ensemble_.met()[c.crossing].position,
                     .energy_j = ensemble_.booked(c.crossing, c.lane) * units.energy});
  }
}

template <class Real>
void Run<Real>::pull() {
  while (marched_ < crack_start() && !stopped_ && any_sound()) {
    if (marched_ == ramp()) ensemble_.set_grip_speed(0.0);
    step();
  }
  ensemble_.set_grip_speed(0.0);
  result_.wall_prestress_s = marching_s();
  for (Seat& seat : seat_) judge_rest(seat);
}

template <class Real>
void Run<Real>::judge_rest(Seat& seat) {
  LaneResult& lane = lane_of(seat);
  const fracture::LatticeEnergy e = ensemble_.energy(index(seat));
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
// What is defined here; the other files of Run see to theirs.
template class Run<double>;
template class Run<float>;

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

double ledger_limit(lattice::Kinematics kinematics, ensemble::Precision precision) {
  if (precision == ensemble::Precision::single_precision) return 1e-3;
  return kinematics == lattice::Kinematics::corotational ? 1e-4 : 1e-10;
}

void check_grip(const Prepared& p, int side_by_side) {
  if (!moves_one_grip(p)) return;
  const bool ramp = p.lane.front().schedule.ramp > 0;
  const auto refuse = [&](const std::string& why) {
    throw scene::InputError({scene::issue_at(p.preset, ramp ? "loading.method" : "loading.curve",
                                             "moves the grip of all lanes at once: " + why)});
  };
  const bool in_double = p.preset.scene.solver.precision == ensemble::Precision::double_precision;
  const int most =
      in_double ? most_side_by_side<double>(p, side_by_side) : most_side_by_side<float>(p, side_by_side);
  if (static_cast<int>(p.lane.size()) > most)
    refuse(fmt::format("at most {} go side by side, not {}", most, p.lane.size()));
  if (ramp) return;
  for (const LanePlan& lane : p.lane) {
    if (lane.lead != p.lane.front().lead)
      refuse("their damage zones or histories differ, so that their cracks do not start together");
    if (lane.units.time != p.lane.front().units.time) refuse("their material.stiffness differs");
  }
}

RunResult march(const Prepared& prepared, const Observer& observer, const MarchOptions& options,
                const Resumption* from) {
  check_grip(prepared, options.lanes);
  if (prepared.preset.scene.solver.precision == ensemble::Precision::single_precision)
    return Run<float>(prepared, observer, options).march(from);
  return Run<double>(prepared, observer, options).march(from);
}

}  // namespace rift::simulation
