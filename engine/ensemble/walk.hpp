#pragma once

#include "engine/ensemble/columns.hpp"
#include "engine/ensemble/loads.hpp"

namespace rift::ensemble::RIFT_INSTRUCTIONS {

/// Finds an element in an ascending list of them as the walk comes by.
struct ElementIndex {
  const std::int32_t* element;
  int count, next = 0;
  /// The place of element i in the list, or -1; i ascends.
  int of(int i) { return next < count && element[next] == i ? next++ : -1; }
};

/// The rates of an element.
template <int Width, class Real>
inline void rates_at(const PartView<Real>& p, long row, Pack<Real, Width> (&to)[6]) {
  load_row<6, Width>(rates_of(p) + row * 6 * Width, to);
}

/// A beam's dampers times alpha. @param[in] at_i  rates of its first element;  @param[in] j  row of the
/// second
template <class Real, int Width>
inline EndLoads<Pack<Real, Width>> damper_loads_at(const PartView<Real>& p, const Dampers<Real>& d,
                                                   const Space<Pack<Real, Width>>& axis,
                                                   const Pack<Real, Width> (&at_i)[6], long j) {
  using V = Pack<Real, Width>;
  const V alpha = load<Width>(d.at_surface ? p.alpha_at_surface : p.alpha_elsewhere);
  V at_j[6];
  rates_at<Width>(p, j, at_j);
  return damper_loads<V>(axis, alpha * d.axial, alpha * d.twist, alpha * d.bend, at_i, at_j);
}

/// The form of an intact beam of which less than all may be left.
template <template <class, int> class Form, class Real, int Width, bool Breaking>
inline auto form_of(const ViewOf<Form, Real>& p, long b) {
  using F = Form<Real, Width>;
  const auto form = F::form(p.intact[b].form);
  if constexpr (Breaking)
    return F::softened(form, load<Width>(p.left + b * Width));
  else
    return form;
}

/// Whether any number of a pack of whole numbers is not 0.
template <class V>
inline bool any_of(V x) {
  if constexpr (sizeof(V) == 16) {
    typedef long long Two __attribute__((vector_size(16)));
    const Two both = (Two)x;
    return (both[0] | both[1]) != 0;
  } else {
    typedef long long Longs __attribute__((vector_size(sizeof(V))));
    typedef long long Half __attribute__((vector_size(sizeof(V) / 2)));
    union Halves {
      Longs whole;
      Half half[2];
    } halves{(Longs)x};
    return any_of(halves.half[0] | halves.half[1]);
  }
}

/// Notes the beams of a pack whose energy is above their thresholds: one comparison for all that are far
/// below.
/// @param[in] energy  of the change since the base state [J];  @param[in] place  as of WatchedRow
template <int Size, class Real>
inline void note_watched(const PartView<Real>& p, long place, Pack<Real, Size> energy) {
  const auto above = energy > load<Size>(p.watch_above + place * Size);
  if (__builtin_expect(!any_of(above), 1)) return;
  std::uint32_t which = 0;
  // Number by number: GCC 12 with its sanitizers reads every element of `above` as true here.
  for (int k = 0; k < Size; ++k)
    if (energy[k] > p.watch_above[place * Size + k]) which |= 1U << k;
  p.watched[(*p.watched_count)++] = {static_cast<std::int32_t>(place), which};
}

/// The beams of other parts' elements to this part's: their loads on the second element go into the ring.
/// A function of its own, as add_extra_forces().
template <template <class, int> class Form, class Real, int Width, bool Damped, Directions directions,
          bool Breaking>
[[gnu::noinline, gnu::flatten]] void walk_halo(const ViewOf<Form, Real>& p) {
  using F = Form<Real, Width>;
  using V = Pack<Real, Width>;
  for (long b = 0; b < p.halo; ++b) {
    const auto& beam = p.intact[b];
    const auto form = form_of<Form, Real, Width, Breaking>(p, b);
    const EndLoads<V> e = F::loads(form, place_at<Form, Real, Width, directions>(p, p.halo_i[b]),
                                   place_at<Form, Real, Width, directions>(p, beam.j));
    add_to<Width>(p.ring + beam.slot * 6L * Width, [&](V(&f)[6]) { put_opposite(f, e); });
    if (!Damped || !p.dampers || p.dampers[b].at_surface < 0) continue;
    V at_i[6];
    rates_at<Width>(p, p.halo_i[b], at_i);
    const EndLoads<V> taken =
        damper_loads_at<Real, Width>(p, p.dampers[b], F::initial_axis(form), at_i, beam.j);
    add_to<Width>(p.damping_ring + beam.slot * 6L * Width, [&](V(&d)[6]) { put_opposite(d, taken); });
  }
}

/// Walks over the elements in their order: each gets the forces of its beams to later ones and, in the ring,
/// of earlier ones' beams to it; then nothing is missing and `finish` may move it on, since no later beam
/// asks for it. Every element sums in one order, whoever walks. Forces of dampers go through a ring of their
/// own, since the energy balance asks for them alone; elements without dampers do not see it. Cost O(beams x
/// lanes); allocates nothing.
/// @tparam    Damped      whether there may be dampers at all
/// @tparam    directions  of the beams' forces
/// @tparam    Breaking    whether the intact beams break by themselves
/// @param[in] finish  called with the element, the forces [N] and moments [N m] of its intact beams, its
/// index
///                    among those with additional loads and among those that dampers act on, or -1, and the
///                    forces of its intact beams' dampers, where there are any
template <template <class, int> class Form, class Real, int Width, bool Damped, Directions directions,
          bool Breaking, class Finish>
inline void walk_lanes(const ViewOf<Form, Real>& p, const Finish& finish) {
  using F = Form<Real, Width>;
  using V = Pack<Real, Width>;
  walk_halo<Form, Real, Width, Damped, directions, Breaking>(p);
  long b = p.halo;  // intact beam
  ElementIndex extra{p.extra_element, p.extras}, damped{p.damped_element, p.damped_elements};
  for (int i = p.begin; i < p.end; ++i) {
    const auto qi = place_at<Form, Real, Width, directions>(p, i);
    const long begun = b, ended = p.halo + p.first[i - p.begin + 1];
    Real* own = p.ring + (i & p.mask) * 6L * Width;
    V f[6], d[6]{};
    load_row<6, Width>(own, f);
    for (; b < ended; ++b) {
      const auto& beam = p.intact[b];
      const auto form = form_of<Form, Real, Width, Breaking>(p, b);
      const auto qj = place_at<Form, Real, Width, directions>(p, beam.j);
      const EndLoads<V> e = F::loads(form, qi, qj);
      if constexpr (Breaking) note_watched<Width>(p, b, F::energy(form, qi, qj));
      put(f, e);
      add_to<Width>(p.ring + beam.slot * 6L * Width, [&](V(&other)[6]) { put_opposite(other, e); });
    }
    const int damped_index = Damped ? damped.of(i) : -1;
    if (damped_index >= 0) {
      Real* own_damping = p.damping_ring + (i & p.mask) * 6L * Width;
      load_row<6, Width>(own_damping, d);
      clear(own_damping, 6L * Width);
      V at_i[6];
      rates_at<Width>(p, i, at_i);
      // A loop of their own: with the beams' loads in one there are too few registers, and 16 lanes are a
      // sixth slower.
      for (long k = begun; k < ended; ++k) {
        const auto& beam = p.intact[k];
        if (p.dampers[k].at_surface < 0) continue;
        const EndLoads<V> e =
            damper_loads_at<Real, Width>(p, p.dampers[k], F::initial_axis(F::form(beam.form)), at_i, beam.j);
        put(d, e);
        add_to<Width>(p.damping_ring + beam.slot * 6L * Width, [&](V(&other)[6]) { put_opposite(other, e); });
      }
    }
    finish(i, f, extra.of(i), damped_index, d);
    clear(own, 6L * Width);
  }
}

/// The dampers of a group's beams.
template <int Size, class Real>
inline void add_group_dampers(const PartView<Real>& p, const Space<Pack<Real, Size>>& axis,
                              const std::int32_t* rows, const std::int32_t* damper_rows, const Real* number) {
  using V = Pack<Real, Size>;
  V at_i[6], at_j[6], alpha{};
  columns_of<Size, 6>(rates_of(p), rows + BeamGroup::i * Size, at_i);
  columns_of<Size, 6>(rates_of(p), rows + BeamGroup::j * Size, at_j);
  for (int k = 0; k < Size; ++k)
    alpha[k] = *(damper_rows[BeamGroup::at_surface * Size + k] ? p.alpha_at_surface : p.alpha_elsewhere);
  const V axial = load<Size>(number), twist = load<Size>(number + Size), bend = load<Size>(number + 2 * Size);
  add_loads<Size>(p.damping_ring, damper_rows + BeamGroup::damper_slot_i * Size,
                  damper_rows + BeamGroup::damper_slot_j * Size,
                  damper_loads<V>(axis, alpha * axial, alpha * twist, alpha * bend, at_i, at_j));
}

/// As place_at(), of a group's elements, a column each.
template <template <class, int> class Form, class Real, int Size, Directions directions>
inline auto places_of(const PartView<Real>& p, const std::int32_t* rows) {
  using F = Form<Real, Size>;
  const auto at = [&](const Real* q) {
    Pack<Real, Size> column[F::numbers];
    columns_of<Size, F::numbers>(q, rows, column);
    return F::position(column);
  };
  if constexpr (directions == Directions::of_moment)
    return at(p.q);
  else
    return typename F::Positions{at(p.q), at(p.mean_q)};
}

/// The same walk for one scenario alone, a group of beams at once.
template <template <class, int> class Form, class Real, bool Damped, Directions directions, bool Breaking,
          class Finish>
inline void walk_groups(const ViewOf<Form, Real>& p, const Finish& finish) {
  constexpr int Size = group_size<Form, Real>;
  using F = Form<Real, Size>;
  using V = Pack<Real, Size>;
  constexpr int numbers = beam_numbers<typename Form<Real, 1>::Row>;
  ElementIndex extra{p.extra_element, p.extras}, damped{p.damped_element, p.damped_elements};
  int i = p.begin;
  for (long g = 0; g < p.groups; ++g) {
    const std::int32_t* rows = p.group_rows + g * BeamGroup::rows * Size;
    V number[numbers];
    load_row<numbers, Size>(p.group_number + g * numbers * Size, number);
    const auto qi = places_of<Form, Real, Size, directions>(p, rows + BeamGroup::i * Size);
    const auto qj = places_of<Form, Real, Size, directions>(p, rows + BeamGroup::j * Size);
    const auto form = F::form(number);
    add_loads<Size>(p.ring, rows + BeamGroup::slot_i * Size, rows + BeamGroup::slot_j * Size,
                    F::loads(form, qi, qj));
    if constexpr (Breaking) note_watched<Size>(p, g, F::energy(form, qi, qj));
    if (const long at = Damped && p.group_dampers ? p.group_dampers[g] : -1; at >= 0)
      add_group_dampers<Size>(p, F::initial_axis(form), rows,
                              p.group_damper_rows + at * BeamGroup::damper_rows * Size,
                              p.group_damper_number + at * BeamGroup::damper_numbers * Size);
    for (; i < p.group_complete[g]; ++i) {
      Real* own = p.ring + long{i & p.mask} * BeamGroup::ring_row;
      Real f[6], d[6]{};
      load_row<6, 1>(own, f);
      const int damped_index = Damped ? damped.of(i) : -1;
      if (damped_index >= 0) {
        Real* own_damping = p.damping_ring + long{i & p.mask} * BeamGroup::ring_row;
        load_row<6, 1>(own_damping, d);
        clear(own_damping, 6);
      }
      finish(i, f, extra.of(i), damped_index, d);
      clear(own, 6);
    }
  }
}

template <template <class, int> class Form, class Real, int Width, bool Damped, Directions directions,
          bool Breaking, class Finish>
inline void walk(const ViewOf<Form, Real>& p, const Finish& finish) {
  add_extra_forces<Form, Real, Width, directions, Breaking>(p);
  if constexpr (Breaking) *p.watched_count = 0;
  if constexpr (Width == 1)
    walk_groups<Form, Real, Damped, directions, Breaking>(p, finish);
  else
    walk_lanes<Form, Real, Width, Damped, directions, Breaking>(p, finish);
}

}  // namespace rift::ensemble::RIFT_INSTRUCTIONS
