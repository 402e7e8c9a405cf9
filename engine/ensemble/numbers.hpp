#pragma once

#include "engine/ensemble/instruction_set.hpp"
#include "engine/results/checkpoint.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace rift::ensemble {

using results::NamedNumbers;

/// Memory that begins on a cache line, so that no register straddles two.
template <class T>
struct OnCacheLine {
  using value_type = T;
  OnCacheLine() = default;
  template <class U>
  OnCacheLine(const OnCacheLine<U>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), std::align_val_t(64))); }
  void deallocate(T* p, std::size_t) { ::operator delete(p, std::align_val_t(64)); }
  bool operator==(const OnCacheLine&) const { return true; }
};

template <class T>
using AlignedVector = std::vector<T, OnCacheLine<T>>;

/// An array in the precision that the kernels march in, read and written as doubles by everybody else.
class Numbers {
 public:
  explicit Numbers(Precision precision) : single_(precision == Precision::single_precision) {}

  double operator[](std::size_t k) const { return single_ ? static_cast<double>(float_[k]) : double_[k]; }
  void set(std::size_t k, double x) {
    single_ ? void(float_[k] = static_cast<float>(x)) : void(double_[k] = x);
  }
  std::size_t size() const { return single_ ? float_.size() : double_.size(); }
  bool empty() const { return size() == 0; }
  /// New numbers are 0.
  void resize(std::size_t count) { single_ ? float_.resize(count) : double_.resize(count); }

  /// Copies `count` numbers within the array.
  void copy(std::size_t from, std::size_t to, std::size_t count) {
    const auto copy_in = [&](auto& numbers) { std::copy_n(&numbers[from], count, &numbers[to]); };
    single_ ? copy_in(float_) : copy_in(double_);
  }

  /// For the kernels of this precision, and for no other.
  template <class Real>
  Real* data() {
    return const_cast<Real*>(std::as_const(*this).data<Real>());
  }
  template <class Real>
  const Real* data() const {
    if constexpr (std::is_same_v<Real, float>)
      return float_.data();
    else
      return double_.data();
  }

 private:
  bool single_;
  AlignedVector<double> double_;  // one of the two is empty
  AlignedVector<float> float_;
};

// How a checkpoint keeps arrays: every float and every integer below 2^53 is a double.

/// Appends the first `count` numbers of an array to those of a name.
template <class Array>
void put(NamedNumbers& state, const std::string& name, const Array& numbers, std::size_t count) {
  std::vector<double>& out = state[name];
  for (std::size_t k = 0; k < count; ++k) out.push_back(static_cast<double>(numbers[k]));
}

/// The numbers of a name. Throws std::invalid_argument where there are not `count` of them.
inline const std::vector<double>& numbers_of(const NamedNumbers& state, const std::string& name,
                                             std::size_t count) {
  const auto found = state.find(name);
  if (found == state.end() || found->second.size() != count)
    throw std::invalid_argument("it holds no " + name + " of this run");
  return found->second;
}

/// A whole number that a double holds. Throws std::invalid_argument where it is none: no checkpoint was made
/// of it.
template <class Whole>
Whole whole(double number, const std::string& name) {
  if (!(std::abs(number) <= 0x1p53) || number != std::trunc(number))
    throw std::invalid_argument("its " + name + " is no whole number");
  if constexpr (sizeof(Whole) < sizeof(double))
    if (std::abs(number) > static_cast<double>(std::numeric_limits<Whole>::max()))
      throw std::invalid_argument("its " + name + " is out of range");
  return static_cast<Whole>(number);
}

/// Fills an array, all of it or its first `count`. Throws std::invalid_argument as the two above do.
inline void take(const NamedNumbers& state, const std::string& name, Numbers& numbers, std::size_t count) {
  const std::vector<double>& in = numbers_of(state, name, count);
  for (std::size_t k = 0; k < count; ++k) numbers.set(k, in[k]);
}
template <class Number>
void take(const NamedNumbers& state, const std::string& name, std::vector<Number>& numbers) {
  const std::vector<double>& in = numbers_of(state, name, numbers.size());
  for (std::size_t k = 0; k < in.size(); ++k)
    if constexpr (std::is_integral_v<Number>)
      numbers[k] = whole<Number>(in[k], name);
    else
      numbers[k] = in[k];
}

}  // namespace rift::ensemble
