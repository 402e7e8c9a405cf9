#include "engine/simulation/march.hpp"

#include "engine/base/process_limits.hpp"
#include "engine/ensemble/breaking_beams.hpp"
#include "engine/scene/derived.hpp"
#include "engine/scene/issue.hpp"
#include "engine/simulation/march_run.hpp"
#include "engine/simulation/steering.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace rift::simulation {
namespace {

constexpr double largest_residual_inertia = 0.01;  // of the ramp: kinetic over total energy   [model.md §4]
/// Steps from one look at the energies to the next where no sample is due.
constexpr std::int64_t between_watches = 128;

/// No lattice can hold so many times the energy that was put into it. A stable step shows more than there is
/// by C, at most 1 / (1 - (dt / dt_c)^2) times of it, and only where all of it is in the highest mode.
constexpr double more_than_there_is = 1000.0;

/// Whether the grip, which all lanes have, moves as they march: they must start together then.
bool moves_one_grip(const Prepared& p) {
  return p.lane.front().schedule.ramp > 0 || scene::grip_moves(p.preset.scene);
}

/// Scenarios side by side: as many as fill a register, beyond which a lane is slower and waits better. Those
/// that share a moving grip cannot wait.
int most_side_by_side(const Prepared& p, int wished) {
  if (wished > 0) return wished;
  const ensemble::Precision precision = p.preset.scene.solver.precision;
  return moves_one_grip(p) ? ensemble::most_lanes(precision)
                           : ensemble::lanes_in_register(precision, ensemble::instruction_set());
}

/// Within so many mean radii broken beams count as near each other.
constexpr double near_radii = 2.0;

bool breaks_freely(const Prepared& p) { return scene::breaks_freely(p.preset.scene); }

std::vector<fracture::DamageableBeam> damageable_beams(const Prepared& p) {
  const double notch = p.preset.scene.crack.start;
  return breaks_freely(p) ? fracture::breakable_beams(p.path, p.lattice, notch)
                          : fracture::damageable_beams(p.path, p.lattice, notch);
}

Eigen::Vector2d middle_of(const lattice::Lattice& lattice, int beam) {
  const auto& [i, j] = lattice.ends[beam];
  return 0.5 * (lattice.centre[i].head<2>() + lattice.centre[j].head<2>());
}

std::vector<fracture::LaneScenario> first_scenarios(const Prepared& p, int side_by_side) {
  std::vector<fracture::LaneScenario> first;
  for (const LanePlan& lane : p.lane)
    if (static_cast<int>(first.size()) < most_side_by_side(p, side_by_side)) first.push_back(lane.scenario);
  return first;
}

ensemble::EnsembleOptions ensemble_options(const Prepared& p, const MarchOptions& options) {
  const scene::Scene::Solver& solver = p.preset.scene.solver;
  return {.kinematics = solver.kinematics,
          .precision = solver.precision,
          .threads = base::threads_or_all_cpus(options.threads),
          .lanes = options.lanes > 0 ? ensemble::lanes_for(solver.precision, options.lanes) : 0,
          .contact = std::any_of(p.lane.begin(), p.lane.end(),
                                 [](const LanePlan& lane) { return lane.scenario.friction.has_value(); })};
}

/// The motion that a lane's crack has left.
fracture::Wake wake_of(const Prepared& p, ensemble::Ensemble& ensemble, int lane, double tip) {
  std::vector<lattice::Vector6> velocity(p.lattice.centre.size());
  std::vector<double> moved(velocity.size());
  for (int i = 0; i < static_cast<int>(velocity.size()); ++i) {
    velocity[i] = ensemble.velocity(i, lane);
    moved[i] = ensemble.motion(i, lane).z() - p.displacement[i].z();
  }
  const packing::Box& box = p.lattice.box;
  const double middle = 0.5 * fracture::length_of(p.path);
  const auto x = [&](double arc) { return fracture::point_on(p.path, arc).x(); };
  const std::array<double, 2> behind = p.path.tips == 2 ? std::array{x(middle - tip), x(middle + tip)}
                                                        : std::array{x(tip) - 2.0 * box.height, x(tip)};
  return fracture::wake_of(p.lattice, behind, velocity, moved);
}

/// Why a sample cannot be of a plate that cracks; empty where it can.
std::string what_is_wrong(const scene::Scene::Solver& solver, const LaneResult& lane,
                          const results::Sample& now) {
  const bool exact = solver.kinematics == lattice::Kinematics::linear &&
                     solver.precision == ensemble::Precision::double_precision;
  if (!(std::abs(now.residual) <= (exact ? 1e-6 : 0.1)))
    return fmt::format("the balance error is {:.3g} of the largest energy", now.residual);
  const double held = now.elastic_j + now.kinetic_translation_j + now.kinetic_rotation_j;
  const double put_in = lane.energy_at_crack_start + std::max(0.0, now.work_external_j);
  if (held > more_than_there_is * put_in && put_in > 0.0)
    return fmt::format("the lattice holds {:.3g} times the energy supplied to it", held / put_in);
  return "";
}

/// The element that is lost first or fastest and its most strained beam, for the message.
std::string where_it_diverges(const lattice::Lattice& lattice, ensemble::Ensemble& ensemble, int lane) {
  int worst = 0;
  double most = -1.0;
  for (int i = 0; i < static_cast<int>(lattice.centre.size()) && std::isfinite(most); ++i) {
    const lattice::Vector6 v = ensemble.velocity(i, lane);
    const double energy =
        lattice.mass[i] * v.head<3>().squaredNorm() + lattice.inertia[i] * v.tail<3>().squaredNorm();
    if (energy > most || !std::isfinite(energy)) most = energy, worst = i;
  }
  const bool lost = !std::isfinite(most);
  most = -1.0;
  int beam = -1;
  for (int b = 0; b < static_cast<int>(lattice.beam.size()); ++b) {
    const auto& [i, j] = lattice.ends[b];
    if (i != worst && j != worst) continue;
    const double energy = ensemble.beam_energy(b, lane);
    if (!(energy <= most)) most = energy, beam = b;
  }
  return fmt::format(", {} element {}, and its most strained beam is {}",
                     lost ? "the first without a finite energy is" : "the fastest is", worst, beam);
}

}  // namespace

