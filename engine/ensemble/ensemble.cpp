#include "engine/ensemble/ensemble.hpp"

#include "engine/fracture/crack_path.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace rift::ensemble {

template <class Real>
Ensemble<Real>::Ensemble(const lattice::Lattice& lattice, const fracture::CrackPath& path, double notch_end,
                         double dt, std::vector<fracture::LaneScenario> scenarios, const Marching& marching)
    : lattice_(&lattice),
      dt_(dt),
      marching_(marching),
      lanes_(marching.lanes ? marching.lanes : lanes_for<Real>(static_cast<int>(scenarios.size()))),
      numbers_(marching.kinematics == lattice::Kinematics::linear ? 6 : 7),
      kernel_(kernel_for<Real>(marching.instructions, marching.kinematics, lanes_)),
      scenario_(std::move(scenarios)),
      met_(fracture::crossings(path, lattice)),
      base_(lattice.centre.size(), lattice::Vector6::Zero()),
      cut_(cut_evenly(lattice, marching.threads)),
      born_(scenario_.size(), 0),
      crack_start_(scenario_.size(), 0),
      first_standing_(scenario_.size(), 0),
      ledger_(scenario_.size()),
      energy_(scenario_.size()),
      spent_(scenario_.size()),
      pending_(scenario_.size()),
      held_(scenario_.size(), 0.0),
      inherited_(scenario_.size(), 0.0) {
  assert(!scenario_.empty() && static_cast<int>(scenario_.size()) <= lanes_);
  for (const fracture::Crossing& c : met_) notched_.push_back(fracture::in_notch(c, notch_end));
  booked_.assign(met_.size() * lanes_, 0.0);
  factor_.resize(booked_.size());
  softening_.reserve(booked_.size());
  if (marching_.contact) slip_.resize(3 * booked_.size()), slip_after_ = slip_;
  for (const fracture::Crossing& c : met_) {
    if (!marching_.contact) break;
    const auto& [i, j] = lattice.ends[c.beam];
    normal_.push_back(
        fracture::normal_between(path, lattice.centre[i].head<2>(), lattice.centre[j].head<2>()));
  }
  crew_ = std::make_unique<base::ThreadPool>(static_cast<int>(cut_.size()) - 1,
                                             static_cast<int>(cut_.size()) - 1);
  for (std::size_t i = 0; i < lattice.mass.size(); ++i) {
    const bool free = lattice.grip[i] == packing::Grip::none;
    mass_.insert(mass_.end(), {lattice.mass[i], lattice.inertia[i]});
    for (const double m : {lattice.mass[i], lattice.inertia[i]})
      per_mass_.push_back(free ? static_cast<Real>(1.0 / m) : Real(0));
    top_.push_back(lattice.grip[i] == packing::Grip::top);
  }
}

template <class Real>
void Ensemble<Real>::start_from(const std::vector<lattice::Vector6>& base) {
  base_ = base;
  find_beams_at_top();
  steps_done_ = 0;
  std::fill(born_.begin(), born_.end(), 0);
  build_parts();
  for (int lane = 0; lane < lanes_; ++lane) put_to_rest(lane);
  weighed_at_ = velocities_at_ = -1;
  for (int lane = 0; lane < scenarios(); ++lane) ledger_[lane].energy_start = energy(lane).total();
}

template <class Real>
void Ensemble<Real>::release_from(const std::vector<lattice::Vector6>& moved) {
  start_from(std::vector<lattice::Vector6>(moved.size(), lattice::Vector6::Zero()));
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const lattice::Pose pose = lattice::pose_of(moved[i]);
    const Eigen::Vector4d turn(pose.turn.w(), pose.turn.x(), pose.turn.y(), pose.turn.z());
    for (int lane = 0; lane < lanes_; ++lane)
      for (int c = 0; c < numbers_; ++c)
        q_[(i * numbers_ + c) * lanes_ + lane] =
            static_cast<Real>(numbers_ == 6 || c < 3 ? moved[i][c] : turn[c - 3]);
  }
  // At rest now, so half a step ago it moved the other way.
  weigh(velocity_.data());
  for (std::size_t k = 0; k < velocity_.size(); ++k) v_[k] = -static_cast<Real>(velocity_[k]);
  weighed_at_ = velocities_at_ = -1;
  for (int lane = 0; lane < scenarios(); ++lane) {
    ledger_[lane] = fracture::Ledger{};
    ledger_[lane].energy_start = energy(lane).total();
  }
}

