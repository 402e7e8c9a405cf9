#include "engine/ensemble/state.hpp"

#include "engine/fracture/face_contact.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace rift::ensemble {
namespace {

/// Takes up the step that evaluate_energies() has made: what the next one finds before it, and its accounts.
void take_up(Part& part, int lanes, bool balanced) {
  std::swap(part.damping_before, part.next_damping_before);
  std::swap(part.contact_before, part.next_contact_before);
  if (!balanced) return;
  const std::size_t chunk = static_cast<std::size_t>(accounts) * lanes;
  for (std::size_t at = 0; at < part.account.size(); at += chunk)
    for (const auto& [spent, coming] :
         {std::pair{spent_damping, pending_damping}, std::pair{spent_numerical, pending_numerical},
          std::pair{spent_contact, pending_contact}, std::pair{spent_grip, coming_grip}})
      for (int lane = 0; lane < lanes; ++lane)
        part.account[at + spent * lanes + lane] += part.account[at + coming * lanes + lane];
}

}  // namespace

State::State(const lattice::Lattice& lattice, std::vector<fracture::DamageableBeam> damageable, int scenarios,
             const EnsembleOptions& options)
    : lattice_(&lattice),
      options_(options),
      lanes_(options.lanes ? options.lanes : lanes_for(options.precision, scenarios)),
      damageable_(std::move(damageable)),
      base_(lattice.centre.size(), lattice::Vector6::Zero()),
      arrays_(options.precision),
      cut_(cut_evenly(lattice, options.threads)) {
  assert(scenarios > 0 && scenarios <= lanes_);
  assert(!options_.breaking || (options_.kinematics == lattice::Kinematics::linear && !options_.contact));
  const std::size_t factors = damageable_.size() * lanes_, n = lattice.mass.size();
  arrays_.factor.resize(factors);
  if (options_.contact) arrays_.slip.resize(3 * factors), arrays_.slip_after.resize(3 * factors);
  for (Numbers* numbers : {&arrays_.alpha_at_surface, &arrays_.alpha_elsewhere, &arrays_.in_contact,
                           &arrays_.friction, &arrays_.load})
    numbers->resize(lanes_);
  const int parts = static_cast<int>(cut_.size()) - 1;
  threads_ = std::make_unique<base::ThreadPool>(parts, parts);
  arrays_.per_mass.resize(6 * n);
  for (const fracture::DamageableBeam& d : damageable_) {
    const lattice::Beam& b = lattice.beam[d.beam];
    opening_row_.push_back({lattice.ends[d.beam][0],
                            lattice.ends[d.beam][1],
                            {b.axis.x(), b.axis.y(), b.axis.z()},
                            2.0 / b.length,
                            2.0 * b.bending / b.axial,
                            b.twist / b.axial});
  }
  for (std::size_t i = 0; i < n; ++i) {
    arrays_.mass.insert(arrays_.mass.end(), {lattice.mass[i], lattice.inertia[i]});
    for (int c = 0; c < 6; ++c)
      if (!(c < 3 ? lattice.is_gripped(i) : lattice.cannot_turn(i)))
        arrays_.per_mass.set(6 * i + c, 1.0 / (c < 3 ? lattice.mass[i] : lattice.inertia[i]));
    arrays_.top.push_back(lattice.grip[i] == packing::Grip::top);
  }
}

void State::set_base(const std::vector<lattice::Vector6>& base) {
  base_ = base;
  find_beams_at_top();
  sum_base_energy();
  find_base_openings();
  build_parts();
  for (int lane = 0; lane < lanes_; ++lane) put_to_rest(lane);
}

/// The corotational loads hold the pull of the base state already.
void State::find_beams_at_top() {
  top_beam_.clear();
  base_pull_ = 0.0;
  std::vector<int> place(lattice_->beam.size(), -1);
  for (std::size_t k = 0; k < damageable_.size(); ++k) place[damageable_[k].beam] = static_cast<int>(k);
  for (std::size_t b = 0; b < place.size(); ++b) {
    const auto& [i, j] = lattice_->ends[b];
    if ((place[b] >= 0 && damageable_[place[b]].absent) || arrays_.top[i] == arrays_.top[j]) continue;
    top_beam_.push_back({static_cast<int>(b), place[b]});
    if (options_.kinematics == lattice::Kinematics::corotational) continue;
    const lattice::BeamLoads loads = lattice::loads_of(lattice_->beam[b], base_[i], base_[j]);
    base_pull_ += arrays_.top[i] ? loads.force_i.y() : -loads.force_i.y();
  }
}

