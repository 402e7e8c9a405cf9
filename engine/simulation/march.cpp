#include "engine/simulation/march.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace rift {
namespace {

using Clock = std::chrono::steady_clock;
using results::Phase;

constexpr double hopeless_residual = 1e-6;
constexpr double largest_residual_inertia = 0.01;  // of the ramp: kinetic over total energy   [physics.md §4]
constexpr auto between_questions = std::chrono::milliseconds(100);

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The run as it goes: what the loop below needs beside the simulation.
struct Run {
  const Prepared& prepared;
  const Observer& observer;
  Simulation<1> simulation;
  RunResult result;
  std::size_t next_sample = 0, next_frame = 0;
  Clock::time_point started = Clock::now(), asked = started;

  Phase phase() const {
    const std::int64_t n = simulation.steps_done;
    const Schedule& s = prepared.schedule;
    return n < s.ramp ? Phase::loading : n < s.crack_start() ? Phase::hold : Phase::fracture;
  }
};

std::array<float, 3> narrow(const Vector6& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

results::Frame frame_of(const Run& run) {
  const Simulation<1>& s = run.simulation;
  results::Frame frame;
  frame.step = s.steps_done;
  frame.time_s = static_cast<double>(s.steps_done) * s.dt;
  frame.tip_m = s.cracking ? s.tip(0) : s.scenario[0].history.stretch.front().position;
  const int n = static_cast<int>(run.prepared.lattice.centre.size());
  for (const std::string& field : run.prepared.preset.scene.output.fields) {
    if (field == "displacement")
      for (int i = 0; i < n; ++i) frame.displacement.push_back(narrow(s.motion(s.q, i, 0)));
    if (field == "velocity")
      for (int i = 0; i < n; ++i) frame.velocity.push_back(narrow(s.motion(s.v, i, 0)));
    if (field == "damage") {
      std::vector<std::pair<int, float>> by_beam;
      for (std::size_t k = 0; k < s.met.size(); ++k)
        by_beam.emplace_back(s.met[k].beam, static_cast<float>(s.factor[k]));
      std::sort(by_beam.begin(), by_beam.end());
      for (const auto& [beam, factor] : by_beam) frame.damage_factor.push_back(factor);
    }
  }
  return frame;
}

/// The first element whose motion is no number any more, for the message.
std::string first_lost_element(const Simulation<1>& s) {
  for (std::size_t k = 0; k < s.q.size(); ++k)
    if (!std::isfinite(s.q[k]) || !std::isfinite(s.v[k])) return fmt::format(", first at element {}", k / 6);
  return "";
}

void read_books(Run& run) {
  const results::Sample row = run.simulation.sample(0, run.phase());
  run.result.books.push_back(row);
  if (run.observer.sample) run.observer.sample(row);
  const double residual = std::abs(row.residual);
  if (!(residual <= run.result.worst_residual)) run.result.worst_residual = residual;
  if (residual <= hopeless_residual) return;
  run.result.outcome = Outcome::diverged;
  run.result.where = fmt::format("step {}: the books are open by {:.3g} of the energy{}", row.step,
                                 row.residual, first_lost_element(run.simulation));
}

void observe(Run& run) {
  const Schedule& schedule = run.prepared.schedule;
  const std::int64_t n = run.simulation.steps_done;
  if (run.next_sample < schedule.samples.size() && n == schedule.samples[run.next_sample]) {
    ++run.next_sample;
    read_books(run);
  }
  if (run.next_frame < schedule.frames.size() && n == schedule.frames[run.next_frame]) {
    ++run.next_frame;
    if (run.observer.frame) run.observer.frame(frame_of(run));
  }
  if (!run.observer.go_on || Clock::now() - run.asked < between_questions) return;
  run.asked = Clock::now();
  if (run.observer.go_on({run.phase(), n, schedule.total(), seconds_since(run.started)})) return;
  run.result.outcome = Outcome::stopped;
  run.result.where = fmt::format("step {} of {}", n, schedule.total());
}

void report_released(const Run& run) {
  if (!run.observer.event) return;
  const Simulation<1>& s = run.simulation;
  for (const Softening& c : s.softening)
    if (c.after == 0.0)
      run.observer.event({.beam = s.met[c.crossing].beam,
                          .lane = c.lane,
                          .time_s = static_cast<double>(s.steps_done) * s.dt,
                          .position_m = s.met[c.crossing].position,
                          .energy_j = s.booked[c.crossing]});
}

void steps_until(Run& run, std::int64_t last) {
  while (run.simulation.steps_done < last && run.result.outcome == Outcome::finished) {
    run.simulation.step();
    report_released(run);
    observe(run);
  }
}

/// The paper's way to pre-stress: pull, hold, both with numerical damping that is taken out afterwards.
void pull(Run& run) {
  const Scene::Loading& loading = run.prepared.preset.scene.loading;
  const Schedule& schedule = run.prepared.schedule;
  run.simulation.beta = loading.ramp_beta;
  run.simulation.set_grip_speed(loading.displacement /
                                (static_cast<double>(schedule.ramp) * run.simulation.dt));
  steps_until(run, schedule.ramp);
  run.simulation.set_grip_speed(0.0);
  steps_until(run, schedule.crack_start());
  const LatticeEnergy e = run.simulation.energy(0);
  run.result.prestress_kinetic = (e.kinetic_translation + e.kinetic_rotation) / e.total();
  run.result.wall_prestress_s = seconds_since(run.started);
  if (run.result.outcome == Outcome::finished && run.result.prestress_kinetic > largest_residual_inertia) {
    run.result.outcome = Outcome::diverged;
    run.result.where = fmt::format(
        "after the ramp {:.2g} of the energy is kinetic (limit {:g}): not quasi-static; "
        "raise loading.ramp_steps or loading.hold_steps",
        run.result.prestress_kinetic, largest_residual_inertia);
  }
}

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

RunResult march(const Prepared& prepared, const Observer& observer) {
  const Scene& scene = prepared.preset.scene;
  Run run{.prepared = prepared,
          .observer = observer,
          .simulation = Simulation<1>(prepared.lattice, prepared.path, scene.crack.start, prepared.step.dt,
                                      {prepared.scenario}),
          .result = {}};
  run.simulation.start_from(prepared.displacement);
  if (prepared.schedule.ramp > 0) {
    observe(run);
    pull(run);
  }
  if (run.result.outcome == Outcome::finished) {
    const auto crack_started = Clock::now();
    run.simulation.beta = scene.solver.beta;
    run.simulation.start_crack(prepared.damped);
    run.result.energy_at_crack_start = run.simulation.energy(0).elastic;
    if (prepared.schedule.ramp == 0) observe(run);
    steps_until(run, prepared.schedule.total());
    run.result.wall_fracture_s = seconds_since(crack_started);
  }
  run.result.steps = run.simulation.steps_done;
  return run.result;
}

}  // namespace rift
