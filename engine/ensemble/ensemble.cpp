#include "engine/ensemble/ensemble.hpp"

#include "engine/fracture/face_contact.hpp"

#include <algorithm>
#include <utility>

namespace rift::ensemble {

namespace {

EnsembleOptions options_for(EnsembleOptions options, const std::vector<fracture::LaneScenario>& scenarios) {
  options.breaking = scenarios.front().material.has_value();
  return options;
}

}  // namespace

Ensemble::Ensemble(const lattice::Lattice& lattice, std::vector<fracture::DamageableBeam> damageable,
                   double dt, const std::vector<fracture::LaneScenario>& scenarios,
                   const EnsembleOptions& options, std::shared_ptr<ReleaseRule> rule)
    : dt_(dt),
      state_(lattice, std::move(damageable), static_cast<int>(scenarios.size()),
             options_for(options, scenarios)),
      rule_(std::move(rule)),
      balances_(state_.damageable().size(), state_.lanes(), static_cast<int>(scenarios.size())),
      units_(scenarios.size()),
      friction_(scenarios.size()),
      load_(scenarios.size()),
      first_step_(scenarios.size(), 0),
      velocity_(lattice.centre.size() * 6 * state_.lanes()) {
  damage_.reserve(state_.damageable().size() * state_.lanes());
  for (int lane = 0; lane < this->scenarios(); ++lane) steer(lane, scenarios[lane]);
}

void Ensemble::start_from(const std::vector<lattice::Vector6>& base) {
  state_.set_base(base);
  steps_done_ = 0;
  std::fill(first_step_.begin(), first_step_.end(), 0);
  open_balances(0, scenarios());
}

void Ensemble::release_from(const std::vector<lattice::Vector6>& moved) {
  start_from(std::vector<lattice::Vector6>(moved.size(), lattice::Vector6::Zero()));
  state_.set_motion(moved);
  // At rest now, so half a step ago it moved the other way.
  evaluate(velocity_.data());
  for (double& v : velocity_) v = -v;
  state_.set_velocities(velocity_);
  open_balances(0, scenarios());
}

void Ensemble::set_velocities(int lane, const std::vector<lattice::Vector6>& velocity) {
  state_.set_velocities(lane, velocity);
  open_balances(lane, lane + 1);
}

void Ensemble::start_crack(const std::vector<lattice::DampedBeam>& damped) {
  for (int lane = 0; lane < scenarios() && rule_; ++lane) rule_->start(lane, steps_done_);
  cracking_ = true;
  damp(damped);
}

void Ensemble::damp(const std::vector<lattice::DampedBeam>& damped) {
  if (damped.empty()) return;
  balances_.collect(state_);
  state_.set_damped(damped);
  forget_evaluation();
}

void Ensemble::steer(int lane, const fracture::LaneScenario& scenario) {
  state_.set_lane(lane, scenario);
  friction_[lane] = scenario.friction;
  load_[lane] = scenario.load;
  if (rule_) rule_->set_lane(lane, scenario);
}

void Ensemble::refill(int lane, const fracture::LaneScenario& scenario) {
  steer(lane, scenario);
  if (rule_) rule_->start(lane, steps_done_);
  state_.put_to_rest(lane);
  first_step_[lane] = steps_done_;
  open_balances(lane, lane + 1);
}

/// The elements' forces, accelerations, velocities and positions, and the energies that the step takes, are
/// the kernels'.
void Ensemble::step() {
  predict_damage();
  state_.advance(constants());  // eqs. (1)-(6), (8)
  balances_.add_grip_work(-(0.5 * (grip_before_ + grip_after_) * dt_ * state_.base_pull()));
  follow_damage();
  apply_damage();  // eqs. (9)-(11)
  beta_before_ = beta_after_;
  grip_before_ = grip_after_;
  ++steps_done_;
  for (int lane = 0; lane < scenarios(); ++lane) {
    const double before = follow_load(lane), now = state_.load(lane);
    if (before != 0.0 || now != 0.0)
      balances_.add_outside_work(lane, 0.5 * (before + now) * state_.work_of_unit_load(lane, dt_));
  }
}

double Ensemble::follow_load(int lane) {
  const double before = state_.load(lane);
  state_.set_load(lane, lattice::load_at(load_[lane], static_cast<double>(steps_done(lane)) * dt_));
  return before;
}

void Ensemble::follow_damage() {
  if (cracking_ && rule_) rule_->follow_damage(state_, damage_);
}

void Ensemble::predict_damage() {
  damage_.clear();
  if (!cracking_ || !rule_) return;
  rule_->predict_damage(state_, steps_done_, damage_);
  for (DamageIncrement& d : damage_) {
    d.strain = state_.strain(damageable()[d.k].beam, d.lane);
    if (friction_[d.lane]) d.gap = gap(d.k, d.lane);
  }
}

/// A factor that falls from s to s' takes (s - s') 1/2 q_before^T k q_after: with it the energy balance is
/// exact. What of it the faces go on holding is theirs.
void Ensemble::apply_damage() {
  for (const DamageIncrement& d : damage_) {
    const fracture::DamageableBeam& damaged = damageable()[d.k];
    const lattice::Beam& beam = lattice().beam[damaged.beam];
    double taken = lattice::bilinear_energy(beam, d.strain, state_.strain(damaged.beam, d.lane)),
           to_faces = 0.0;
    if (const auto& friction = friction_[d.lane]) {
      const Eigen::Vector3d m(damaged.normal.x(), damaged.normal.y(), 0.0), slipped = slip(d.k, d.lane);
      to_faces = fracture::bilinear_energy(fracture::face_stiffness(beam),
                                           fracture::face_contact(d.gap, m, slipped, *friction),
                                           fracture::face_contact(gap(d.k, d.lane), m, slipped, *friction));
      taken -= to_faces;
    }
    balances_.add_fracture(d.k, d.lane, (d.before - d.after) * taken, (d.before - d.after) * to_faces);
    state_.set_factor(d.k, d.lane, d.after);
  }
}

void Ensemble::evaluate(double* velocities) {
  state_.evaluate_energies(constants(), velocities);
  balances_.read(state_, -(0.5 * grip_before_ * dt_ * state_.base_pull()));
  evaluated_at_ = steps_done_;
  if (velocities) velocities_at_ = steps_done_;
}

/// Of the lanes [first, last), whose state has just been set.
void Ensemble::open_balances(int first, int last) {
  forget_evaluation();
  for (int lane = first; lane < last; ++lane) follow_load(lane);
  for (int lane = first; lane < last; ++lane) balances_.clear(lane);
  evaluate(nullptr);
  for (int lane = first; lane < last; ++lane) balances_.open(lane);
}

void Ensemble::set_grip_speed(double speed) {
  grip_after_ = speed;
  velocities_at_ = -1;
  state_.set_top_velocity(speed);
}

void Ensemble::set_beta(double beta) {
  beta_after_ = beta;
  if (beta != 1.0) state_.keep_rates();
}

fracture::EnergyBalance Ensemble::balance(int lane) {
  if (evaluated_at_ != steps_done_) evaluate(nullptr);
  fracture::EnergyBalance b = balances_.of(lane);
  for (double fracture::EnergyBalance::*term :
       {&fracture::EnergyBalance::elastic, &fracture::EnergyBalance::kinetic_translation,
        &fracture::EnergyBalance::kinetic_rotation, &fracture::EnergyBalance::step_correction,
        &fracture::EnergyBalance::start, &fracture::EnergyBalance::fracture,
        &fracture::EnergyBalance::damping, &fracture::EnergyBalance::numerical_damping,
        &fracture::EnergyBalance::contact, &fracture::EnergyBalance::work_external,
        &fracture::EnergyBalance::largest})
    b.*term *= units_[lane].energy;
  return b;
}

std::vector<double> Ensemble::elastic_by_element(int lane) const {
  std::vector<double> left(lattice().beam.size(), 1.0), energy(lattice().centre.size(), 0.0);
  for (int k = 0; k < static_cast<int>(damageable().size()); ++k)
    left[damageable()[k].beam] = factor(k, lane);
  for (int b = 0; b < static_cast<int>(left.size()); ++b) {
    if (left[b] == 0.0) continue;
    const double half = 0.5 * left[b] * beam_energy(b, lane) * units_[lane].energy;
    for (const int i : lattice().ends[b]) energy[i] += half;
  }
  return energy;
}

lattice::Vector6 Ensemble::velocity(int element, int lane) {
  if (velocities_at_ != steps_done_) evaluate(velocity_.data());
  lattice::Vector6 v;
  for (int c = 0; c < 6; ++c) v[c] = velocity_[(static_cast<std::size_t>(element) * 6 + c) * lanes() + lane];
  return v / units_[lane].time;
}

NamedNumbers Ensemble::state() const {
  NamedNumbers state;
  state["clock"] = {static_cast<double>(steps_done_),
                    cracking_ ? 1.0 : 0.0,
                    beta_before_,
                    beta_after_,
                    grip_before_,
                    grip_after_,
                    state_.base_pull()};
  put(state, "born", first_step_, first_step_.size());
  if (rule_) rule_->save(state);
  state_.save(state);
  balances_.save(state);
  return state;
}

void Ensemble::restore(const NamedNumbers& state) {
  const std::vector<double>& clock = numbers_of(state, "clock", 7);
  steps_done_ = whole<std::int64_t>(clock[0], "clock");
  cracking_ = clock[1] != 0.0;
  set_beta(clock[3]);  // makes room for the rates where it damps
  beta_before_ = clock[2];
  grip_before_ = clock[4], grip_after_ = clock[5];
  take(state, "born", first_step_);
  if (rule_) rule_->restore(state_, state);
  state_.restore(state);
  balances_.restore(state);
  for (int lane = 0; lane < scenarios(); ++lane) follow_load(lane);
  forget_evaluation();
}

}  // namespace rift::ensemble
