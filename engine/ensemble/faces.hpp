#pragma once

#include "engine/ensemble/rows.hpp"

namespace rift::ensemble::RIFT_INSTRUCTIONS {

/// face_contact() of fracture/face_contact.hpp, pack by pack.
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

/// (1 - s) of what the faces carry, and how far they have slipped: only where they have begun to part.
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
    if (p.slip_after && row.extra_i >= 0) {
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

}  // namespace rift::ensemble::RIFT_INSTRUCTIONS