/// The corotational energies are whole without it.
void State::sum_base_energy() {
  base_energy_ = 0.0;
  if (options_.kinematics == lattice::Kinematics::corotational) return;
  std::vector<char> intact(lattice_->beam.size(), 1);
  for (const fracture::DamageableBeam& d : damageable_) intact[d.beam] = options_.breaking && !d.absent;
  for (std::size_t b = 0; b < intact.size(); ++b) {
    if (!intact[b]) continue;
    const auto& [i, j] = lattice_->ends[b];
    const lattice::Beam& beam = lattice_->beam[b];
    base_energy_ += lattice::energy_of(beam, lattice::strain_of(beam, base_[i], base_[j]));
  }
}

double State::base_energy(int lane) const {
  const auto top = std::find(arrays_.top.begin(), arrays_.top.end(), 1);
  if (base_pull_ == 0.0 || top == arrays_.top.end()) return base_energy_;
  const std::size_t element = top - arrays_.top.begin();
  return base_energy_ - base_pull_ * arrays_.q[(element * position_numbers() + 1) * lanes_ + lane];
}

void State::build_parts() {
  ahead_.reset();
  const RowSource source{*lattice_, options_, lanes_, base_, damageable_, damped_, outside_};
  part_.clear();
  std::vector<int> element(base_.size());  // of each row
  for (std::size_t i = 0; i < element.size(); ++i) element[i] = static_cast<int>(i);
  for (std::size_t p = 0; p + 1 < cut_.size(); ++p) {
    part_.push_back(make_part(source, cut_[p], cut_[p + 1], static_cast<int>(element.size())));
    element.insert(element.end(), part_.back()->ghost.begin(), part_.back()->ghost.end());
  }
  const std::size_t rows = element.size() * lanes_;
  arrays_.q.resize(rows * position_numbers() + row_padding);
  arrays_.v.resize(rows * 6 + row_padding);
  if (corotational()) arrays_.mean_q.resize(arrays_.q.size()), arrays_.velocity.resize(rows * 6);
  if (!arrays_.rate.empty()) arrays_.rate.resize(arrays_.v.size());
  arrays_.base.clear();
  for (const int i : element) arrays_.base.insert(arrays_.base.end(), base_[i].begin(), base_[i].end());
}

void State::set_damped(const std::vector<lattice::DampedBeam>& damped) {
  assert(!options_.breaking);
  // What the loads of the last step were: the next step's work is that of both.
  const std::vector<double> contact = by_element(&Part::contact_before, &Part::extra_element);
  const std::vector<double> damping = by_element(&Part::damping_before, &Part::damped_element);
  damped_ = damped;
  build_parts();
  set_by_element(&Part::contact_before, &Part::extra_element, contact);
  set_by_element(&Part::damping_before, &Part::damped_element, damping);
}

void State::set_lane(int lane, const fracture::LaneScenario& scenario) {
  ahead_.reset();
  assert(options_.contact || !scenario.friction);
  arrays_.alpha_at_surface.set(lane, scenario.alpha_at_surface);
  arrays_.alpha_elsewhere.set(lane, scenario.alpha_elsewhere);
  arrays_.in_contact.set(lane, scenario.friction ? 1.0 : 0.0);
  arrays_.friction.set(lane, scenario.friction.value_or(0.0));
  if (!options_.breaking) return;
  first_opening_.resize(lanes_);
  first_opening_[lane].clear();
  const std::vector<fracture::Softening> beams = fracture::softening_of(*lattice_, scenario.material.value());
  for (const fracture::DamageableBeam& d : damageable_) first_opening_[lane].push_back(beams[d.beam].first);
  for (int k = 0; k < static_cast<int>(damageable_.size()); ++k) set_left(k, lane);
}

void State::set_factor(int k, int lane, double factor) {
  ahead_.reset();
  arrays_.factor.set(at(k, lane), factor);
  if (options_.breaking) set_left(k, lane);
}