Run::Run(const Prepared& prepared, const Observer& observer, const MarchOptions& options)
    : prepared_(prepared),
      observer_(observer),
      lane_(prepared.lane),
      tips_(breaks_freely(prepared) ? nullptr : std::make_shared<ensemble::PrescribedTips>(prepared.step.dt)),
      ensemble_(prepared.lattice, damageable_beams(prepared), prepared.step.dt,
                first_scenarios(prepared, options.lanes), ensemble_options(prepared, options),
                tips_ ? std::shared_ptr<ensemble::ReleaseRule>(tips_)
                      : std::make_shared<ensemble::BreakingBeams>(prepared.lattice, prepared.step.dt)),
      slot_(ensemble_.scenarios()),
      broken_(tips_ ? 0 : slot_.size(), fracture::BrokenBeams(near_radii * prepared.lattice.mean_radius)) {
  result_.lane.resize(prepared.lane.size());
  for (LaneSlot& slot : slot_) {
    slot.scenario = next_scenario_++;
    ensemble_.set_units(index(slot), plan(slot).units);
  }
  count_steps();
  for (int k = 0; k < static_cast<int>(lane_.size()); ++k) check_steering(prepared_, lane_, k, 0);
  result_.lanes = ensemble_.scenarios();
  result_.instructions = ensemble::name_of(ensemble::instruction_set());
}

