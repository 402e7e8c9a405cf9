#pragma once

#include "engine/ensemble/walk.hpp"

namespace rift::ensemble::RIFT_INSTRUCTIONS {

/// All that acts on an element, and its share of the extra forces.
template <class Real, int Width>
inline void add_extra(const PartView<Real>& p, int place, Pack<Real, Width> (&f)[6]) {
  if (place < 0) return;
  for (int c = 0; c < 6; ++c) {
    const long at = (6L * place + c) * Width;
    f[c] = f[c] + load<Width>(p.extra + at);
    if (p.contact_force) f[c] = f[c] + load<Width>(p.contact_force + at);
    if (p.damping) f[c] = f[c] + load<Width>(p.damping + at);
  }
}

/// What the books of a step take of one element [J], in double: viscous damping and work against the contact
/// of the faces - 1/2 (F_n + F_{n+1}) . dq, numerical damping 1/2 M (v^2 at beta = 1 - v^2 at beta), work of
/// the moving grip - 1/2 F . dq   [physics.md §7].
template <class Real, int Width>
struct StepBooks {
  using D = Pack<double, Width>;
  D damping{}, contact{}, numerical{}, grip{};

  void take(const PartView<Real>& p, const StepConstants& k, int i, int place,
            const Pack<Real, Width> (&f)[6], double grip_way) {
    const Real* rates = (p.rate ? p.rate : p.v) + 6L * Width * i;
    // The grip's velocity is that of the step that begins already.
    const auto rate = [&](int c) {
      return p.top[i] && c == 1 ? splat<D>(k.grip_before)
                                : widened<Real, Width>(load<Width>(rates + c * Width));
    };
    const auto taken_by = [&](const Real* force, const Real* before, D& taken) {
      if (!force || place < 0) return;
      for (int c = 0; c < 6; ++c) {
        const long at = (6L * place + c) * Width;
        const D both =
            widened<Real, Width>(load<Width>(force + at)) + widened<Real, Width>(load<Width>(before + at));
        taken -= 0.5 * k.dt * both * rate(c);
      }
    };
    taken_by(p.damping, p.damping_before, damping);
    taken_by(p.contact_force, p.contact_before, contact);
    if (p.rate && p.per_mass[2L * i] != 0)
      for (int c = 0; c < 6; ++c) {
        const D kick =
            0.5 * k.dt * static_cast<double>(p.per_mass[2L * i + c / 3]) * widened<Real, Width>(f[c]);
        const D conserved = widened<Real, Width>(load<Width>(rates + c * Width)) + kick;
        const D v = widened<Real, Width>(load<Width>(p.v + (6L * i + c) * Width)) + k.beta_before * kick;
        numerical += 0.5 * p.mass[2L * i + c / 3] * (conserved * conserved - v * v);
      }
    if (p.top[i]) grip -= 0.5 * grip_way * widened<Real, Width>(f[1]);
  }
};

template <int Width>
inline double* account_of(double* chunk, Account which) {
  return chunk + which * Width;
}

template <int Width>
inline void add_to_account(double* chunk, Account which, Pack<double, Width> amount) {
  double* at = account_of<Width>(chunk, which);
  store<Width>(at, load<Width>(at) + amount);
}

template <class Real, int Width>
inline double* chunk_of(const PartView<Real>& p, int i) {
  return p.account + static_cast<long>((i - p.begin) / chunk_size) * accounts * Width;
}

/// One step: forces at q_n, velocities over a whole step, q_{n+1}   [eqs. (1), (2); Table 1]. `v` holds the
/// velocity after the first half of the step that ends; with beta = 1 that is the rate (q_n - q_{n-1}) / dt.
template <template <class, int> class Form, class Real, int Width, bool Booked>
void advance(const PartView<Real>& p, const StepConstants& k) {
  using F = Form<Real, Width>;
  using V = Pack<Real, Width>;
  const Real dt = static_cast<Real>(k.dt);
  const Real kick = static_cast<Real>(0.5 * k.dt);
  const Real both = Booked ? static_cast<Real>(0.5 * k.dt * k.beta_before) : static_cast<Real>(k.dt);
  const Real begun = static_cast<Real>(0.5 * k.dt * k.beta_after);
  walk<Form, Real, Width>(p, [&](int i, V(&f)[6], int place) {
    add_extra<Real, Width>(p, place, f);
    V q[F::numbers], v[6], rate[6];
    Real* at_q = p.q + static_cast<long>(F::numbers) * Width * i;
    Real* at_v = p.v + 6L * Width * i;
    load_row<F::numbers, Width>(at_q, q);
    load_row<6, Width>(at_v, v);
    const V yield[2] = {splat<V>(p.per_mass[2L * i]), splat<V>(p.per_mass[2L * i + 1])};
    if constexpr (Booked) {
      StepBooks<Real, Width> books;
      books.take(p, k, i, place, f, (k.grip_before + k.grip_after) * k.dt);
      double* chunk = chunk_of<Real, Width>(p, i);
      add_to_account<Width>(chunk, spent_damping, books.damping);
      add_to_account<Width>(chunk, spent_contact, books.contact);
      add_to_account<Width>(chunk, spent_numerical, books.numerical);
      add_to_account<Width>(chunk, spent_grip, books.grip);
      const auto keep = [&](const Real* force, Real* before) {
        if (!force || place < 0) return;
        for (long at = 6L * place * Width; at < 6L * (place + 1) * Width; ++at) before[at] = force[at];
      };
      keep(p.damping, p.damping_before);
      keep(p.contact_force, p.contact_before);
      for (int c = 0; c < 6; ++c) {
        const V a = yield[c / 3] * f[c];
        v[c] = fma(splat<V>(both), a, v[c]);
        rate[c] = fma(splat<V>(kick), a, v[c]);
        v[c] = fma(splat<V>(begun), a, v[c]);
      }
      if (p.rate) store_row<6, Width>(p.rate + 6L * Width * i, rate);
    } else {
      for (int c = 0; c < 6; ++c) rate[c] = v[c] = fma(both * yield[c / 3], f[c], v[c]);
    }
    F::drift(q, rate, splat<V>(dt));
    store_row<F::numbers, Width>(at_q, q);
    store_row<6, Width>(at_v, v);
  });
}

/// Elastic energy of the sound beams by their first element's chunk; in double whatever the state is.
template <template <class, int> class Form, class Real, int Width>
inline typename Form<double, Width>::Position wide_position(const PartView<Real>& p, long row) {
  using D = Form<double, Width>;
  Pack<double, Width> c[D::numbers];
  for (int k = 0; k < D::numbers; ++k) {
    c[k] = widened<Real, Width>(load<Width>(p.q + (row * D::numbers + k) * Width));
    if constexpr (D::numbers == 6) c[k] += p.base[row * 6 + k];  // the linear form's strains are of all
  }
  return D::position(c);
}

template <template <class, int> class Form, class Real, int Width>
inline typename Form<double, Width>::Form wide_form(const typename Form<Real, 1>::Row& beam) {
  constexpr int numbers = sizeof(beam) / sizeof(Real);
  const Real* narrow = reinterpret_cast<const Real*>(&beam);
  Pack<double, Width> number[numbers];
  for (int k = 0; k < numbers; ++k) number[k] = splat<Pack<double, Width>>(static_cast<double>(narrow[k]));
  return Form<double, Width>::form(number);
}

template <template <class, int> class Form, class Real, int Width>
inline Pack<double, Width> wide_energy(const PartView<Real>& p, const typename Form<Real, 1>::Row& beam,
                                       long i, long j) {
  return Form<double, Width>::energy(wide_form<Form, Real, Width>(beam),
                                     wide_position<Form, Real, Width>(p, i),
                                     wide_position<Form, Real, Width>(p, j));
}

/// What the faces have stored.
template <template <class, int> class Form, class Real, int Width>
inline void weigh_contacts(const PartView<Real>& p) {
  using D = Form<double, Width>;
  using V = Pack<double, Width>;
  const auto* contact = static_cast<const ContactRow<Real, typename Form<Real, 1>::Row>*>(p.contact);
  const auto wide = [](const Real* at) { return widened<Real, Width>(load<Width>(at)); };
  for (int b = 0; b < p.contacts; ++b) {
    const auto& row = contact[b];
    if (row.extra_i < 0) continue;  // the other part's
    const V parted = wide(p.touches) * (1.0 - wide(p.factor + static_cast<long>(row.k) * Width));
    if (!any(parted)) continue;
    const auto form = wide_form<Form, Real, Width>(row.form);
    const auto face = D::face_gap(form, wide_position<Form, Real, Width>(p, row.i),
                                  wide_position<Form, Real, Width>(p, row.j));
    const Real* slip = p.slip + 3L * Width * row.k;
    const Touch<V> t =
        touch<double>(face.gap, normal_of<V>(row), {wide(slip), wide(slip + Width), wide(slip + 2 * Width)},
                      wide(p.friction));
    add_to_account<Width>(
        chunk_of<Real, Width>(p, row.i), contact_elastic,
        0.5 * parted * face.stiffness * (t.overlap * t.overlap + dot(t.sliding, t.sliding)));
  }
}

template <template <class, int> class Form, class Real, int Width>
inline void weigh_beams(const PartView<Real>& p) {
  using Row = typename Form<Real, 1>::Row;
  const auto* beam = static_cast<const SoundRow<Row>*>(p.beam) + p.halo;
  for (int i = p.begin; i < p.end; ++i) {
    Pack<double, Width> sum{};
    for (int left = p.first[i - p.begin + 1] - p.first[i - p.begin]; left > 0; --left, ++beam)
      sum += wide_energy<Form, Real, Width>(p, beam->form, i, beam->j);
    add_to_account<Width>(chunk_of<Real, Width>(p, i), elastic, sum);
  }
  const auto* crossing = static_cast<const CrossingRow<Real, Row>*>(p.crossing);
  for (int b = 0; b < p.crossings; ++b) {
    const auto& row = crossing[b];
    if (row.extra_i < 0) continue;  // the other part's
    const auto s = widened<Real, Width>(load<Width>(p.factor + static_cast<long>(row.k) * Width));
    add_to_account<Width>(chunk_of<Real, Width>(p, row.i), elastic,
                          s * wide_energy<Form, Real, Width>(p, row.form, row.i, row.j));
  }
}

/// The energies at q_n and v_n, and what the books of the step that ends have yet to take.
template <template <class, int> class Form, class Real, int Width>
void weigh(const PartView<Real>& p, const StepConstants& k) {
  using V = Pack<Real, Width>;
  using D = Pack<double, Width>;
  for (int i = p.begin; i < p.end; i += chunk_size) clear(chunk_of<Real, Width>(p, i), spent_damping * Width);
  weigh_beams<Form, Real, Width>(p);
  if (p.contact_force) weigh_contacts<Form, Real, Width>(p);
  walk<Form, Real, Width>(p, [&](int i, V(&f)[6], int place) {
    add_extra<Real, Width>(p, place, f);
    StepBooks<Real, Width> books;
    books.take(p, k, i, place, f, k.grip_before * k.dt);
    D translation{}, rotation{}, correction{};
    for (int c = 0; c < 6; ++c) {
      const D force = widened<Real, Width>(f[c]);
      const double per_mass = static_cast<double>(p.per_mass[2L * i + c / 3]), m = p.mass[2L * i + c / 3];
      const D v = widened<Real, Width>(load<Width>(p.v + (6L * i + c) * Width)) +
                  0.5 * k.dt * k.beta_before * per_mass * force;
      if (p.speed) store<Width>(p.speed + (6L * i + c) * Width, v);
      if (per_mass == 0.0) continue;
      (c < 3 ? translation : rotation) += 0.5 * m * v * v;
      correction += 0.125 * k.dt * k.dt * per_mass * force * force;
    }
    double* chunk = chunk_of<Real, Width>(p, i);
    add_to_account<Width>(chunk, kinetic_translation, translation);
    add_to_account<Width>(chunk, kinetic_rotation, rotation);
    add_to_account<Width>(chunk, step_correction, correction);
    add_to_account<Width>(chunk, pending_damping, books.damping);
    add_to_account<Width>(chunk, pending_contact, books.contact);
    add_to_account<Width>(chunk, pending_numerical, books.numerical);
    add_to_account<Width>(chunk, pending_grip, books.grip);
  });
}

template <template <class, int> class Form, class Real, int Width>
constexpr Kernel<Real> kernel() {
  return {advance<Form, Real, Width, false>, advance<Form, Real, Width, true>, weigh<Form, Real, Width>};
}

}  // namespace rift::ensemble::RIFT_INSTRUCTIONS