void State::put_to_rest(int lane) {
  ahead_.reset();
  const int numbers = position_numbers();
  const std::size_t rows = arrays_.v.size() / (6UL * lanes_);
  for (std::size_t row = 0; row < rows; ++row) {
    for (Numbers* rates : {&arrays_.v, &arrays_.rate})
      for (int c = 0; c < 6 && !rates->empty(); ++c) rates->set((row * 6 + c) * lanes_ + lane, 0.0);
    Eigen::Vector4d turn(1, 0, 0, 0);
    if (numbers == 7 && row < base_.size()) {
      const Eigen::Quaterniond base = lattice::pose_of(base_[row]).turn;
      turn = {base.w(), base.x(), base.y(), base.z()};
    }
    for (int c = 0; c < numbers; ++c)
      arrays_.q.set((row * numbers + c) * lanes_ + lane, numbers == 7 && c >= 3 ? turn[c - 3] : 0.0);
  }
  for (std::size_t k = 0; k < damageable_.size(); ++k)
    set_factor(static_cast<int>(k), lane, damageable_[k].absent ? 0.0 : 1.0);
  for (std::size_t k = lane; k < arrays_.slip.size(); k += lanes_)
    arrays_.slip.set(k, 0.0), arrays_.slip_after.set(k, 0.0);
  for (const auto& part : part_) {  // a lane that diverged has left no numbers there
    for (Numbers* before : {&part->damping_before, &part->contact_before})
      for (std::size_t k = lane; k < before->size(); k += lanes_) before->set(k, 0.0);
    for (std::size_t k = lane; k < part->account.size(); k += lanes_) part->account[k] = 0.0;
  }
}

void State::set_motion(const std::vector<lattice::Vector6>& moved) {
  ahead_.reset();
  const int numbers = position_numbers();
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const Eigen::Quaterniond turn = lattice::pose_of(moved[i]).turn;
    const Eigen::Vector4d q(turn.w(), turn.x(), turn.y(), turn.z());
    for (int lane = 0; lane < lanes_; ++lane)
      for (int c = 0; c < numbers; ++c)
        arrays_.q.set((i * numbers + c) * lanes_ + lane, numbers == 6 || c < 3 ? moved[i][c] : q[c - 3]);
  }
}

void State::set_velocities(const AlignedVector<double>& velocity) {
  ahead_.reset();
  for (std::size_t k = 0; k < velocity.size(); ++k) arrays_.v.set(k, velocity[k]);
}

void State::set_velocities(int lane, const std::vector<lattice::Vector6>& velocity) {
  ahead_.reset();
  for (std::size_t i = 0; i < velocity.size(); ++i)
    for (int c = 0; c < 6; ++c) arrays_.v.set((i * 6 + c) * lanes_ + lane, velocity[i][c]);
}

void State::set_top_velocity(double speed) {
  ahead_.reset();
  for (std::size_t i = 0; i < arrays_.top.size(); ++i)
    if (arrays_.top[i])
      for (int lane = 0; lane < lanes_; ++lane) arrays_.v.set((i * 6 + 1) * lanes_ + lane, speed);
}

void State::set_rollers(const std::vector<int>& elements) {
  for (const int i : elements)
    for (const int c : {0, 4, 5}) arrays_.per_mass.set(6UL * i + c, 0.0);
}

void State::set_load(int lane, double size) {
  const double now = load(lane);
  arrays_.load.set(lane, size);
  if (load(lane) != now) ahead_.reset();
}

void State::set_outside(std::vector<lattice::Vector6> forces) {
  outside_ = std::move(forces);
  loaded_.clear();
  for (int i = 0; i < static_cast<int>(outside_.size()); ++i)
    if (!outside_[i].isZero(0.0)) loaded_.push_back(i);
}

double State::work_of_unit_load(int lane, double dt) const {
  double power = 0.0;
  for (const int i : loaded_)
    for (int c = 0; c < 6; ++c)
      power += outside_[i][c] * rates()[(static_cast<std::size_t>(i) * 6 + c) * lanes_ + lane];
  return power * dt;
}

void State::keep_rates() {
  if (arrays_.rate.empty()) arrays_.rate = arrays_.v;
}

/// Copies rows of other parts' elements to where each part looks for them. @param[in] numbers  of a row
void State::copy_ghosts(const CopyOfRow& copy, int numbers) {
  if (part_.size() < 2) return;
  const std::size_t row = static_cast<std::size_t>(numbers) * lanes_;
  threads_->run(threads(), [&](int p) {
    const Part& part = *part_[p];
    for (std::size_t g = 0; g < part.ghost.size(); ++g)
      copy(part.ghost[g] * row, (part.first_ghost_row + g) * row, row);
  });
}

void State::copy_ghosts(Numbers& state, int numbers) {
  copy_ghosts([&](std::size_t from, std::size_t to, std::size_t count) { state.copy(from, to, count); },
              numbers);
}