RunResult Run::march(const Resumption* from) {
  if (!prepared_.outside.empty()) ensemble_.set_loads(prepared_.outside);
  ensemble_.set_rollers(prepared_.rollers);
  ensemble_.start_from(prepared_.displacement);
  result_.threads = ensemble_.threads();
  if (from)
    go_on(*from);
  else
    begin();
  end_finished();  // a checkpoint may have been made at a lane's last step
  while (busy() || waiting()) {
    if (waiting()) refill();
    if (!prepared_.preset.steering.empty()) repeat_changes();
    if (scene::grip_moves(scene())) follow_load();
    step();
    end_finished();
  }
  result_.wall_fracture_s = marching_s();
  result_.lane_room = marched_ * ensemble_.lanes();
  if (observer_.checkpoint && !stopped_)
    observer_.checkpoint([this] { return checkpoint(); }, CheckpointMoment::at_end);
  if (std::any_of(result_.lane.begin(), result_.lane.end(),
                  [](const LaneResult& lane) { return !lane.changes.empty(); }))
    result_.steered = std::move(lane_);
  for (const LaneResult& lane : result_.lane) result_.outcome = std::max(result_.outcome, lane.outcome);
  return std::move(result_);
}

void Run::begin() {
  if (ramp() > 0) {
    ensemble_.set_beta(scene().loading.ramp_beta);
    ensemble_.set_grip_speed(prepared_.pulled / (static_cast<double>(ramp()) * ensemble_.dt()));
    for (LaneSlot& slot : slot_) observe(slot);
    pull();
  }
  start_cracks();
}

void Run::pull() {
  while (marched_ < crack_start() && !stopped_ &&
         any_lane([&](const LaneSlot& slot) { return lane_of(slot).outcome == Outcome::finished; })) {
    if (marched_ == ramp()) ensemble_.set_grip_speed(0.0);
    step();
  }
  ensemble_.set_grip_speed(0.0);
  result_.wall_prestress_s = marching_s();
  for (LaneSlot& slot : slot_) judge_rest(slot);
}

void Run::judge_rest(LaneSlot& slot) {
  LaneResult& lane = lane_of(slot);
  const fracture::EnergyBalance now = ensemble_.balance(index(slot));
  lane.prestress_kinetic = (now.kinetic_translation + now.kinetic_rotation) / now.total();
  if (lane.outcome == Outcome::finished && !(lane.prestress_kinetic <= largest_residual_inertia)) {
    lane.outcome = Outcome::diverged;
    lane.where = fmt::format(
        "after the ramp {:.2g} of the energy is kinetic (limit {:g}): not quasi-static; "
        "raise loading.ramp_steps or loading.hold_steps",
        lane.prestress_kinetic, largest_residual_inertia);
  }
  lane.steps = steps(slot);
  if (lane.outcome == Outcome::finished) return;
  tell_end(slot);
  slot.scenario = -1;
}

void Run::start_cracks() {
  start_clock(0.0);
  begin_cracking(prepared_.damped);
  for (LaneSlot& slot : slot_) {
    if (slot.scenario < 0) continue;
    lane_of(slot).energy_at_crack_start = ensemble_.balance(index(slot)).elastic;
    if (ramp() == 0) observe(slot);
  }
}

void Run::refill() {
  for (LaneSlot& slot : slot_) {
    if (slot.scenario >= 0 || !waiting()) continue;
    slot = {.scenario = next_scenario_++, .since_s = marching_s()};
    ensemble_.set_units(index(slot), plan(slot).units);
    ensemble_.refill(index(slot), plan(slot).scenario);
    if (!tips_) find_gone(slot);
    lane_of(slot).energy_at_crack_start = ensemble_.balance(index(slot)).elastic;
    observe(slot);
  }
}

void Run::end_finished() {
  for (LaneSlot& slot : slot_)
    if (slot.scenario >= 0 && ended(slot)) end(slot);
}

void Run::end(LaneSlot& slot) {
  LaneResult& lane = lane_of(slot);
  lane.steps = steps(slot);
  lane.wall_s = (marching_s() - slot.since_s) / static_cast<double>(slot_.size());
  result_.wall_fracture_s = marching_s();
  if (lane.outcome == Outcome::finished) lane.wake = wake_of(prepared_, ensemble_, index(slot), tip(slot));
  if (!tips_) count_broken(slot);
  if (observer_.last_moment) observer_.last_moment(snapshot({}), slot.scenario);
  tell_end(slot);
  slot.scenario = -1;
}

