#include "tests/engine/ensemble/plain_simulation.hpp"

#include <algorithm>

namespace rift::ensemble {

PlainSimulation::PlainSimulation(const lattice::Lattice& lattice_, const fracture::CrackPath& path,
                                 double notch_end, double dt_, const fracture::LaneScenario& scenario_)
    : lattice(&lattice_), dt(dt_), scenario(scenario_), met(fracture::crossings(path, lattice_)) {
  std::vector<char> is_crossing(lattice->beam.size(), 0);
  for (const fracture::Crossing& c : met) {
    is_crossing[c.beam] = 1;
    factor.push_back(c.position <= notch_end ? 0.0 : 1.0);
  }
  for (int b = 0; b < static_cast<int>(lattice->beam.size()); ++b)
    if (!is_crossing[b]) sound_beam.push_back(b), sound.push_back(lattice::row_of(*lattice, b));
  booked.assign(factor.size(), 0.0);
  for (std::size_t i = 0; i < lattice->mass.size(); ++i)
    for (int c = 0; c < 6; ++c) {
      mass.push_back(c < 3 ? lattice->mass[i] : lattice->inertia[i]);
      per_mass.push_back(lattice->grip[i] == packing::Grip::none ? 1.0 / mass.back() : 0.0);
    }
  q.assign(mass.size(), 0.0);
  v = f = rate = q;
}

void PlainSimulation::start_from(const std::vector<lattice::Vector6>& displacement) {
  for (std::size_t k = 0; k < q.size(); ++k) q[k] = displacement[k / 6][static_cast<long>(k % 6)];
  std::fill(v.begin(), v.end(), 0.0);
  std::fill(f.begin(), f.end(), 0.0);
  balance_forces();
  ledger = fracture::Ledger{};
  ledger.energy_start = energy().total();
}

void PlainSimulation::start_crack(std::vector<lattice::DampedBeam> damped) {
  crack_start = steps_done;
  cracking = true;
  damping = lattice::ViscousDamping(std::move(damped));
  damping.alpha_at_surface = scenario.alpha_at_surface;
  damping.alpha_elsewhere = scenario.alpha_elsewhere;
}

void PlainSimulation::step() {
  foresee_softening();
  move();
  soften();
  balance_forces();
  accelerate();
  ++steps_done;
}

void PlainSimulation::foresee_softening() {
  softening.clear();
  if (!cracking) return;
  const double a = history::tip_at(scenario.history, crack_time(steps_done + 1));
  for (int k = 0; k < static_cast<int>(met.size()); ++k) {
    const double after = std::min(factor[k], fracture::stiffness_left(scenario.law, a, met[k].position));
    if (after != factor[k]) softening.push_back({k, 0, factor[k], after, strain(k)});
  }
}

void PlainSimulation::move() {
  if (grip_speed != 0.0) book_grip_work();
  v_before = v;
  for (std::size_t k = 0; k < q.size(); ++k) {
    const double kick = 0.5 * dt * f[k] * per_mass[k];
    rate[k] = v[k] + kick;
    q[k] += dt * rate[k];
    v[k] += beta * kick;
    f[k] = 0.0;
  }
}

void PlainSimulation::soften() {
  for (const Softening& c : softening) {
    booked[c.crossing] += (c.before - c.after) * lattice::bilinear_energy(lattice->beam[met[c.crossing].beam],
                                                                          c.strain, strain(c.crossing));
    factor[c.crossing] = c.after;
  }
}

void PlainSimulation::balance_forces() {
  lattice::add_beam_forces(sound, q.data(), f.data());
  for (std::size_t k = 0; k < met.size(); ++k) {
    const auto& [i, j] = lattice->ends[met[k].beam];
    const lattice::BeamLoads l = lattice::loads_of(lattice->beam[met[k].beam], motion(q, i), motion(q, j));
    for (long c = 0; c < 3; ++c) {
      f[6L * i + c] += factor[k] * l.force_i[c], f[6L * j + c] -= factor[k] * l.force_i[c];
      f[6L * i + 3 + c] += factor[k] * l.moment_i[c], f[6L * j + 3 + c] += factor[k] * l.moment_j[c];
    }
  }
  if (!damping.beam.empty())
    lattice::add_damping_forces(damping, rate.data(), factor.data(), dt, f.data(), viscous_work);
}

/// What beta < 1 takes is 1/2 M (v^2 at beta = 1 less v^2 at beta); v - v_before = beta (v at beta = 1 -
/// v_before).
void PlainSimulation::accelerate() {
  for (std::size_t k = 0; k < v.size(); ++k) v[k] += beta * 0.5 * dt * f[k] * per_mass[k];
  if (grip_speed != 0.0) book_grip_work();
  for (std::size_t k = 0; beta != 1.0 && k < v.size(); ++k) {
    if (per_mass[k] == 0.0) continue;
    const double undamped = v_before[k] + (v[k] - v_before[k]) / beta;
    numerical_work += 0.5 * mass[k] * (undamped * undamped - v[k] * v[k]);
  }
}

void PlainSimulation::book_grip_work() {
  for (std::size_t i = 0; i < lattice->grip.size(); ++i)
    if (lattice->grip[i] == packing::Grip::top) grip_work -= 0.5 * grip_speed * dt * f[6 * i + 1];
}

void PlainSimulation::set_grip_speed(double speed) {
  grip_speed = speed;
  for (std::size_t i = 0; i < lattice->grip.size(); ++i)
    if (lattice->grip[i] == packing::Grip::top) v[6 * i + 1] = speed;
}

lattice::BeamStrain PlainSimulation::strain(int k) const {
  const auto& [i, j] = lattice->ends[met[k].beam];
  return lattice::strain_of(lattice->beam[met[k].beam], motion(q, i), motion(q, j));
}

fracture::LatticeEnergy PlainSimulation::energy() const {
  fracture::LatticeEnergy e;
  for (int b : sound_beam) {
    const auto& [i, j] = lattice->ends[b];
    e.elastic += lattice::energy_of(lattice->beam[b],
                                    lattice::strain_of(lattice->beam[b], motion(q, i), motion(q, j)));
  }
  for (int k = 0; k < static_cast<int>(met.size()); ++k)
    e.elastic += factor[k] * lattice::energy_of(lattice->beam[met[k].beam], strain(k));
  for (std::size_t k = 0; k < v.size(); ++k) {
    if (per_mass[k] == 0.0) continue;
    (k % 6 < 3 ? e.kinetic_translation : e.kinetic_rotation) += 0.5 * mass[k] * v[k] * v[k];
    e.step_correction += 0.125 * dt * dt * f[k] * f[k] * per_mass[k];
  }
  return e;
}

results::Sample PlainSimulation::sample() {
  ledger.fracture = 0.0;
  for (double b : booked) ledger.fracture += b;
  ledger.damping = viscous_work;
  ledger.numerical_damping = numerical_work;
  ledger.work_external = grip_work;
  return fracture::balance(ledger, energy());
}

}  // namespace rift::ensemble
