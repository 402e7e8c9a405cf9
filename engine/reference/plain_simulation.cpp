#include "engine/reference/plain_simulation.hpp"

#include <algorithm>
#include <utility>

namespace rift::reference {

PlainSimulation::PlainSimulation(const lattice::Lattice& lattice_,
                                 std::vector<fracture::DamageableBeam> damageable_, double dt_,
                                 const fracture::LaneScenario& scenario_)
    : lattice(&lattice_), dt(dt_), scenario(scenario_), damageable(std::move(damageable_)) {
  std::vector<char> may_be_damaged(lattice->beam.size(), 0);
  for (const fracture::DamageableBeam& d : damageable) {
    may_be_damaged[d.beam] = 1;
    factor.push_back(d.absent ? 0.0 : 1.0);
  }
  for (int b = 0; b < static_cast<int>(lattice->beam.size()); ++b)
    if (!may_be_damaged[b]) intact_beam.push_back(b), intact.push_back(lattice::row_of(*lattice, b));
  fracture_energy.assign(factor.size(), 0.0);
  for (std::size_t i = 0; i < lattice->mass.size(); ++i)
    for (int c = 0; c < 6; ++c) {
      mass.push_back(c < 3 ? lattice->mass[i] : lattice->inertia[i]);
      per_mass.push_back((c < 3 ? lattice->is_gripped(i) : lattice->cannot_turn(i)) ? 0.0
                                                                                    : 1.0 / mass.back());
    }
  q.assign(mass.size(), 0.0);
  v = f = rate = q;
}

void PlainSimulation::start_from(const std::vector<lattice::Vector6>& displacement) {
  for (std::size_t k = 0; k < q.size(); ++k) q[k] = displacement[k / 6][static_cast<long>(k % 6)];
  std::fill(v.begin(), v.end(), 0.0);
  std::fill(f.begin(), f.end(), 0.0);
  balance_forces();
  balance = {};
  balance.start = evaluate_balance().total();
}

void PlainSimulation::start_crack(std::vector<lattice::DampedBeam> damped) {
  crack_start = steps_done;
  cracking = true;
  damping = lattice::ViscousDamping(std::move(damped));
  damping.alpha_at_surface = scenario.alpha_at_surface;
  damping.alpha_elsewhere = scenario.alpha_elsewhere;
}

/// Table 1 of the paper, with the release of beams between position and forces.
void PlainSimulation::step() {
  predict_damage();
  move();            // "Vector position computed from Eq. (1)"
  apply_damage();    // eqs. (9)-(11)
  balance_forces();  // "Balance of forces acting on i": eqs. (3)-(6), damping by eq. (8)
  accelerate();      // "Application of Newton's first law"; "Velocity vector computed from Eq. (2)"
  ++steps_done;      // "t <- t + dt"
}

/// The history of the tip is known ahead: which beams lose stiffness in this step, and their strains before
/// it.
void PlainSimulation::predict_damage() {
  damage_.clear();
  if (!cracking) return;
  const double a = history::tip_at(scenario.history, static_cast<double>(steps_done + 1 - crack_start) * dt);
  for (int k = 0; k < static_cast<int>(damageable.size()); ++k) {
    const double after =
        std::min(factor[k], fracture::stiffness_left(scenario.law, a, damageable[k].position));
    if (after != factor[k]) damage_.push_back({k, after, strain(k)});
  }
}

/// p(t + dt) = p + dt p' + dt^2/2 p''   [eq. (1)], and the first half of eq. (2).
void PlainSimulation::move() {
  if (grip_speed != 0.0) add_grip_work();
  for (std::size_t k = 0; k < q.size(); ++k) {
    const double kick = 0.5 * dt * f[k] * per_mass[k];
    rate[k] = v[k] + kick;
    q[k] += dt * rate[k];
    v[k] += beta * kick;
    f[k] = 0.0;
  }
}

/// Y1/Y2 of eqs. (9)-(11). A beam whose factor falls from s to s' loses (s - s') 1/2 q_n^T k q_{n+1}
/// [model.md §7].
void PlainSimulation::apply_damage() {
  for (const Damage& d : damage_) {
    fracture_energy[d.k] +=
        (factor[d.k] - d.after) *
        lattice::bilinear_energy(lattice->beam[damageable[d.k].beam], d.strain, strain(d.k));
    factor[d.k] = d.after;
  }
}

/// Forces and moments of all beams   [eqs. (3)-(6)], and of viscous damping   [eq. (8)].
void PlainSimulation::balance_forces() {
  lattice::add_beam_forces(intact, q.data(), f.data());
  for (std::size_t k = 0; k < damageable.size(); ++k) {
    const int beam = damageable[k].beam;
    const auto& [i, j] = lattice->ends[beam];
    const lattice::BeamLoads l = lattice::loads_of(lattice->beam[beam], motion(q, i), motion(q, j));
    for (long c = 0; c < 3; ++c) {
      f[6L * i + c] += factor[k] * l.force_i[c], f[6L * j + c] -= factor[k] * l.force_i[c];
      f[6L * i + 3 + c] += factor[k] * l.moment_i[c], f[6L * j + 3 + c] += factor[k] * l.moment_j[c];
    }
  }
  if (!damping.beam.empty())
    lattice::add_damping_forces(damping, rate.data(), factor.data(), dt, f.data(), viscous_work);
}

/// p'' = f / m, and the second half of p'(t + dt) = p' + beta dt/2 (p''(t) + p''(t + dt))   [eq. (2)]. What
/// beta < 1 takes is 1/2 M (v^2 at beta = 1 less v^2 at beta)   [model.md §7].
void PlainSimulation::accelerate() {
  for (std::size_t k = 0; k < v.size(); ++k) {
    const double kick = 0.5 * dt * f[k] * per_mass[k];
    v[k] += beta * kick;
    if (beta == 1.0 || per_mass[k] == 0.0) continue;
    const double undamped = rate[k] + kick;
    numerical_work += 0.5 * mass[k] * (undamped * undamped - v[k] * v[k]);
  }
  if (grip_speed != 0.0) add_grip_work();
}

void PlainSimulation::add_grip_work() {
  for (std::size_t i = 0; i < lattice->grip.size(); ++i)
    if (lattice->grip[i] == packing::Grip::top) grip_work -= 0.5 * grip_speed * dt * f[6 * i + 1];
}

void PlainSimulation::set_grip_speed(double speed) {
  grip_speed = speed;
  for (std::size_t i = 0; i < lattice->grip.size(); ++i)
    if (lattice->grip[i] == packing::Grip::top) v[6 * i + 1] = speed;
}

lattice::BeamStrain PlainSimulation::strain(int k) const {
  const auto& [i, j] = lattice->ends[damageable[k].beam];
  return lattice::strain_of(lattice->beam[damageable[k].beam], motion(q, i), motion(q, j));
}

const fracture::EnergyBalance& PlainSimulation::evaluate_balance() {
  fracture::EnergyBalance& b = balance;
  b.elastic = b.kinetic_translation = b.kinetic_rotation = b.step_correction = b.fracture = 0.0;
  for (const int beam : intact_beam) {
    const auto& [i, j] = lattice->ends[beam];
    b.elastic += lattice::energy_of(lattice->beam[beam],
                                    lattice::strain_of(lattice->beam[beam], motion(q, i), motion(q, j)));
  }
  for (int k = 0; k < static_cast<int>(damageable.size()); ++k) {
    b.elastic += factor[k] * lattice::energy_of(lattice->beam[damageable[k].beam], strain(k));
    b.fracture += fracture_energy[k];
  }
  for (std::size_t k = 0; k < v.size(); ++k) {
    if (per_mass[k] == 0.0) continue;
    (k % 6 < 3 ? b.kinetic_translation : b.kinetic_rotation) += 0.5 * mass[k] * v[k] * v[k];
    b.step_correction += 0.125 * dt * dt * f[k] * f[k] * per_mass[k];
  }
  b.damping = viscous_work;
  b.numerical_damping = numerical_work;
  b.work_external = grip_work;
  b.largest = std::max(b.largest, b.total());
  b.error = fracture::balance_error(b);
  return b;
}

}  // namespace rift::reference
