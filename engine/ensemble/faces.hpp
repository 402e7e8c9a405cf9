#pragma once

#include "engine/ensemble/rows.hpp"

namespace rift::RIFT_INSTRUCTIONS {

/// face_contact() of fracture/face_contact.hpp, pack by pack.
template <class V>
struct Touch {
  V shortening;
  Space<V> sliding;
};

template <class Real, class V>
inline Touch<V> touch(const FaceStrain<V>& f, V axial, V bending, const Space<V>& slip, V friction) {
  const V none{};
  const V shortening = f.stretch < none ? f.stretch : none;
  const Space<V> sliding = f.bend - slip;
  const V most = -(friction * axial * shortening) / (Real(1.5) * bending * f.two_per_length);
  const V held = root(dot(sliding, sliding));
  const V part = held > most ? most / held : none + Real(1);
  return {shortening, part * sliding};
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

/// (1 - s) of what the faces carry, and how far they have slipped: only where they have begun to part.
template <template <class, int> class Form, class Real, int Width>
inline void add_contact_forces(const PartView<Real>& p) {
  using F = Form<Real, Width>;
  using V = Pack<Real, Width>;
  const auto* rows = static_cast<const ContactRow<Real, typename F::Row>*>(p.contact);
  const V touches = load<Width>(p.touches), friction = load<Width>(p.friction);
  for (int b = 0; b < p.contacts; ++b) {
    const auto& row = rows[b];
    const V parted = touches * (Real(1) - load<Width>(p.factor + static_cast<long>(row.k) * Width));
    if (!any(parted)) continue;
    FaceStrain<V> f = F::face_strain(F::form(row.form), position_at<Form, Real, Width>(p.q, row.i),
                                     position_at<Form, Real, Width>(p.q, row.j));
    f.stretch = f.stretch + row.stretch;
    f.bend = f.bend + Space<V>{splat<V>(row.bend[0]), splat<V>(row.bend[1]), splat<V>(row.bend[2])};
    const long at = 3L * Width * row.k;
    V slip[3];
    load_row<3, Width>(p.slip + at, slip);
    const V axial = splat<V>(row.form.stiffness.axial), bending = splat<V>(row.form.stiffness.bending);
    const Touch<V> t = touch<Real>(f, axial, bending, {slip[0], slip[1], slip[2]}, friction);
    if (p.slip_after && row.extra_i >= 0) {
      const Space<V> now = f.bend - t.sliding;
      const V kept[3] = {parted > V{} ? now.x : slip[0], parted > V{} ? now.y : slip[1],
                         parted > V{} ? now.z : slip[2]};
      store_row<3, Width>(p.slip_after + at, kept);
    }
    const Space<V> S = (Real(1.5) * parted * bending) * t.sliding, opposite = Space<V>{} - S;
    const EndLoads<V> e{plus((parted * axial * t.shortening) * f.n, -f.two_per_length, cross(S, f.n)),
                        opposite, opposite};
    if (row.extra_i >= 0)
      add_to<Width>(p.contact_force + row.extra_i * 6L * Width, [&](V(&to)[6]) { put(to, e); });
    if (row.extra_j >= 0)
      add_to<Width>(p.contact_force + row.extra_j * 6L * Width, [&](V(&to)[6]) { put_opposite(to, e); });
  }
}

}  // namespace rift::RIFT_INSTRUCTIONS