/// What the walks over the elements read of other parts' elements.
void State::prepare_walk(const StepConstants& constants) {
  copy_ghosts(arrays_.q, position_numbers());
  if (!damped_.empty()) copy_ghosts(arrays_.rate.empty() ? arrays_.v : arrays_.rate, 6);
  if (!corotational()) return;
  threads_->run(threads(), [&](int p) { part_[p]->find_means(arrays_, constants); });
  copy_ghosts(arrays_.mean_q, position_numbers());
}

StepConstants State::with_balance(StepConstants constants) const {
  constants.balanced = constants.grip_before != 0.0 || constants.grip_after != 0.0 || !damped_.empty() ||
                       !arrays_.rate.empty() || options_.contact;
  return constants;
}

void State::advance(const StepConstants& given) {
  const StepConstants constants = with_balance(given);
  if (ahead_ == constants) {
    std::swap(arrays_.q, arrays_.next_q), std::swap(arrays_.v, arrays_.next_v);
    std::swap(arrays_.rate, arrays_.next_rate);
    for (const auto& part : part_) take_up(*part, lanes_, constants.balanced);
  } else {
    prepare_walk(constants);
    threads_->run(threads(), [&](int p) { part_[p]->advance(arrays_, constants); });
  }
  std::swap(arrays_.slip, arrays_.slip_after);
  ahead_.reset();
}

void State::evaluate_energies(const StepConstants& given, double* velocities) {
  const StepConstants constants = with_balance(given);
  arrays_.next_q.resize(arrays_.q.size()), arrays_.next_v.resize(arrays_.v.size());
  arrays_.next_rate.resize(arrays_.rate.size());
  prepare_walk(constants);
  double* const to = corotational() ? arrays_.velocity.data() : velocities;
  threads_->run(threads(), [&](int p) { part_[p]->evaluate_energies(arrays_, constants, to); });
  if (corotational()) {
    AlignedVector<double>& v = arrays_.velocity;
    copy_ghosts(
        [&](std::size_t from, std::size_t at, std::size_t count) {
          std::copy_n(v.begin() + static_cast<long>(from), count, v.begin() + static_cast<long>(at));
        },
        6);
    threads_->run(threads(), [&](int p) { part_[p]->add_beam_energies(arrays_, constants); });
    if (velocities) std::copy_n(v.begin(), base_.size() * 6 * lanes_, velocities);
  }
  ahead_ = constants;
}

double State::add_account(Account account, int lane, double sum) const {
  const std::size_t chunk = static_cast<std::size_t>(accounts) * lanes_;
  for (const auto& part : part_)
    for (std::size_t k = static_cast<std::size_t>(account) * lanes_ + lane; k < part->account.size();
         k += chunk)
      sum += part->account[k];
  return sum;
}

lattice::Pose State::pose(int element, int lane) const {
  const auto at = [&](int c) {
    return arrays_.q[(static_cast<std::size_t>(element) * position_numbers() + c) * lanes_ + lane];
  };
  return {base_[element].head<3>() + Eigen::Vector3d(at(0), at(1), at(2)),
          Eigen::Quaterniond(at(3), at(4), at(5), at(6))};
}

lattice::Vector6 State::motion(int element, int lane) const {
  if (options_.kinematics == lattice::Kinematics::corotational)
    return lattice::motion_of(pose(element, lane));
  lattice::Vector6 m = base_[element];
  for (int c = 0; c < 6; ++c) m[c] += arrays_.q[(static_cast<std::size_t>(element) * 6 + c) * lanes_ + lane];
  return m;
}

template <class Function>
auto State::of_ends(const Function& function, int beam, int lane) const {
  const auto& [i, j] = lattice_->ends[beam];
  const lattice::Beam& form = lattice_->beam[beam];
  if (options_.kinematics == lattice::Kinematics::corotational)
    return function(form, pose(i, lane), pose(j, lane));
  return function(form, motion(i, lane), motion(j, lane));
}

lattice::BeamStrain State::strain(int beam, int lane) const {
  return of_ends([](const auto&... ends) { return lattice::strain_of(ends...); }, beam, lane);
}

lattice::BeamStrain State::strain_before(int beam, int lane, double dt) const {
  const auto before = [&](int element) {
    lattice::Vector6 m = motion(element, lane);
    for (int c = 0; c < 6; ++c)
      m[c] -= dt * rates()[(static_cast<std::size_t>(element) * 6 + c) * lanes_ + lane];
    return m;
  };
  const auto& [i, j] = lattice_->ends[beam];
  return lattice::strain_of(lattice_->beam[beam], before(i), before(j));
}

