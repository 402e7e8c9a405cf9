#pragma once

#include "engine/ensemble/loads.hpp"

namespace rift::ensemble::RIFT_INSTRUCTIONS {

/// Finds the additional loads of elements as the walk comes by.
template <class Real>
struct ExtraIndex {
  const PartView<Real>& p;
  int next = 0;
  /// The index of element i among those with additional loads, or -1; i ascends.
  int of(int i) { return next < p.extras && p.extra_element[next] == i ? next++ : -1; }
};

/// Walks over the elements in their order: each gets the forces of its beams to later ones, of earlier ones'
/// beams to it (in the ring), and its additional loads; then nothing is missing and `finish` may move it on,
/// since no later beam asks for it. Every element sums in one order, whoever walks. Cost O(beams x lanes);
/// allocates nothing.
/// @param[in] finish  called with the element, its forces [N] and moments [N m], and its index among those
/// with
///                    additional loads, or -1
template <template <class, int> class Form, class Real, int Width, class Finish>
inline void walk_lanes(const ViewOf<Form, Real>& p, const Finish& finish) {
  using F = Form<Real, Width>;
  using V = Pack<Real, Width>;
  const auto* beam = p.intact;
  for (int h = 0; h < p.halo; ++h, ++beam) {
    const EndLoads<V> e = F::loads(F::form(beam->form), position_at<Form, Real, Width>(p.q, p.halo_i[h]),
                                   position_at<Form, Real, Width>(p.q, beam->j));
    add_to<Width>(p.ring + beam->slot * 6L * Width, [&](V(&f)[6]) { put_opposite(f, e); });
  }
  ExtraIndex<Real> extra_index{p};
  for (int i = p.begin; i < p.end; ++i) {
    const auto qi = position_at<Form, Real, Width>(p.q, i);
    Real* own = p.ring + (i & p.mask) * 6L * Width;
    V f[6];
    load_row<6, Width>(own, f);
    for (int left = p.first[i - p.begin + 1] - p.first[i - p.begin]; left > 0; --left, ++beam) {
      const EndLoads<V> e = F::loads(F::form(beam->form), qi, position_at<Form, Real, Width>(p.q, beam->j));
      put(f, e);
      add_to<Width>(p.ring + beam->slot * 6L * Width, [&](V(&other)[6]) { put_opposite(other, e); });
    }
    finish(i, f, extra_index.of(i));
    clear(own, 6L * Width);
  }
}

template <class Real>
inline void transpose(Pack<Real, 4> (&r)[4]) {
  const auto a = __builtin_shufflevector(r[0], r[1], 0, 4, 2, 6),
             b = __builtin_shufflevector(r[0], r[1], 1, 5, 3, 7);
  const auto c = __builtin_shufflevector(r[2], r[3], 0, 4, 2, 6),
             d = __builtin_shufflevector(r[2], r[3], 1, 5, 3, 7);
  r[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5), r[1] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
  r[2] = __builtin_shufflevector(a, c, 2, 3, 6, 7), r[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
}

/// The positions of four elements, one in each place of the packs.
template <template <class, int> class Form, class Real>
inline typename Form<Real, 4>::Position four_positions(const Real* q, const std::int32_t (&row)[4]) {
  constexpr int n = Form<Real, 4>::numbers;
  Pack<Real, 4> low[4], high[4], c[n];
  for (int k = 0; k < 4; ++k)
    low[k] = load<4>(q + row[k] * long{n}), high[k] = load<4>(q + row[k] * long{n} + n - 4);
  transpose<Real>(low), transpose<Real>(high);
  for (int k = 0; k < 4; ++k) c[k] = low[k], c[n - 4 + k] = high[k];
  return Form<Real, 4>::position(c);
}

/// The same walk for one scenario alone, four beams at once.
template <template <class, int> class Form, class Real, class Finish>
inline void walk_groups(const ViewOf<Form, Real>& p, const Finish& finish) {
  using F = Form<Real, 4>;
  using V = Pack<Real, 4>;
  constexpr int numbers = beam_numbers<typename Form<Real, 1>::Row>;
  const auto* group = p.group;
  ExtraIndex<Real> extra_index{p};
  int i = p.begin;
  for (int g = 0; g < p.groups; ++g, ++group) {
    V number[numbers];
    for (int k = 0; k < numbers; ++k) number[k] = load<4>(group->number[k]);
    const EndLoads<V> e = F::loads(F::form(number), four_positions<Form, Real>(p.q, group->i),
                                   four_positions<Form, Real>(p.q, group->j));
    V on_i[4] = {e.force.x, e.force.y, e.force.z, e.moment_i.x};
    V on_j[4] = {V{} - e.force.x, V{} - e.force.y, V{} - e.force.z, e.moment_j.x};
    transpose<Real>(on_i), transpose<Real>(on_j);
    const V yz[4] = {__builtin_shufflevector(e.moment_i.y, e.moment_i.z, 0, 4, 1, 5),
                     __builtin_shufflevector(e.moment_i.y, e.moment_i.z, 2, 6, 3, 7),
                     __builtin_shufflevector(e.moment_j.y, e.moment_j.z, 0, 4, 1, 5),
                     __builtin_shufflevector(e.moment_j.y, e.moment_j.z, 2, 6, 3, 7)};
    const auto add = [&](Real* row, V head, Pack<Real, 2> tail) {
      store<4>(row, load<4>(row) + head);
      store<2>(row + 4, load<2>(row + 4) + tail);
    };
    for (int k = 0; k < 4; ++k) {
      const auto half = [&](V x) {
        return k % 2 == 0 ? __builtin_shufflevector(x, x, 0, 1) : __builtin_shufflevector(x, x, 2, 3);
      };
      add(p.ring + group->slot_i[k] * 6L, on_i[k], half(yz[k / 2]));
      add(p.ring + group->slot_j[k] * 6L, on_j[k], half(yz[2 + k / 2]));
    }
    for (; i < group->complete; ++i) {
      Real* own = p.ring + (i & p.mask) * 6L;
      Real f[6];
      load_row<6, 1>(own, f);
      finish(i, f, extra_index.of(i));
      clear(own, 6);
    }
  }
}

template <template <class, int> class Form, class Real, int Width, class Finish>
inline void walk(const ViewOf<Form, Real>& p, const Finish& finish) {
  add_extra_forces<Form, Real, Width>(p);
  if constexpr (Width == 1)
    walk_groups<Form, Real>(p, finish);
  else
    walk_lanes<Form, Real, Width>(p, finish);
}

}  // namespace rift::ensemble::RIFT_INSTRUCTIONS
