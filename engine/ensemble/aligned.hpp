#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace rift::ensemble {

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

}  // namespace rift::ensemble