template <class Real>
void Ensemble<Real>::throw_lane(int lane, const std::vector<lattice::Vector6>& velocity) {
  for (std::size_t i = 0; i < velocity.size(); ++i)
    for (int c = 0; c < 6; ++c) v_[(i * 6 + c) * lanes_ + lane] = static_cast<Real>(velocity[i][c]);
  weighed_at_ = velocities_at_ = -1;
  ledger_[lane] = fracture::Ledger{};
  ledger_[lane].energy_start = energy(lane).total();
}

/// A lane in the base state, nothing of it released yet. Lanes without a scenario stay there.
template <class Real>
void Ensemble<Real>::put_to_rest(int lane) {
  const std::size_t rows = q_.size() / (static_cast<std::size_t>(numbers_) * lanes_);
  for (std::size_t row = 0; row < rows; ++row) {
    for (int c = 0; c < 6; ++c) v_[(row * 6 + c) * lanes_ + lane] = 0;
    Eigen::Vector4d turn(1, 0, 0, 0);
    if (numbers_ == 7 && row < base_.size()) {
      const Eigen::Quaterniond base = lattice::pose_of(base_[row]).turn;
      turn = {base.w(), base.x(), base.y(), base.z()};
    }
    for (int c = 0; c < numbers_; ++c)
      q_[(row * numbers_ + c) * lanes_ + lane] =
          numbers_ == 7 && c >= 3 ? static_cast<Real>(turn[c - 3]) : Real(0);
  }
  for (std::size_t k = 0; k < met_.size(); ++k) {
    factor_[at_crossing(static_cast<int>(k), lane)] = notched_[k] ? Real(0) : Real(1);
    booked_[at_crossing(static_cast<int>(k), lane)] = 0.0;
  }
  for (std::size_t k = lane; k < slip_.size(); k += lanes_) slip_[k] = slip_after_[k] = 0;
  if (lane >= scenarios()) return;
  first_standing_[lane] = 0;
  spent_[lane] = pending_[lane] = {};
  held_[lane] = inherited_[lane] = 0.0;
  ledger_[lane] = fracture::Ledger{};
}

