#include "engine/ensemble/ensemble.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace rift::ensemble {
namespace {

/// Appends numbers of any kind; every float and every integer below 2^53 is a double.
template <class Numbers>
void put(NamedNumbers& state, const std::string& name, const Numbers& numbers, std::size_t count) {
  std::vector<double>& out = state[name];
  for (std::size_t k = 0; k < count; ++k) out.push_back(static_cast<double>(numbers[k]));
}

const std::vector<double>& numbers_of(const NamedNumbers& state, const std::string& name, std::size_t count) {
  const auto found = state.find(name);
  if (found == state.end() || found->second.size() != count)
    throw std::invalid_argument("it holds no " + name + " of this run");
  return found->second;
}

/// A whole number that a double holds; a state of anything else was not written by state().
template <class Whole>
Whole whole(double number, const std::string& name) {
  if (!(std::abs(number) <= 0x1p53) || number != std::trunc(number))
    throw std::invalid_argument("its " + name + " is no whole number");
  if constexpr (sizeof(Whole) < sizeof(double))
    if (std::abs(number) > static_cast<double>(std::numeric_limits<Whole>::max()))
      throw std::invalid_argument("its " + name + " is out of range");
  return static_cast<Whole>(number);
}

template <class Numbers>
void take(const NamedNumbers& state, const std::string& name, Numbers& numbers, std::size_t count) {
  const std::vector<double>& in = numbers_of(state, name, count);
  using Number = std::decay_t<decltype(numbers[0])>;
  for (std::size_t k = 0; k < count; ++k)
    if constexpr (std::is_integral_v<Number>)
      numbers[k] = whole<Number>(in[k], name);
    else
      numbers[k] = static_cast<Number>(in[k]);
}

}  // namespace

template <class Real>
NamedNumbers Ensemble<Real>::state() const {
  NamedNumbers state;
  const std::size_t rows = base_.size() * lanes_;
  state["clock"] = {static_cast<double>(steps_done_),
                    cracking_ ? 1.0 : 0.0,
                    beta_before_,
                    beta_after_,
                    grip_before_,
                    grip_after_,
                    base_pull_};
  put(state, "born", born_, born_.size());
  put(state, "crack_start", crack_start_, crack_start_.size());
  put(state, "first_standing", first_standing_, first_standing_.size());
  put(state, "position", q_, rows * numbers_);
  put(state, "velocity", v_, rows * 6);
  put(state, "rate", rate_, rate_.empty() ? 0 : rows * 6);
  put(state, "factor", factor_, factor_.size());
  put(state, "booked", booked_, booked_.size());
  for (std::size_t lane = 0; lane < ledger_.size(); ++lane) {
    const fracture::Ledger& l = ledger_[lane];
    const Spent& s = spent_[lane];
    for (const double x :
         {l.energy_start, l.fracture, l.damping, l.numerical_damping, l.contact, l.work_external, l.largest,
          s.damping, s.numerical, s.contact, s.grip, inherited_[lane]})
      state["ledger"].push_back(x);
  }
  // By chunks and by elements, which do not depend on how many threads march.
  for (const PartRows<Real>& part : part_) put(state, "account", part.account, part.account.size());
  state["damping_before"] = by_element(&PartRows<Real>::damping_before);
  if (!marching_.contact) return state;
  state["contact_before"] = by_element(&PartRows<Real>::contact_before);
  put(state, "slip", slip_, slip_.size());
  return state;
}

/// Rows of special elements as rows of all, 0 elsewhere; none where no part has any.
template <class Real>
std::vector<double> Ensemble<Real>::by_element(AlignedVector<Real> PartRows<Real>::*special_rows) const {
  std::vector<double> rows;
  const std::size_t row = 6UL * lanes_;
  for (const PartRows<Real>& part : part_) {
    const AlignedVector<Real>& numbers = part.*special_rows;
    if (!numbers.empty()) rows.resize(base_.size() * row);
    for (std::size_t k = 0; k < numbers.size(); ++k)
      rows[static_cast<std::size_t>(part.special[k / row]) * row + k % row] = static_cast<double>(numbers[k]);
  }
  return rows;
}