void Run::step() {
  ensemble_.step();
  ++marched_;
  for (LaneSlot& slot : slot_)
    if (slot.scenario >= 0) ++result_.lane_steps;
  report_released();
  for (LaneSlot& slot : slot_)
    if (slot.scenario >= 0) observe(slot), find_velocity(slot);
  if (marched_ % between_watches == 0) watch();
  ask();
}

/// A load curve moves the one grip that all lanes have, by a clock that all lanes have (check_grip).
void Run::follow_load() {
  const LanePlan& first = prepared_.lane.front();
  const auto displacement = [&](std::int64_t steps) {  // the clock stands until the crack starts
    const double since = static_cast<double>(steps) * ensemble_.dt() * first.units.time - first.lead;
    return scene::load_at(scene().loading.curve, scene::load_time(scene()) + std::max(0.0, since));
  };
  ensemble_.set_grip_speed((displacement(marched_ + 1) - displacement(marched_)) / ensemble_.dt());
}

void Run::observe(LaneSlot& slot) {
  const Schedule& schedule = plan(slot).schedule;
  const std::int64_t n = steps(slot);
  if (slot.next_sample < schedule.samples.size() && n == schedule.samples[slot.next_sample]) {
    ++slot.next_sample;
    add_sample(slot);
    read_gauges(slot);
  }
  if (slot.next_frame < schedule.frames.size() && n == schedule.frames[slot.next_frame]) {
    ++slot.next_frame;
    tell_frame(slot);
  }
}

void Run::tell_frame(LaneSlot& slot) {
  if (slot.framed_at == steps(slot)) return;  // as often as it is asked for, once
  slot.framed_at = steps(slot);
  if (observer_.frame) observer_.frame(frame(slot, scene().output.fields));
}

results::Frame Run::frame(const LaneSlot& slot, const std::vector<std::string>& fields) {
  results::Frame frame = frame_of(ensemble_, index(slot), fields);
  frame.lane = slot.scenario;
  frame.tip_m = tip(slot);
  return frame;
}

results::Sample Run::sample(const LaneSlot& slot) {
  const int lane = index(slot);
  results::Sample sample = sample_of(ensemble_.balance(lane));
  sample.step = steps(slot);
  sample.time_s = ensemble_.time(lane);
  sample.phase = phase_at(sample.step);
  sample.lane = slot.scenario;
  sample.grip_force_n = ensemble_.grip_force(lane);
  sample.tip_m = tip(slot);
  if (ensemble_.cracking()) sample.velocity_m_s = speed(slot);
  return sample;
}

double Run::tip(const LaneSlot& slot) const {
  const int lane = index(slot);
  return tips_ ? tips_->tip(lane) : broken_[lane].leading().value_or(scene().crack.start);
}

double Run::speed(const LaneSlot& slot) {
  return tips_ ? tips_->speed(index(slot)) / plan(slot).units.time : 0.0;
}

void Run::note_gone(int lane, int k) {
  broken_[lane].add(middle_of(prepared_.lattice, ensemble_.damageable()[k].beam));
}

void Run::find_gone(const LaneSlot& slot) {
  const int lane = index(slot);
  broken_[lane] = fracture::BrokenBeams(near_radii * prepared_.lattice.mean_radius);
  for (int k = 0; k < static_cast<int>(ensemble_.damageable().size()); ++k)
    if (!ensemble_.damageable()[k].absent && ensemble_.factor(k, lane) == 0.0) note_gone(lane, k);
}

