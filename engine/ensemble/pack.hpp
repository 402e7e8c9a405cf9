#pragma once

// Included by the kernels alone, once for each instruction set, inside a namespace named after it: a template
// shared between them would be compiled for one and linked into all.
#include <type_traits>
#include <utility>

#if defined(__FMA__)
#include <immintrin.h>
#endif

namespace rift::ensemble::RIFT_INSTRUCTIONS {

template <class Real, int Width>
struct PackOf {
  typedef Real type __attribute__((vector_size(Width * sizeof(Real))));
  typedef Real unaligned
      __attribute__((vector_size(Width * sizeof(Real)), aligned(alignof(Real)), may_alias));
};
template <class Real>
struct PackOf<Real, 1> {
  using type = Real;
  typedef Real unaligned __attribute__((may_alias));
};

/// `Width` numbers that are added and multiplied as one: a register, or a few.
template <class Real, int Width>
using Pack = typename PackOf<Real, Width>::type;

template <int Width, class Real>
inline Pack<Real, Width> load(const Real* p) {
  return *reinterpret_cast<const typename PackOf<Real, Width>::unaligned*>(p);
}
template <int Width, class Real>
inline void store(Real* p, Pack<Real, Width> x) {
  *reinterpret_cast<typename PackOf<Real, Width>::unaligned*>(p) = x;
}

/// x in every place. (V{} + x would be an addition, since 0 + (-0) is 0: one more for each number of a beam.)
template <class V, class Real>
inline V splat(Real x) {
  return x - V{};
}

template <class V>
struct ElementOf {
  using type = std::remove_reference_t<decltype(std::declval<V&>()[0])>;
};
template <>
struct ElementOf<double> {
  using type = double;
};
template <>
struct ElementOf<float> {
  using type = float;
};

/// a b + c, rounded once where the processor can; the same in every lane and for every width.
template <class V>
inline V fma(V a, V b, V c) {
#if defined(__FMA__)
  using Element = typename ElementOf<V>::type;
  constexpr auto bytes = sizeof(V);
  if constexpr (!std::is_arithmetic_v<V> && bytes > RIFT_REGISTER_BYTES) {
    typedef Element Half __attribute__((vector_size(bytes / 2)));
    union Halves {
      V whole;
      Half half[2];
    } x{a}, y{b}, z{c};
    for (int k : {0, 1}) z.half[k] = fma(x.half[k], y.half[k], z.half[k]);
    return z.whole;
  } else if constexpr (std::is_arithmetic_v<V>) {
    if constexpr (std::is_same_v<V, double>)
      return __builtin_fma(a, b, c);
    else
      return __builtin_fmaf(a, b, c);
  } else if constexpr (std::is_same_v<Element, double>) {
    if constexpr (bytes == 16) return (V)_mm_fmadd_pd((__m128d)a, (__m128d)b, (__m128d)c);
    if constexpr (bytes == 32) return (V)_mm256_fmadd_pd((__m256d)a, (__m256d)b, (__m256d)c);
#if defined(__AVX512F__)
    if constexpr (bytes == 64) return (V)_mm512_fmadd_pd((__m512d)a, (__m512d)b, (__m512d)c);
#endif
  } else {
    if constexpr (bytes == 16) return (V)_mm_fmadd_ps((__m128)a, (__m128)b, (__m128)c);
    if constexpr (bytes == 32) return (V)_mm256_fmadd_ps((__m256)a, (__m256)b, (__m256)c);
#if defined(__AVX512F__)
    if constexpr (bytes == 64) return (V)_mm512_fmadd_ps((__m512)a, (__m512)b, (__m512)c);
#endif
  }
#endif
  return a * b + c;
}

inline double root(double x) { return __builtin_sqrt(x); }
inline float root(float x) { return __builtin_sqrtf(x); }
template <class V>
inline V root(V x) {
  V y = x;
  for (unsigned k = 0; k < sizeof(V) / sizeof(x[0]); ++k) y[k] = root(x[k]);
  return y;
}

/// The same numbers in double precision.
template <class Real, int Width>
inline Pack<double, Width> widened(Pack<Real, Width> x) {
  if constexpr (std::is_same_v<Real, double>)
    return x;
  else if constexpr (Width == 1)
    return static_cast<double>(x);
  else
    return __builtin_convertvector(x, Pack<double, Width>);
}

/// Three packs as a vector in space.
template <class V>
struct Space {
  V x, y, z;
};

template <class V>
inline Space<V> operator+(Space<V> a, Space<V> b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class V>
inline Space<V> operator-(Space<V> a, Space<V> b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class V>
inline Space<V> operator*(V s, Space<V> a) {
  return {s * a.x, s * a.y, s * a.z};
}

/// a + s b
template <class V>
inline Space<V> plus(Space<V> a, V s, Space<V> b) {
  return {fma(s, b.x, a.x), fma(s, b.y, a.y), fma(s, b.z, a.z)};
}
template <class V>
inline V dot(Space<V> a, Space<V> b) {
  return fma(a.z, b.z, fma(a.y, b.y, a.x * b.x));
}
template <class V>
inline Space<V> cross(Space<V> a, Space<V> b) {
  return {fma(a.y, b.z, -(a.z * b.y)), fma(a.z, b.x, -(a.x * b.z)), fma(a.x, b.y, -(a.y * b.x))};
}
/// c + a x b
template <class V>
inline Space<V> plus_cross(Space<V> c, Space<V> a, Space<V> b) {
  return {fma(a.y, b.z, fma(-a.z, b.y, c.x)), fma(a.z, b.x, fma(-a.x, b.z, c.y)),
          fma(a.x, b.y, fma(-a.y, b.x, c.z))};
}

}  // namespace rift::ensemble::RIFT_INSTRUCTIONS
