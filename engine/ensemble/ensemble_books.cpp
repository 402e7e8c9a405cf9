#include "engine/ensemble/ensemble.hpp"

#include <utility>

/// What the ensemble's steps have cost, and what it holds now.
namespace rift::ensemble {

/// The beams there, and their pull in the base state, in which the notch's are absent; the corotational loads
/// hold it already.
template <class Real>
void Ensemble<Real>::find_beams_at_top() {
  at_top_.clear();
  base_pull_ = 0.0;
  std::vector<int> crossing(lattice_->beam.size(), -1);
  for (std::size_t k = 0; k < met_.size(); ++k) crossing[met_[k].beam] = static_cast<int>(k);
  for (std::size_t b = 0; b < crossing.size(); ++b) {
    const auto& [i, j] = lattice_->ends[b];
    if ((crossing[b] >= 0 && notched_[crossing[b]]) || top_[i] == top_[j]) continue;
    at_top_.push_back({static_cast<int>(b), crossing[b]});
    if (marching_.kinematics == lattice::Kinematics::corotational) continue;
    const lattice::BeamLoads loads = lattice::loads_of(lattice_->beam[b], base_[i], base_[j]);
    base_pull_ += top_[i] ? loads.force_i.y() : -loads.force_i.y();
  }
}

/// The books of the steps done, out of the parts' accounts.
template <class Real>
void Ensemble<Real>::add_up_spent() {
  for (PartRows<Real>& rows : part_)
    for (std::size_t chunk = 0; chunk < rows.account.size();
         chunk += static_cast<std::size_t>(accounts) * lanes_)
      for (int lane = 0; lane < lanes_; ++lane) {
        const auto take = [&](Account which) {
          return std::exchange(rows.account[chunk + which * lanes_ + lane], 0.0);
        };
        const Spent part{take(spent_damping), take(spent_numerical), take(spent_contact), take(spent_grip)};
        if (lane >= scenarios()) continue;
        spent_[lane].damping += part.damping;
        spent_[lane].numerical += part.numerical;
        spent_[lane].contact += part.contact;
        spent_[lane].grip += part.grip;
      }
}

template <class Real>
void Ensemble<Real>::weigh(double* velocities) {
  copy_ghosts();
  const StepConstants k = constants();
  crew_->run(threads(), [&](int p) {
    PartView<Real> view = part_[p].view;
    view.speed = velocities;
    view.slip_after = nullptr;
    kernel_.weigh(view, k);
  });
  for (int lane = 0; lane < scenarios(); ++lane) {
    double sum[accounts] = {};
    for (const PartRows<Real>& rows : part_)
      for (std::size_t chunk = 0; chunk < rows.account.size();
           chunk += static_cast<std::size_t>(accounts) * lanes_)
        for (int a = 0; a < accounts; ++a) sum[a] += rows.account[chunk + a * lanes_ + lane];
    held_[lane] = sum[contact_elastic];
    energy_[lane] = {sum[elastic] + held_[lane], sum[kinetic_translation], sum[kinetic_rotation],
                     sum[step_correction]};
    pending_[lane] = {sum[pending_damping] + sum[spent_damping],
                      sum[pending_numerical] + sum[spent_numerical],
                      sum[pending_contact] + sum[spent_contact],
                      sum[pending_grip] + sum[spent_grip] - 0.5 * grip_before_ * dt_ * base_pull_};
  }
  weighed_at_ = steps_done_;
  if (velocities) velocities_at_ = steps_done_;
}

template <class Real>
fracture::LatticeEnergy Ensemble<Real>::energy(int lane) {
  if (weighed_at_ != steps_done_) weigh(nullptr);
  return energy_[lane];
}

template <class Real>
double Ensemble<Real>::grip_force(int lane) const {
  double force = 0.0;
  for (const auto& [b, crossing] : at_top_) {
    const auto& [i, j] = lattice_->ends[b];
    const lattice::Beam& beam = lattice_->beam[b];
    const lattice::BeamLoads loads = marching_.kinematics == lattice::Kinematics::linear
                                         ? lattice::loads_of(beam, motion(i, lane), motion(j, lane))
                                         : lattice::loads_of(beam, pose(i, lane), pose(j, lane));
    const double left = crossing < 0 ? 1.0 : factor(crossing, lane);
    force -= left * (top_[i] ? loads.force_i.y() : -loads.force_i.y());
  }
  return force;
}

template <class Real>
results::Sample Ensemble<Real>::sample(int lane, results::Phase phase) {
  const fracture::LatticeEnergy now = energy(lane);
  fracture::Ledger& books = ledger_[lane];
  books.fracture = 0.0;
  for (int c = 0; c < static_cast<int>(met_.size()); ++c) books.fracture += booked(c, lane);
  books.damping = spent_[lane].damping + pending_[lane].damping;
  books.numerical_damping = spent_[lane].numerical + pending_[lane].numerical;
  books.contact = spent_[lane].contact + pending_[lane].contact + inherited_[lane] - held_[lane];
  books.work_external = spent_[lane].grip + pending_[lane].grip;
  results::Sample s = fracture::balance(books, now);
  s.step = steps_done(lane);
  s.time_s = time(lane);
  s.phase = phase;
  s.lane = lane;
  s.grip_force_n = grip_force(lane);
  const history::CrackHistory& history = scenario_[lane].history;
  s.tip_m = cracking_ ? tip(lane) : history.stretch.front().position;
  s.velocity_m_s = cracking_ ? history::speed_at(history, crack_time(lane, steps_done_)) : 0.0;
  return s;
}

template void Ensemble<double>::find_beams_at_top();
template void Ensemble<double>::add_up_spent();
template void Ensemble<double>::weigh(double*);
template fracture::LatticeEnergy Ensemble<double>::energy(int);
template double Ensemble<double>::grip_force(int) const;
template results::Sample Ensemble<double>::sample(int, results::Phase);
template void Ensemble<float>::find_beams_at_top();
template void Ensemble<float>::add_up_spent();
template void Ensemble<float>::weigh(double*);
template fracture::LatticeEnergy Ensemble<float>::energy(int);
template double Ensemble<float>::grip_force(int) const;
template results::Sample Ensemble<float>::sample(int, results::Phase);

}  // namespace rift::ensemble