template <class Real>
void Ensemble<Real>::build_parts() {
  const RowSource source{*lattice_, marching_.kinematics, base_, met_, notched_, damped_, normal_};
  part_.clear();
  int ghost_row = static_cast<int>(base_.size());
  for (std::size_t p = 0; p + 1 < cut_.size(); ++p) {
    part_.push_back(rows_of_part<Real>(source, cut_[p], cut_[p + 1], ghost_row, lanes_));
    ghost_row += static_cast<int>(part_.back().ghost.size());
  }
  q_.resize(static_cast<std::size_t>(ghost_row) * numbers_ * lanes_);
  v_.resize(static_cast<std::size_t>(ghost_row) * 6 * lanes_);
  if (!rate_.empty()) rate_.resize(v_.size());
  velocity_.resize(base_.size() * 6 * lanes_);
  base_rows_.assign(6UL * ghost_row, 0.0);
  const auto set_base = [&](int row, int element) {
    for (int c = 0; c < 6; ++c) base_rows_[6UL * row + c] = base_[element][c];
  };
  for (int i = 0; i < static_cast<int>(base_.size()); ++i) set_base(i, i);
  for (AlignedVector<Real>* numbers : {&alpha_at_surface_, &alpha_elsewhere_, &touches_, &friction_})
    numbers->assign(lanes_, 0);
  for (int lane = 0; lane < scenarios(); ++lane) set_lane_numbers(lane);
  for (std::size_t p = 0; p < part_.size(); ++p) {
    PartRows<Real>& rows = part_[p];
    for (std::size_t g = 0; g < rows.ghost.size(); ++g)
      set_base(rows.first_ghost_row + static_cast<int>(g), rows.ghost[g]);
    const bool linear = marching_.kinematics == lattice::Kinematics::linear;
    PartView<Real>& view = rows.view;
    view.begin = cut_[p], view.end = cut_[p + 1];
    view.q = q_.data(), view.v = v_.data(), view.rate = rate_.empty() ? nullptr : rate_.data();
    view.ring = rows.ring.data();
    view.per_mass = per_mass_.data(), view.mass = mass_.data(), view.top = top_.data();
    view.base = base_rows_.data();
    view.halo = static_cast<std::int32_t>(rows.halo_i.size()), view.halo_i = rows.halo_i.data();
    view.first = rows.first.data();
    view.beam = linear ? static_cast<const void*>(rows.linear.data()) : rows.corotational.data();
    view.groups =
        static_cast<std::int32_t>(linear ? rows.linear_group.size() : rows.corotational_group.size());
    view.group = linear ? static_cast<const void*>(rows.linear_group.data()) : rows.corotational_group.data();
    view.specials = static_cast<std::int32_t>(rows.special.size()), view.special = rows.special.data();
    view.extra = rows.extra.data();
    view.damping = damped_.empty() ? nullptr : rows.damping.data();
    view.damping_before = damped_.empty() ? nullptr : rows.damping_before.data();
    view.crossings =
        static_cast<std::int32_t>(linear ? rows.linear_crossing.size() : rows.corotational_crossing.size());
    view.crossing =
        linear ? static_cast<const void*>(rows.linear_crossing.data()) : rows.corotational_crossing.data();
    view.factor = factor_.data();
    view.contacts =
        static_cast<std::int32_t>(linear ? rows.linear_contact.size() : rows.corotational_contact.size());
    view.contact =
        linear ? static_cast<const void*>(rows.linear_contact.data()) : rows.corotational_contact.data();
    view.contact_force = marching_.contact ? rows.contact.data() : nullptr;
    view.contact_before = marching_.contact ? rows.contact_before.data() : nullptr;
    view.touches = touches_.data(), view.friction = friction_.data();
    view.damped = static_cast<std::int32_t>(rows.damped.size()), view.damped_row = rows.damped.data();
    view.alpha_at_surface = alpha_at_surface_.data(), view.alpha_elsewhere = alpha_elsewhere_.data();
    view.account = rows.account.data();
    view.speed = nullptr;
  }
  set_slips();
}

template <class Real>
void Ensemble<Real>::set_slips() {
  for (PartRows<Real>& rows : part_) rows.view.slip = slip_.data(), rows.view.slip_after = slip_after_.data();
}

template <class Real>
void Ensemble<Real>::set_lane_numbers(int lane) {
  const fracture::LaneScenario& scenario = scenario_[lane];
  assert(marching_.contact || !scenario.friction);
  alpha_at_surface_[lane] = static_cast<Real>(scenario.alpha_at_surface);
  alpha_elsewhere_[lane] = static_cast<Real>(scenario.alpha_elsewhere);
  touches_[lane] = scenario.friction ? Real(1) : Real(0);
  friction_[lane] = static_cast<Real>(scenario.friction.value_or(0.0));
}

template <class Real>
void Ensemble<Real>::start_crack(const std::vector<lattice::DampedBeam>& damped) {
  std::fill(crack_start_.begin(), crack_start_.end(), steps_done_);
  cracking_ = true;
  damp(damped);
}

template <class Real>
void Ensemble<Real>::damp(const std::vector<lattice::DampedBeam>& damped) {
  if (damped.empty()) return;
  add_up_spent();
  const std::vector<double> contact = by_element(&PartRows<Real>::contact_before);
  damped_ = damped;
  build_parts();
  set_by_element(&PartRows<Real>::contact_before, contact);
  weighed_at_ = velocities_at_ = -1;
}

