#pragma once

#include "engine/ensemble/forms.hpp"

/// Additional loads of elements, which most elements do not have: of damageable beams, of faces, of damping.
namespace rift::ensemble::RIFT_INSTRUCTIONS {

/// The part whose beams have this form.
template <template <class, int> class Form, class Real>
using ViewOf = BeamView<typename Form<Real, 1>::Row>;

/// A row of `Count` numbers per lane.
template <int Count, int Width, class Real>
inline void load_row(const Real* row, Pack<Real, Width> (&to)[Count]) {
  for (int c = 0; c < Count; ++c) to[c] = load<Width>(row + c * Width);
}
template <int Count, int Width, class Real>
inline void store_row(Real* row, const Pack<Real, Width> (&from)[Count]) {
  for (int c = 0; c < Count; ++c) store<Width>(row + c * Width, from[c]);
}

/// The position of an element: [m], and [rad] or a unit quaternion. @param[in] q  of all elements; @param[in]
/// row  of the element
template <template <class, int> class Form, class Real, int Width>
inline typename Form<Real, Width>::Position position_at(const Real* q, long row) {
  using F = Form<Real, Width>;
  Pack<Real, Width> c[F::numbers];
  load_row<F::numbers, Width>(q + row * F::numbers * Width, c);
  return F::position(c);
}

/// The positions at which the directions of a beam's forces are taken: those of this moment, or the mean of
/// those a step before and a step after   [Corotational::loads].
enum class Directions { of_moment, of_mean };

/// What the loads of a beam ask of an element: Position, or Positions with directions of the mean.
template <template <class, int> class Form, class Real, int Width, Directions directions>
inline auto place_at(const PartView<Real>& p, long row) {
  const auto now = position_at<Form, Real, Width>(p.q, row);
  if constexpr (directions == Directions::of_moment)
    return now;
  else
    return typename Form<Real, Width>::Positions{now, position_at<Form, Real, Width>(p.mean_q, row)};
}

/// Adds a beam's loads to its first element, or to its second (put_opposite). @param[in,out] f  [N, N m]
template <class V>
inline void put(V (&f)[6], const EndLoads<V>& e) {
  f[0] += e.force.x, f[1] += e.force.y, f[2] += e.force.z;
  f[3] += e.moment_i.x, f[4] += e.moment_i.y, f[5] += e.moment_i.z;
}
template <class V>
inline void put_opposite(V (&f)[6], const EndLoads<V>& e) {
  f[0] -= e.force.x, f[1] -= e.force.y, f[2] -= e.force.z;
  f[3] += e.moment_j.x, f[4] += e.moment_j.y, f[5] += e.moment_j.z;
}

/// Adds to a row of forces.
template <int Width, class Real, class Put>
inline void add_to(Real* row, const Put& put) {
  Pack<Real, Width> f[6];
  load_row<6, Width>(row, f);
  put(f);
  store_row<6, Width>(row, f);
}

/// Contact of two faces as by face_contact() of fracture/face_contact.hpp, pack by pack [m].
template <class V>
struct Touch {
  V overlap;
  Space<V> sliding;
};

template <class Real, class V>
inline Touch<V> touch(const Space<V>& gap, const Space<V>& normal, const Space<V>& slip, V friction) {
  const V none{};
  const V open = dot(normal, gap);
  const V overlap = open < none ? open : none;
  const Space<V> sliding = plus(gap, -open, normal) - slip;
  const V most = -(friction * overlap);
  const V held = root(dot(sliding, sliding));
  const V part = held > most ? most / held : none + Real(1);
  return {overlap, part * sliding};
}

template <class V, class Row>
inline Space<V> normal_of(const Row& row) {
  return {splat<V>(row.normal[0]), splat<V>(row.normal[1]), V{}};
}

template <class V>
inline bool any(V x) {
  if constexpr (std::is_arithmetic_v<V>) {
    return x != 0;
  } else {
    for (unsigned k = 0; k < sizeof(V) / sizeof(x[0]); ++k)
      if (x[k] != 0) return true;
    return false;
  }
}

/// Adds (1 - s) of the forces of the faces, k (overlap m + sliding), to rows of their own, and notes their
/// slips: only where beams are damaged   [ADR 0012].
/// @param[in,out] p  contact [N, N m] of the elements with additional loads; slip_after [m] of the damageable
/// beams
template <template <class, int> class Form, class Real, int Width>
inline void add_contact_forces(const ViewOf<Form, Real>& p) {
  using F = Form<Real, Width>;
  using V = Pack<Real, Width>;
  const V in_contact = load<Width>(p.in_contact), friction = load<Width>(p.friction);
  for (int b = 0; b < p.contacts; ++b) {
    const auto& row = p.contact_row[b];
    const V parted = in_contact * (Real(1) - load<Width>(p.factor + static_cast<long>(row.k) * Width));
    if (!any(parted)) continue;
    const FaceGap<V> face = F::face_gap(F::form(row.form), position_at<Form, Real, Width>(p.q, row.i),
                                        position_at<Form, Real, Width>(p.q, row.j));
    const Space<V> gap =
        face.gap + Space<V>{splat<V>(row.gap[0]), splat<V>(row.gap[1]), splat<V>(row.gap[2])};
    const Space<V> normal = normal_of<V>(row);
    const long at = 3L * Width * row.k;
    V slip[3];
    load_row<3, Width>(p.slip + at, slip);
    const Touch<V> t = touch<Real>(gap, normal, {slip[0], slip[1], slip[2]}, friction);
    if (row.extra_i >= 0) {
      const Space<V> now = plus(gap, -dot(normal, gap), normal) - t.sliding;
      const V kept[3] = {parted > V{} ? now.x : slip[0], parted > V{} ? now.y : slip[1],
                         parted > V{} ? now.z : slip[2]};
      store_row<3, Width>(p.slip_after + at, kept);
    }
    const Space<V> pull = (parted * face.stiffness) * plus(t.sliding, t.overlap, normal);
    const EndLoads<V> e{pull, cross(face.arm_i, pull), cross(face.arm_j, pull)};
    if (row.extra_i >= 0) add_to<Width>(p.contact + row.extra_i * 6L * Width, [&](V(&to)[6]) { put(to, e); });
    if (row.extra_j >= 0)
      add_to<Width>(p.contact + row.extra_j * 6L * Width, [&](V(&to)[6]) { put_opposite(to, e); });
  }
}

/// Adds the forces of the damageable beams, s L + (s - 1) L_base, to the additional loads of their elements:
/// where L is linear it is of the change since the base state, in which the intact beams balance.
/// @param[in,out] p  extra [N, N m] of the elements with additional loads
template <template <class, int> class Form, class Real, int Width, Directions directions>
inline void add_damageable_forces(const ViewOf<Form, Real>& p) {
  using F = Form<Real, Width>;
  using V = Pack<Real, Width>;
  for (int b = 0; b < p.damageable_beams; ++b) {
    const auto& row = p.damageable[b];
    const V s = load<Width>(p.factor + static_cast<long>(row.k) * Width);
    const V of_base = s - Real(1);
    EndLoads<V> e = F::loads(F::form(row.form), place_at<Form, Real, Width, directions>(p, row.i),
                             place_at<Form, Real, Width, directions>(p, row.j));
    const auto reduce = [&](Space<V>& load, const Real* base) {
      load = {fma(of_base, splat<V>(base[0]), s * load.x), fma(of_base, splat<V>(base[1]), s * load.y),
              fma(of_base, splat<V>(base[2]), s * load.z)};
    };
    reduce(e.force, row.base), reduce(e.moment_i, row.base + 3), reduce(e.moment_j, row.base + 6);
    if (row.extra_i >= 0) add_to<Width>(p.extra + row.extra_i * 6L * Width, [&](V(&f)[6]) { put(f, e); });
    if (row.extra_j >= 0)
      add_to<Width>(p.extra + row.extra_j * 6L * Width, [&](V(&f)[6]) { put_opposite(f, e); });
  }
}

/// Where beams break by themselves the walk has their loads of the change since the base state. Adds what
/// they no longer bear of the base state's, (s - 1) L_base.
/// @param[in,out] p  extra [N, N m] of the elements with additional loads
template <template <class, int> class Form, class Real, int Width>
inline void add_softened_base(const ViewOf<Form, Real>& p) {
  using V = Pack<Real, Width>;
  for (int b = 0; b < p.softened_beams; ++b) {
    const auto& row = p.damageable[p.softened[b]];
    const V of_base = load<Width>(p.factor + static_cast<long>(row.k) * Width) - Real(1);
    const auto part = [&](const Real* base) -> Space<V> {
      return {of_base * base[0], of_base * base[1], of_base * base[2]};
    };
    const EndLoads<V> e{part(row.base), part(row.base + 3), part(row.base + 6)};
    if (row.extra_i >= 0) add_to<Width>(p.extra + row.extra_i * 6L * Width, [&](V(&f)[6]) { put(f, e); });
    if (row.extra_j >= 0)
      add_to<Width>(p.extra + row.extra_j * 6L * Width, [&](V(&f)[6]) { put_opposite(f, e); });
  }
}

/// Forces of a beam's dampers, f = 2 alpha sqrt(K M) delta n along its axis n and about it   [paper eq. (8)].
/// @param[in] at_i, at_j  rates of its ends (q_n - q_{n-1}) / dt [m/s, rad/s]
template <class V>
inline EndLoads<V> damper_loads(const Space<V>& n, V axial, V twist, V bend, const V (&at_i)[6],
                                const V (&at_j)[6]) {
  const Space<V> slide{at_j[0] - at_i[0], at_j[1] - at_i[1], at_j[2] - at_i[2]};
  const Space<V> turn{at_j[3] - at_i[3], at_j[4] - at_i[4], at_j[5] - at_i[5]};
  EndLoads<V> e;
  e.force = (axial * dot(n, slide)) * n;
  e.moment_i = plus(bend * turn, (twist - bend) * dot(n, turn), n);
  e.moment_j = Space<V>{} - e.moment_i;
  return e;
}

template <class Real>
inline const Real* rates_of(const PartView<Real>& p) {
  return p.rate ? p.rate : p.v;
}

/// Adds the forces of the damageable beams' dampers to rows of their own.
/// @param[in,out] p  damping [N, N m] of the elements with additional loads
template <class Real, int Width>
inline void add_damping_forces(const PartView<Real>& p) {
  using V = Pack<Real, Width>;
  const Real* rate = rates_of(p);
  for (int b = 0; b < p.damped_beams; ++b) {
    const DampedRow<Real>& row = p.damped[b];
    const V alpha = load<Width>(row.at_surface ? p.alpha_at_surface : p.alpha_elsewhere) *
                    load<Width>(p.factor + static_cast<long>(row.damageable) * Width);
    V at_i[6], at_j[6];
    load_row<6, Width>(rate + row.i * 6L * Width, at_i);
    load_row<6, Width>(rate + row.j * 6L * Width, at_j);
    const Space<V> n{splat<V>(row.nx), splat<V>(row.ny), splat<V>(row.nz)};
    const EndLoads<V> e =
        damper_loads<V>(n, alpha * row.axial, alpha * row.twist, alpha * row.bend, at_i, at_j);
    if (row.extra_i >= 0) add_to<Width>(p.damping + row.extra_i * 6L * Width, [&](V(&f)[6]) { put(f, e); });
    if (row.extra_j >= 0)
      add_to<Width>(p.damping + row.extra_j * 6L * Width, [&](V(&f)[6]) { put_opposite(f, e); });
  }
}

/// Adds the forces from outside to the additional loads of their elements.
template <class Real, int Width>
inline void add_outside_forces(const PartView<Real>& p) {
  const Pack<Real, Width> size = load<Width>(p.load);
  for (int k = 0; k < p.loaded_elements; ++k) {
    Real* row = p.extra + p.loaded[k].extra * 6L * Width;
    for (int c = 0; c < 6; ++c)
      store<Width>(row + c * Width, load<Width>(row + c * Width) + size * p.loaded[k].load[c]);
  }
}

template <class Real>
inline void clear(Real* from, long count) {
  for (long k = 0; k < count; ++k) from[k] = 0;
}

/// Evaluates all additional loads, before the walk. A function of its own, though advance() is flattened: it
/// runs once a part and step, and the three of a kernel share it, which saves the compiler half of its time.
template <template <class, int> class Form, class Real, int Width, Directions directions, bool Breaking>
[[gnu::noinline, gnu::flatten]] void add_extra_forces(const ViewOf<Form, Real>& p) {
  clear(p.extra, 6L * Width * p.extras);
  if constexpr (Breaking)
    add_softened_base<Form, Real, Width>(p);
  else
    add_damageable_forces<Form, Real, Width, directions>(p);
  if (p.loaded_elements > 0) add_outside_forces<Real, Width>(p);
  if (p.contact) {
    clear(p.contact, 6L * Width * p.extras);
    add_contact_forces<Form, Real, Width>(p);
  }
  if (!p.damping) return;
  clear(p.damping, 6L * Width * p.extras);
  add_damping_forces<Real, Width>(p);
}

}  // namespace rift::ensemble::RIFT_INSTRUCTIONS
