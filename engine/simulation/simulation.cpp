#include "engine/simulation/simulation.hpp"

#include <algorithm>

namespace rift {
template <int Lanes>
Simulation<Lanes>::Simulation(const Lattice& lattice_, const CrackPath& path, double notch_end, double dt_,
                              const std::array<LaneScenario, Lanes>& scenarios)
    : lattice(&lattice_), dt(dt_), scenario(scenarios), met(crossings(path, lattice_)) {
  std::vector<char> is_crossing(lattice->beam.size(), 0);
  for (const Crossing& c : met) {
    is_crossing[c.beam] = 1;
    crossing.push_back(row_of(*lattice, c.beam));
    factor.insert(factor.end(), Lanes, c.position <= notch_end ? 0.0 : 1.0);
  }
  for (int b = 0; b < static_cast<int>(lattice->beam.size()); ++b)
    if (!is_crossing[b]) sound_beam.push_back(b), sound.push_back(row_of(*lattice, b));
  booked.assign(factor.size(), 0.0);
  softening.reserve(factor.size());

  const std::size_t n = lattice->mass.size();
  for (std::size_t i = 0; i < n; ++i) {
    const bool free = lattice->grip[i] == Grip::none;
    per_mass.push_back(free ? 1.0 / lattice->mass[i] : 0.0);
    per_inertia.push_back(free ? 1.0 / lattice->inertia[i] : 0.0);
  }
  q.assign(6 * n * Lanes, 0.0);
  v = f = q;
}

template <int Lanes>
void Simulation<Lanes>::start_from(const std::vector<Vector6>& displacement) {
  for (std::size_t i = 0; i < displacement.size(); ++i)
    for (int c = 0; c < 6; ++c)
      for (int lane = 0; lane < Lanes; ++lane) q[at(static_cast<int>(i), c, lane)] = displacement[i][c];
  std::fill(v.begin(), v.end(), 0.0);
  std::fill(f.begin(), f.end(), 0.0);
  balance_forces();
  for (int lane = 0; lane < Lanes; ++lane) {
    ledger[lane] = Ledger{};
    ledger[lane].energy_start = energy(lane).total();
  }
}

template <int Lanes>
void Simulation<Lanes>::start_crack(std::vector<DampedBeam> damped) {
  crack_start = steps_done;
  cracking = true;
  damping = ViscousDamping<Lanes>(std::move(damped));
  for (int lane = 0; lane < Lanes; ++lane) {
    damping.alpha_at_surface[lane] = scenario[lane].alpha_at_surface;
    damping.alpha_elsewhere[lane] = scenario[lane].alpha_elsewhere;
  }
  if (!damping.beam.empty()) rate.assign(q.size(), 0.0);
}

template <int Lanes>
void Simulation<Lanes>::step() {
  foresee_softening();
  move();            // p(t+dt) = p + dt p' + dt^2/2 p''             eq. (1)
  soften();          // Y1/Y2 of the beams at the tip                eqs. (9)-(11)
  balance_forces();  // f(t+dt): beams and damping                   eqs. (3)-(6), (8)
  accelerate();      // p'(t+dt) = p' + beta dt/2 (p'' + p''(t+dt))  eq. (2)
  ++steps_done;
}

/// The crack's history is known ahead: which beams will soften in this step, and how they are strained before
/// it.
template <int Lanes>
void Simulation<Lanes>::foresee_softening() {
  softening.clear();
  if (!cracking) return;
  const int count = static_cast<int>(met.size());
  for (int lane = 0; lane < Lanes; ++lane) {
    const ReleaseLaw& law = scenario[lane].law;
    const double a = tip_at(scenario[lane].history, crack_time(steps_done + 1));
    int& first = first_standing[lane];
    while (first < count && factor[first * Lanes + lane] == 0.0) ++first;
    for (int k = first; k < count && met[k].position <= a + law.zone_length; ++k) {
      const double before = factor[k * Lanes + lane];
      const double after = std::min(before, stiffness_left(law, a, met[k].position));
      if (after == before) continue;
      softening.push_back({k, lane, before, after,
                           strain_of(lattice->beam[met[k].beam], motion(q, crossing[k].i, lane),
                                     motion(q, crossing[k].j, lane))});
    }
  }
}

template <int Lanes>
void Simulation<Lanes>::move() {
  const bool damped = !damping.beam.empty();
  if (beta != 1.0) v_before = v;
  if (grip_speed != 0.0) book_grip_work();
  for (std::size_t i = 0; i < per_mass.size(); ++i)
    for (int c = 0; c < 6; ++c)
      for (int lane = 0; lane < Lanes; ++lane) {
        const std::size_t k = at(static_cast<int>(i), c, lane);
        const double kick = 0.5 * dt * f[k] * (c < 3 ? per_mass[i] : per_inertia[i]);
        const double mean_speed = v[k] + kick;
        q[k] += dt * mean_speed;
        v[k] += beta * kick;
        f[k] = 0.0;
        if (damped) rate[k] = mean_speed;
      }
}

/// A factor that falls from s to s' takes (s - s') 1/2 q_before^T k q_after: with it the books close exactly.
template <int Lanes>
void Simulation<Lanes>::soften() {
  for (const Softening& c : softening) {
    const Beam& beam = lattice->beam[met[c.crossing].beam];
    const BeamStrain now =
        strain_of(beam, motion(q, crossing[c.crossing].i, c.lane), motion(q, crossing[c.crossing].j, c.lane));
    booked[c.crossing * Lanes + c.lane] += (c.before - c.after) * bilinear_energy(beam, c.strain, now);
    factor[c.crossing * Lanes + c.lane] = c.after;
  }
}

template <int Lanes>
void Simulation<Lanes>::balance_forces() {
  add_beam_forces<Lanes>(sound, q.data(), f.data());
  add_beam_forces<Lanes>(crossing, factor.data(), q.data(), f.data());
  if (!damping.beam.empty())
    add_damping_forces<Lanes>(damping, rate.data(), factor.data(), dt, f.data(), viscous_work);
}

template <int Lanes>
void Simulation<Lanes>::accelerate() {
  for (std::size_t i = 0; i < per_mass.size(); ++i)
    for (int c = 0; c < 6; ++c)
      for (int lane = 0; lane < Lanes; ++lane) {
        const std::size_t k = at(static_cast<int>(i), c, lane);
        v[k] += beta * 0.5 * dt * f[k] * (c < 3 ? per_mass[i] : per_inertia[i]);
      }
  if (grip_speed != 0.0) book_grip_work();
  if (beta == 1.0) return;
  // What beta < 1 takes is 1/2 M (v^2 at beta = 1 less v^2 at beta); v - v_before = beta (v at beta = 1 -
  // v_before).
  for (std::size_t i = 0; i < per_mass.size(); ++i) {
    if (lattice->grip[i] != Grip::none) continue;
    for (int c = 0; c < 6; ++c)
      for (int lane = 0; lane < Lanes; ++lane) {
        const std::size_t k = at(static_cast<int>(i), c, lane);
        const double undamped = v_before[k] + (v[k] - v_before[k]) / beta;
        numerical_work[lane] +=
            0.5 * (c < 3 ? lattice->mass[i] : lattice->inertia[i]) * (undamped * undamped - v[k] * v[k]);
      }
  }
}

/// Half of a step's work by the grip on the lattice, -1/2 F . dq on the top elements with F at one end of the
/// step.
template <int Lanes>
void Simulation<Lanes>::book_grip_work() {
  const double dq = grip_speed * dt;
  for (std::size_t i = 0; i < lattice->grip.size(); ++i)
    if (lattice->grip[i] == Grip::top)
      for (int lane = 0; lane < Lanes; ++lane)
        grip_work[lane] -= 0.5 * dq * f[at(static_cast<int>(i), 1, lane)];
}

/// Moves the top grip from the next step on; 0 holds it.
template <int Lanes>
void Simulation<Lanes>::set_grip_speed(double speed) {
  grip_speed = speed;
  for (std::size_t i = 0; i < lattice->grip.size(); ++i)
    if (lattice->grip[i] == Grip::top)
      for (int lane = 0; lane < Lanes; ++lane) v[at(static_cast<int>(i), 1, lane)] = speed;
}

template <int Lanes>
Vector6 Simulation<Lanes>::motion(const std::vector<double>& array, int element, int lane) const {
  Vector6 m;
  for (int c = 0; c < 6; ++c) m[c] = array[at(element, c, lane)];
  return m;
}

template <int Lanes>
LatticeEnergy Simulation<Lanes>::energy(int lane) const {
  LatticeEnergy e;
  const auto stored = [&](int b) {
    const auto& [i, j] = lattice->ends[b];
    return energy_of(lattice->beam[b], strain_of(lattice->beam[b], motion(q, i, lane), motion(q, j, lane)));
  };
  for (int b : sound_beam) e.elastic += stored(b);
  for (std::size_t k = 0; k < met.size(); ++k)
    if (const double left = factor[k * Lanes + lane]; left > 0.0) e.elastic += left * stored(met[k].beam);
  for (std::size_t i = 0; i < per_mass.size(); ++i) {
    if (per_mass[i] == 0.0) continue;
    const Vector6 speed = motion(v, static_cast<int>(i), lane), load = motion(f, static_cast<int>(i), lane);
    e.kinetic_translation += 0.5 * lattice->mass[i] * speed.head<3>().squaredNorm();
    e.kinetic_rotation += 0.5 * lattice->inertia[i] * speed.tail<3>().squaredNorm();
    e.step_correction +=
        0.125 * dt * dt *
        (load.head<3>().squaredNorm() * per_mass[i] + load.tail<3>().squaredNorm() * per_inertia[i]);
  }
  return e;
}

template <int Lanes>
results::Sample Simulation<Lanes>::sample(int lane, results::Phase phase) {
  Ledger& books = ledger[lane];
  books.fracture = 0.0;
  for (std::size_t k = 0; k < met.size(); ++k) books.fracture += booked[k * Lanes + lane];
  books.damping = viscous_work[lane];
  books.numerical_damping = numerical_work[lane];
  books.work_external = grip_work[lane];
  results::Sample s = balance(books, energy(lane));
  s.step = steps_done;
  s.time_s = static_cast<double>(steps_done) * dt;
  s.phase = phase;
  s.lane = lane;
  s.tip_m = cracking ? tip(lane) : scenario[lane].history.stretch.front().position;
  s.velocity_m_s = cracking ? speed_at(scenario[lane].history, crack_time(steps_done)) : 0.0;
  return s;
}

template struct Simulation<1>;
template struct Simulation<4>;

}  // namespace rift