template <class Real>
void Ensemble<Real>::set_by_element(AlignedVector<Real> PartRows<Real>::*special_rows,
                                    const std::vector<double>& rows) {
  const std::size_t row = 6UL * lanes_;
  for (PartRows<Real>& part : part_) {
    AlignedVector<Real>& numbers = part.*special_rows;
    for (std::size_t k = 0; k < numbers.size() && !rows.empty(); ++k)
      numbers[k] = static_cast<Real>(rows[static_cast<std::size_t>(part.special[k / row]) * row + k % row]);
  }
}

template <class Real>
void Ensemble<Real>::restore(const NamedNumbers& state) {
  const std::size_t rows = base_.size() * lanes_;
  const std::vector<double>& clock = numbers_of(state, "clock", 7);
  steps_done_ = whole<std::int64_t>(clock[0], "clock");
  cracking_ = clock[1] != 0.0;
  set_beta(clock[3]);  // makes room for the rates where it damps
  const auto rates = state.find("rate");
  if (rates != state.end() && !rates->second.empty() && rate_.empty()) set_beta(0.5), set_beta(clock[3]);
  beta_before_ = clock[2], beta_after_ = clock[3];
  grip_before_ = clock[4], grip_after_ = clock[5], base_pull_ = clock[6];
  take(state, "born", born_, born_.size());
  take(state, "crack_start", crack_start_, crack_start_.size());
  take(state, "first_standing", first_standing_, first_standing_.size());
  for (const int k : first_standing_)
    if (k < 0 || k > static_cast<int>(met_.size()))
      throw std::invalid_argument("its first_standing is no crossing of this run");
  take(state, "position", q_, rows * numbers_);
  take(state, "velocity", v_, rows * 6);
  take(state, "rate", rate_, rate_.empty() ? 0 : rows * 6);
  take(state, "factor", factor_, factor_.size());
  take(state, "booked", booked_, booked_.size());
  const std::vector<double>& ledger = numbers_of(state, "ledger", 12 * ledger_.size());
  for (std::size_t lane = 0; lane < ledger_.size(); ++lane) {
    const double* x = &ledger[12 * lane];
    ledger_[lane] = {x[0], x[1], x[2], x[3], x[4], x[5], x[6]};
    spent_[lane] = {x[7], x[8], x[9], x[10]};
    inherited_[lane] = x[11];
  }
  set_by_element(&PartRows<Real>::damping_before,
                 numbers_of(state, "damping_before", damped_.empty() ? 0 : rows * 6));
  if (marching_.contact) {
    set_by_element(&PartRows<Real>::contact_before, numbers_of(state, "contact_before", rows * 6));
    take(state, "slip", slip_, slip_.size());
    slip_after_ = slip_;
  }
  std::size_t accounts_of_all = 0;
  for (const PartRows<Real>& part : part_) accounts_of_all += part.account.size();
  auto account = numbers_of(state, "account", accounts_of_all).begin();
  for (PartRows<Real>& part : part_) {
    std::copy_n(account, part.account.size(), part.account.begin());
    account += static_cast<std::ptrdiff_t>(part.account.size());
  }
  weighed_at_ = velocities_at_ = -1;
}

template std::vector<double> Ensemble<double>::by_element(AlignedVector<double> PartRows<double>::*) const;
template std::vector<double> Ensemble<float>::by_element(AlignedVector<float> PartRows<float>::*) const;
template void Ensemble<double>::set_by_element(AlignedVector<double> PartRows<double>::*,
                                               const std::vector<double>&);
template void Ensemble<float>::set_by_element(AlignedVector<float> PartRows<float>::*,
                                              const std::vector<double>&);
template NamedNumbers Ensemble<double>::state() const;
template NamedNumbers Ensemble<float>::state() const;
template void Ensemble<double>::restore(const NamedNumbers&);
template void Ensemble<float>::restore(const NamedNumbers&);

}  // namespace rift::ensemble
