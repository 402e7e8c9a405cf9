#pragma once

#include "engine/ensemble/forms.hpp"

#include <cstring>

/// Rows of several elements as columns, a number of all of them in one pack, and back: for one scenario
/// alone, whose beams go side by side.
namespace rift::ensemble::RIFT_INSTRUCTIONS {

/// Beams side by side. With registers of 512 bits eight corotational beams are 1.3 times as fast as four, and
/// eight linear ones in single precision 1.14 times; in double they are 0.93 times as fast, since their loads
/// wait for rows of the ring that were stored just before, and wide rows are handed on late.
template <template <class, int> class Form, class Real>
inline constexpr int group_size =
    RIFT_REGISTER_BYTES == 64 && !(Form<Real, 1>::numbers == 6 && std::is_same_v<Real, double>) ? 8 : 4;

template <class Real>
inline void transpose(Pack<Real, 4> (&r)[4]) {
  const auto a = __builtin_shufflevector(r[0], r[1], 0, 4, 2, 6),
             b = __builtin_shufflevector(r[0], r[1], 1, 5, 3, 7);
  const auto c = __builtin_shufflevector(r[2], r[3], 0, 4, 2, 6),
             d = __builtin_shufflevector(r[2], r[3], 1, 5, 3, 7);
  r[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5), r[1] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
  r[2] = __builtin_shufflevector(a, c, 2, 3, 6, 7), r[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
}

/// Of each row the pairs 0, 1, 2, 3 become columns.
template <class V>
inline void transpose_pairs(V (&r)[4]) {
  const V a = __builtin_shufflevector(r[0], r[1], 0, 1, 4, 5, 8, 9, 12, 13),
          b = __builtin_shufflevector(r[0], r[1], 2, 3, 6, 7, 10, 11, 14, 15),
          c = __builtin_shufflevector(r[2], r[3], 0, 1, 4, 5, 8, 9, 12, 13),
          d = __builtin_shufflevector(r[2], r[3], 2, 3, 6, 7, 10, 11, 14, 15);
  r[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5, 8, 9, 12, 13);
  r[1] = __builtin_shufflevector(b, d, 0, 1, 4, 5, 8, 9, 12, 13);
  r[2] = __builtin_shufflevector(a, c, 2, 3, 6, 7, 10, 11, 14, 15);
  r[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7, 10, 11, 14, 15);
}

template <class Real>
inline void transpose(Pack<Real, 8> (&r)[8]) {
  Pack<Real, 8> even[4], odd[4];
  for (int k = 0; k < 4; ++k) {
    even[k] = __builtin_shufflevector(r[2 * k], r[2 * k + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    odd[k] = __builtin_shufflevector(r[2 * k], r[2 * k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  transpose_pairs(even), transpose_pairs(odd);
  for (int k = 0; k < 4; ++k) r[2 * k] = even[k], r[2 * k + 1] = odd[k];
}

/// A row of `Count` numbers and what follows it. That may be a row which another thread writes at this
/// moment: those numbers are dropped, whatever they are. The thread sanitizer cannot know that and gets the
/// row alone.
template <int Count, class Real>
inline Pack<Real, 8> row_and_beyond(const Real* from) {
#ifdef __SANITIZE_THREAD__
  Pack<Real, 8> row{};
  std::memcpy(&row, from, Count * sizeof(Real));
  return row;
#else
  return load<8>(from);
#endif
}

/// Rows of `Count` numbers as columns. Eight at once read up to two numbers beyond a row, which is why the
/// arrays of state end with as many more.
/// @param[in] row  of each beam's element
template <int Size, int Count, class Real>
inline void columns_of(const Real* from, const std::int32_t* row, Pack<Real, Size> (&to)[Count]) {
  using V = Pack<Real, Size>;
  if constexpr (Size == 8) {
    V r[8];
    for (int k = 0; k < 8; ++k) r[k] = row_and_beyond<Count>(from + row[k] * long{Count});
    transpose<Real>(r);
    for (int c = 0; c < Count; ++c) to[c] = r[c];
  } else {
    V low[4], high[4];
    for (int k = 0; k < 4; ++k)
      low[k] = load<4>(from + row[k] * long{Count}),
      high[k] = load<4>(from + row[k] * long{Count} + Count - 4);
    transpose<Real>(low), transpose<Real>(high);
    for (int k = 0; k < 4; ++k) to[k] = low[k], to[Count - 4 + k] = high[k];
  }
}

/// Adds the loads of a group's beams to rows of a ring, beam by beam: an element sums in the beams' order.
template <int Size, class Real>
inline void add_loads(Real* ring, const std::int32_t* slot_i, const std::int32_t* slot_j,
                      const EndLoads<Pack<Real, Size>>& e) {
  using V = Pack<Real, Size>;
  const V none{};
  const auto row = [&](std::int32_t slot) { return ring + long{slot} * BeamGroup::ring_row; };
  if constexpr (Size == 8) {
    V on_i[8] = {e.force.x, e.force.y, e.force.z, e.moment_i.x, e.moment_i.y, e.moment_i.z, none, none};
    V on_j[8] = {none - e.force.x,
                 none - e.force.y,
                 none - e.force.z,
                 e.moment_j.x,
                 e.moment_j.y,
                 e.moment_j.z,
                 none,
                 none};
    transpose<Real>(on_i), transpose<Real>(on_j);
    for (int k = 0; k < 8; ++k) {
      store<8>(row(slot_i[k]), load<8>(row(slot_i[k])) + on_i[k]);
      store<8>(row(slot_j[k]), load<8>(row(slot_j[k])) + on_j[k]);
    }
  } else {
    V on_i[4] = {e.force.x, e.force.y, e.force.z, e.moment_i.x};
    V on_j[4] = {none - e.force.x, none - e.force.y, none - e.force.z, e.moment_j.x};
    transpose<Real>(on_i), transpose<Real>(on_j);
    const V yz[4] = {__builtin_shufflevector(e.moment_i.y, e.moment_i.z, 0, 4, 1, 5),
                     __builtin_shufflevector(e.moment_i.y, e.moment_i.z, 2, 6, 3, 7),
                     __builtin_shufflevector(e.moment_j.y, e.moment_j.z, 0, 4, 1, 5),
                     __builtin_shufflevector(e.moment_j.y, e.moment_j.z, 2, 6, 3, 7)};
    const auto add = [&](Real* at, V head, Pack<Real, 2> tail) {
      store<4>(at, load<4>(at) + head);
      store<2>(at + 4, load<2>(at + 4) + tail);
    };
    for (int k = 0; k < 4; ++k) {
      const auto half = [&](V x) {
        return k % 2 == 0 ? __builtin_shufflevector(x, x, 0, 1) : __builtin_shufflevector(x, x, 2, 3);
      };
      add(row(slot_i[k]), on_i[k], half(yz[k / 2]));
      add(row(slot_j[k]), on_j[k], half(yz[2 + k / 2]));
    }
  }
}

}  // namespace rift::ensemble::RIFT_INSTRUCTIONS