Eigen::Vector3d State::gap(int k, int lane) const {
  return of_ends([](const auto&... ends) { return fracture::face_gap(ends...); }, damageable_[k].beam, lane);
}

Eigen::Vector3d State::slip(int k, int lane) const {
  Eigen::Vector3d slip = Eigen::Vector3d::Zero();
  for (int c = 0; c < 3 && options_.contact; ++c) slip[c] = arrays_.slip[(3UL * k + c) * lanes_ + lane];
  return slip;
}

double State::grip_force(int lane) const {
  double force = 0.0;
  for (const auto& [beam, k] : top_beam_) {
    const auto loads = of_ends([](const auto&... ends) { return lattice::loads_of(ends...); }, beam, lane);
    const bool first = arrays_.top[lattice_->ends[beam][0]] != 0;
    force -= (k < 0 ? 1.0 : factor(k, lane)) * (first ? loads.force_i.y() : -loads.force_i.y());
  }
  return force;
}

/// Rows of elements with additional loads as rows of all, 0 elsewhere; none where no part has any.
std::vector<double> State::by_element(Numbers Part::*rows, Elements elements) const {
  std::vector<double> all;
  const std::size_t row = 6UL * lanes_;
  for (const auto& part : part_) {
    const Numbers& numbers = (*part).*rows;
    if (!numbers.empty()) all.resize(base_.size() * row);
    for (std::size_t k = 0; k < numbers.size(); ++k)
      all[static_cast<std::size_t>(((*part).*elements)[k / row]) * row + k % row] = numbers[k];
  }
  return all;
}

void State::set_by_element(Numbers Part::*rows, Elements elements, const std::vector<double>& all) {
  const std::size_t row = 6UL * lanes_;
  for (const auto& part : part_) {
    Numbers& numbers = (*part).*rows;
    for (std::size_t k = 0; k < numbers.size() && !all.empty(); ++k)
      numbers.set(k, all[static_cast<std::size_t>(((*part).*elements)[k / row]) * row + k % row]);
  }
}

void State::save(NamedNumbers& state) const {
  const std::size_t rows = base_.size() * lanes_;
  put(state, "position", arrays_.q, rows * position_numbers());
  put(state, "velocity", arrays_.v, rows * 6);
  put(state, "rate", arrays_.rate, arrays_.rate.empty() ? 0 : rows * 6);
  put(state, "factor", arrays_.factor, arrays_.factor.size());
  // By chunks and by elements, which do not depend on how many threads march.
  for (const auto& part : part_) put(state, "account", part->account, part->account.size());
  state["damping_before"] = by_element(&Part::damping_before, &Part::damped_element);
  if (!options_.contact) return;
  state["contact_before"] = by_element(&Part::contact_before, &Part::extra_element);
  put(state, "slip", arrays_.slip, arrays_.slip.size());
}

void State::restore(const NamedNumbers& state) {
  ahead_.reset();
  const std::size_t rows = base_.size() * lanes_;
  const auto rates = state.find("rate");
  if (rates != state.end() && !rates->second.empty()) keep_rates();
  take(state, "position", arrays_.q, rows * position_numbers());
  take(state, "velocity", arrays_.v, rows * 6);
  take(state, "rate", arrays_.rate, arrays_.rate.empty() ? 0 : rows * 6);
  take(state, "factor", arrays_.factor, arrays_.factor.size());
  for (int lane = 0; lane < lanes_ && options_.breaking; ++lane)
    for (int k = 0; k < static_cast<int>(damageable_.size()); ++k) set_left(k, lane);
  set_by_element(&Part::damping_before, &Part::damped_element,
                 numbers_of(state, "damping_before", damped_.empty() ? 0 : rows * 6));
  if (options_.contact) {
    set_by_element(&Part::contact_before, &Part::extra_element,
                   numbers_of(state, "contact_before", rows * 6));
    take(state, "slip", arrays_.slip, arrays_.slip.size());
    arrays_.slip_after = arrays_.slip;
  }
  std::size_t all = 0;
  for (const auto& part : part_) all += part->account.size();
  auto account = numbers_of(state, "account", all).begin();
  for (const auto& part : part_) {
    std::copy_n(account, part->account.size(), part->account.begin());
    account += static_cast<std::ptrdiff_t>(part->account.size());
  }
}

}  // namespace rift::ensemble
