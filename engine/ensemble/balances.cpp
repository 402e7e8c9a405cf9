#include "engine/ensemble/balances.hpp"

#include <algorithm>

namespace rift::ensemble {

Balances::Balances(std::size_t damageable, int lanes, int scenarios)
    : lanes_(lanes), lane_(scenarios), fracture_energy_(damageable * lanes, 0.0) {}

void Balances::clear(int lane) {
  lane_[lane] = {};
  for (std::size_t k = lane; k < fracture_energy_.size(); k += lanes_) fracture_energy_[k] = 0.0;
}

void Balances::open(int lane) { lane_[lane].balance.start = lane_[lane].balance.total(); }

void Balances::collect(const State& state) {
  for (int lane = 0; lane < static_cast<int>(lane_.size()); ++lane) {
    Dissipated& d = lane_[lane].so_far;
    d = {state.add_account(spent_damping, lane, d.damping),
         state.add_account(spent_numerical, lane, d.numerical),
         state.add_account(spent_contact, lane, d.contact), state.add_account(spent_grip, lane, d.grip)};
  }
}

void Balances::read(const State& state, double grip_work) {
  for (int k = 0; k < static_cast<int>(lane_.size()); ++k) {
    Lane& lane = lane_[k];
    const auto sum = [&](Account account) { return state.add_account(account, k); };
    lane.contact_energy = sum(contact_elastic);
    lane.balance.elastic = state.base_energy(k) + sum(elastic) + lane.contact_energy;
    lane.balance.kinetic_translation = sum(kinetic_translation);
    lane.balance.kinetic_rotation = sum(kinetic_rotation);
    lane.balance.step_correction = sum(step_correction);
    lane.pending = {sum(pending_damping) + sum(spent_damping), sum(pending_numerical) + sum(spent_numerical),
                    sum(pending_contact) + sum(spent_contact),
                    sum(pending_grip) + sum(spent_grip) + grip_work};
  }
}

void Balances::add_grip_work(double work) {
  for (Lane& lane : lane_) lane.so_far.grip += work;
}

void Balances::add_fracture(int k, int lane, double energy, double to_faces) {
  fracture_energy_[static_cast<std::size_t>(k) * lanes_ + lane] += energy;
  lane_[lane].contact_energy_from_damage += to_faces;
}

const fracture::EnergyBalance& Balances::of(int lane) {
  const Lane& l = lane_[lane];
  fracture::EnergyBalance& b = lane_[lane].balance;
  b.fracture = 0.0;
  for (std::size_t k = lane; k < fracture_energy_.size(); k += lanes_) b.fracture += fracture_energy_[k];
  b.damping = l.so_far.damping + l.pending.damping;
  b.numerical_damping = l.so_far.numerical + l.pending.numerical;
  b.contact = l.so_far.contact + l.pending.contact + l.contact_energy_from_damage - l.contact_energy;
  b.work_external = l.so_far.grip + l.pending.grip;
  b.largest = std::max(b.largest, b.total());
  b.error = fracture::balance_error(b);
  return b;
}

void Balances::save(NamedNumbers& state) const {
  put(state, "booked", fracture_energy_, fracture_energy_.size());
  for (const Lane& lane : lane_) {
    const fracture::EnergyBalance& b = lane.balance;
    const Dissipated& d = lane.so_far;
    for (const double x :
         {b.start, b.fracture, b.damping, b.numerical_damping, b.contact, b.work_external, b.largest,
          d.damping, d.numerical, d.contact, d.grip, lane.contact_energy_from_damage})
      state["ledger"].push_back(x);
  }
}

void Balances::restore(const NamedNumbers& state) {
  take(state, "booked", fracture_energy_);
  const std::vector<double>& numbers = numbers_of(state, "ledger", 12 * lane_.size());
  for (std::size_t k = 0; k < lane_.size(); ++k) {
    const double* x = &numbers[12 * k];
    fracture::EnergyBalance& b = lane_[k].balance;
    b.start = x[0], b.fracture = x[1], b.damping = x[2], b.numerical_damping = x[3], b.contact = x[4];
    b.work_external = x[5], b.largest = x[6];
    lane_[k].so_far = {x[7], x[8], x[9], x[10]};
    lane_[k].contact_energy_from_damage = x[11];
  }
}

}  // namespace rift::ensemble