template <class Real>
void Ensemble<Real>::steer(int lane, const fracture::LaneScenario& scenario) {
  scenario_[lane] = scenario;
  set_lane_numbers(lane);
}

template <class Real>
void Ensemble<Real>::refill(int lane, const fracture::LaneScenario& scenario) {
  steer(lane, scenario);
  put_to_rest(lane);
  for (PartRows<Real>& rows : part_) {  // a lane that diverged has left no numbers there
    for (AlignedVector<Real>* before : {&rows.damping_before, &rows.contact_before})
      for (std::size_t k = lane; k < before->size(); k += lanes_) (*before)[k] = 0;
    for (std::size_t k = lane; k < rows.account.size(); k += lanes_) rows.account[k] = 0.0;
  }
  born_[lane] = crack_start_[lane] = steps_done_;
  weighed_at_ = velocities_at_ = -1;
  ledger_[lane].energy_start = energy(lane).total();
}

template <class Real>
void Ensemble<Real>::copy_ghosts() {
  if (part_.size() < 2) return;
  crew_->run(threads(), [this](int p) {
    const PartRows<Real>& rows = part_[p];
    const auto copy = [&](AlignedVector<Real>& state, int numbers) {
      const std::size_t row = static_cast<std::size_t>(numbers) * lanes_;
      for (std::size_t g = 0; g < rows.ghost.size(); ++g)
        std::copy_n(&state[rows.ghost[g] * row], row, &state[(rows.first_ghost_row + g) * row]);
    };
    copy(q_, numbers_);
    if (damped_.empty()) return;
    copy(rate_.empty() ? v_ : rate_, 6);
  });
}

template <class Real>
void Ensemble<Real>::step() {
  foresee_softening();
  copy_ghosts();
  const StepConstants k = constants();
  const bool booked =
      !damped_.empty() || !rate_.empty() || marching_.contact || grip_before_ != 0.0 || grip_after_ != 0.0;
  crew_->run(threads(),
             [&](int p) { (booked ? kernel_.advance_booked : kernel_.advance)(part_[p].view, k); });
  for (Spent& spent : spent_) spent.grip -= 0.5 * (grip_before_ + grip_after_) * dt_ * base_pull_;
  std::swap(slip_, slip_after_), set_slips();
  soften();
  beta_before_ = beta_after_;
  grip_before_ = grip_after_;
  ++steps_done_;
}

/// The crack's history is known ahead: which beams will soften in this step, and how they are strained before
/// it.
template <class Real>
void Ensemble<Real>::foresee_softening() {
  softening_.clear();
  if (!cracking_) return;
  const int count = static_cast<int>(met_.size());
  for (int lane = 0; lane < scenarios(); ++lane) {
    const fracture::LaneScenario& scenario = scenario_[lane];
    const double a = history::tip_at(scenario.history, crack_time(lane, steps_done_ + 1));
    const double reach = fracture::reach_ahead(scenario, a);
    int& first = first_standing_[lane];
    while (first < count && factor_[at_crossing(first, lane)] == 0) ++first;
    for (int k = first; k < count && met_[k].position <= a + reach; ++k) {
      const Real before = factor_[at_crossing(k, lane)];
      const fracture::ReleaseLaw& law = fracture::law_at(scenario, met_[k].position);
      const Real after =
          std::min(before, static_cast<Real>(fracture::stiffness_left(law, a, met_[k].position)));
      if (after == before) continue;
      softening_.push_back({k, lane, before, after, strain(met_[k].beam, lane)});
      if (scenario.friction) softening_.back().gap = gap(k, lane);
    }
  }
}