void Run::count_broken(LaneSlot& slot) {
  BrokenBeams& broken = lane_of(slot).broken;
  const fracture::BrokenBeams& gone = broken_[index(slot)];
  broken.gone = gone.count();
  broken.leading_m = gone.leading().value_or(-1.0);
  broken.softened = 0;
  for (int k = 0; k < static_cast<int>(ensemble_.damageable().size()); ++k) {
    const double left = ensemble_.factor(k, index(slot));
    broken.softened += left > 0.0 && left < 1.0;
  }
}

void Run::add_sample(LaneSlot& slot) {
  LaneResult& lane = lane_of(slot);
  const results::Sample now = sample(slot);
  lane.samples.push_back(now);
  if (observer_.sample) observer_.sample(now);
  const double residual = std::abs(now.residual);
  if (!(residual <= lane.worst_residual)) lane.worst_residual = residual;
  judge(slot, now);
}

void Run::read_gauges(const LaneSlot& slot) {
  if (!observer_.gauge) return;
  const int lane = index(slot);
  for (std::size_t g = 0; g < prepared_.gauge.size(); ++g) {
    const auto& [point, plane] = prepared_.gauge[g];
    const lattice::PlaneMotion moved = lattice::motion_in(
        plane, [&](int i) -> Eigen::Vector3d { return ensemble_.motion(i, lane).head<3>(); });
    const lattice::PlaneMotion rate = lattice::motion_in(
        plane, [&](int i) -> Eigen::Vector3d { return ensemble_.velocity(i, lane).head<3>(); });
    observer_.gauge({.step = steps(slot),
                     .time_s = ensemble_.time(lane),
                     .lane = slot.scenario,
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

void Run::report_released() {
  for (const ensemble::DamageIncrement& d : ensemble_.damage()) {
    if (d.after != 0.0 || slot_[d.lane].scenario < 0) continue;
    if (!tips_) {
      note_gone(d.lane, d.k);
      double& first = lane_of(slot_[d.lane]).broken.first_s;
      if (first < 0.0) first = ensemble_.time(d.lane);
    }
    if (!observer_.event) continue;
    const fracture::DamageableBeam& beam = ensemble_.damageable()[d.k];
    const lattice::Beam& form = prepared_.lattice.beam[beam.beam];
    const Eigen::Vector2d middle = middle_of(prepared_.lattice, beam.beam);
    const double energy = lattice::energy_of(form, d.strain);
    observer_.event(
        {.beam = beam.beam,
         .lane = slot_[d.lane].scenario,
         .time_s = ensemble_.time(d.lane),
         .position_m = beam.position,
         .energy_j = ensemble_.fracture_energy(d.k, d.lane),
         .x_m = middle.x(),
         .y_m = middle.y(),
         .tension = energy > 0.0 ? 0.5 * form.axial * d.strain.stretch * d.strain.stretch / energy : 0.0});
  }
}

void Run::watch() {
  for (LaneSlot& slot : slot_) {
    if (slot.scenario < 0 || lane_of(slot).outcome != Outcome::finished) continue;
    if (const results::Sample now = sample(slot); now.step != lane_of(slot).last_good_step) judge(slot, now);
    if (lane_of(slot).outcome == Outcome::diverged) add_sample(slot);  // the last row tells why
  }
}

void Run::judge(LaneSlot& slot, const results::Sample& now) {
  LaneResult& lane = lane_of(slot);
  const std::string wrong = what_is_wrong(scene().solver, lane, now);
  if (wrong.empty()) {
    lane.last_good_step = now.step;
    return;
  }
  lane.outcome = Outcome::diverged;
  lane.where = fmt::format("step {}{}: {}{}", now.step,
                           lane_.size() > 1 ? fmt::format(", lane {}", slot.scenario) : "", wrong,
                           where_it_diverges(prepared_.lattice, ensemble_, index(slot)));
}

const char* name_of(Outcome outcome) {
  constexpr std::array names{"finished", "stopped", "diverged"};
  return names[static_cast<std::size_t>(outcome)];
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
  const int most = most_side_by_side(p, side_by_side);
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
  return Run(prepared, observer, options).march(from);
}

}  // namespace rift::simulation
