#pragma once

#include "engine/ensemble/forms.hpp"

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

template <template <class, int> class Form, class Real, int Width>
inline typename Form<Real, Width>::Position position_at(const Real* q, long row) {
  using F = Form<Real, Width>;
  Pack<Real, Width> c[F::numbers];
  load_row<F::numbers, Width>(q + row * F::numbers * Width, c);
  return F::position(c);
}

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

}  // namespace rift::ensemble::RIFT_INSTRUCTIONS