/// A factor that falls from s to s' takes (s - s') 1/2 q_before^T k q_after: with it the books close exactly.
/// What of it the faces go on holding is theirs.
template <class Real>
void Ensemble<Real>::soften() {
  for (const Softening& c : softening_) {
    const std::size_t at = at_crossing(c.crossing, c.lane);
    const lattice::Beam& beam = lattice_->beam[met_[c.crossing].beam];
    const lattice::BeamStrain now = strain(met_[c.crossing].beam, c.lane);
    double left_over = lattice::bilinear_energy(beam, c.strain, now);
    if (const auto& friction = scenario_[c.lane].friction) {
      const Eigen::Vector3d m = normal(c.crossing), slipped = slip(c.crossing, c.lane);
      const double held = fracture::bilinear_energy(
          fracture::face_stiffness(beam), fracture::face_contact(c.gap, m, slipped, *friction),
          fracture::face_contact(gap(c.crossing, c.lane), m, slipped, *friction));
      left_over -= held;
      inherited_[c.lane] += (c.before - c.after) * held;
    }
    booked_[at] += (c.before - c.after) * left_over;
    factor_[at] = static_cast<Real>(c.after);
  }
}

template <class Real>
Eigen::Vector3d Ensemble<Real>::gap(int crossing, int lane) const {
  const int beam = met_[crossing].beam;
  const auto& [i, j] = lattice_->ends[beam];
  const lattice::Beam& form = lattice_->beam[beam];
  if (marching_.kinematics == lattice::Kinematics::corotational)
    return fracture::face_gap(form, pose(i, lane), pose(j, lane));
  return fracture::face_gap(form, motion(i, lane), motion(j, lane));
}

template <class Real>
Eigen::Vector3d Ensemble<Real>::slip(int crossing, int lane) const {
  Eigen::Vector3d slip = Eigen::Vector3d::Zero();
  for (int c = 0; c < 3 && marching_.contact; ++c)
    slip[c] = static_cast<double>(slip_[(3UL * crossing + c) * lanes_ + lane]);
  return slip;
}

template <class Real>
void Ensemble<Real>::set_grip_speed(double speed) {
  grip_after_ = speed;
  velocities_at_ = -1;
  for (std::size_t i = 0; i < top_.size(); ++i)
    if (top_[i])
      for (int lane = 0; lane < lanes_; ++lane) v_[(i * 6 + 1) * lanes_ + lane] = static_cast<Real>(speed);
}

template <class Real>
void Ensemble<Real>::set_beta(double beta) {
  beta_after_ = beta;
  if (beta == 1.0 || !rate_.empty()) return;
  rate_ = v_;
  for (PartRows<Real>& rows : part_) rows.view.rate = rate_.data();
}

template <class Real>
lattice::Pose Ensemble<Real>::pose(int element, int lane) const {
  const auto at = [&](int c) {
    return static_cast<double>(q_[(static_cast<std::size_t>(element) * numbers_ + c) * lanes_ + lane]);
  };
  return {base_[element].template head<3>() + Eigen::Vector3d(at(0), at(1), at(2)),
          Eigen::Quaterniond(at(3), at(4), at(5), at(6))};
}

template <class Real>
lattice::Vector6 Ensemble<Real>::motion(int element, int lane) const {
  if (marching_.kinematics == lattice::Kinematics::corotational)
    return lattice::motion_of(pose(element, lane));
  lattice::Vector6 m = base_[element];
  for (int c = 0; c < 6; ++c)
    m[c] += static_cast<double>(q_[(static_cast<std::size_t>(element) * 6 + c) * lanes_ + lane]);
  return m;
}

template <class Real>
lattice::Vector6 Ensemble<Real>::velocity(int element, int lane) {
  if (velocities_at_ != steps_done_) weigh(velocity_.data());
  lattice::Vector6 v;
  for (int c = 0; c < 6; ++c) v[c] = velocity_[(static_cast<std::size_t>(element) * 6 + c) * lanes_ + lane];
  return v;
}

template <class Real>
lattice::BeamStrain Ensemble<Real>::strain(int beam, int lane) const {
  const auto& [i, j] = lattice_->ends[beam];
  const lattice::Beam& form = lattice_->beam[beam];
  if (marching_.kinematics == lattice::Kinematics::corotational)
    return lattice::strain_of(form, pose(i, lane), pose(j, lane));
  return lattice::strain_of(form, motion(i, lane), motion(j, lane));
}

template class Ensemble<double>;
template class Ensemble<float>;

}  // namespace rift::ensemble
