#pragma once

#include "engine/ensemble/walk.hpp"

namespace rift::ensemble::RIFT_INSTRUCTIONS {

/// Adds an element's additional loads to its forces.
/// @param[in]     index  of the element among those with additional loads, or -1
/// @param[in,out] f      force [N] and moment [N m] of each lane
template <class Real, int Width>
inline void add_extra(const PartView<Real>& p, int index, Pack<Real, Width> (&f)[6]) {
  if (index < 0) return;
  for (int c = 0; c < 6; ++c) {
    const long at = (6L * index + c) * Width;
    f[c] = f[c] + load<Width>(p.extra + at);
    if (p.contact) f[c] = f[c] + load<Width>(p.contact + at);
    if (p.damping) f[c] = f[c] + load<Width>(p.damping + at);
  }
}

/// The energies that a step takes of one element or gives to it [J], in double   [model.md §7]: viscous
/// damping and the faces' contact take - 1/2 (F_n + F_{n+1}) . dq, numerical damping takes 1/2 M (v^2 at beta
/// = 1 - v^2 at beta), the moving grip gives - 1/2 F . dq.
template <class Real, int Width>
struct StepEnergies {
  using D = Pack<double, Width>;
  D damping{}, contact{}, numerical{}, grip{};

  /// @param[in] i, index    the element, and its index among those with additional loads, or -1
  /// @param[in] f           its force [N] and moment [N m]
  /// @param[in] grip_moved  distance by which the top grip has moved, of two steps that share f [m]
  void add(const PartView<Real>& p, const StepConstants& k, int i, int index, const Pack<Real, Width> (&f)[6],
           double grip_moved) {
    const Real* rates = (p.rate ? p.rate : p.v) + 6L * Width * i;
    // The grip's velocity is that of the step that begins already.
    const auto rate = [&](int c) {
      return p.top[i] && c == 1 ? splat<D>(k.grip_before)
                                : widened<Real, Width>(load<Width>(rates + c * Width));
    };
    const auto taken_by = [&](const Real* force, const Real* before, D& taken) {
      if (!force || index < 0) return;
      for (int c = 0; c < 6; ++c) {
        const long at = (6L * index + c) * Width;
        const D both =
            widened<Real, Width>(load<Width>(force + at)) + widened<Real, Width>(load<Width>(before + at));
        taken -= 0.5 * k.dt * both * rate(c);
      }
    };
    taken_by(p.damping, p.damping_before, damping);
    taken_by(p.contact, p.contact_before, contact);
    if (p.rate && p.per_mass[2L * i] != 0)
      for (int c = 0; c < 6; ++c) {
        const D kick =
            0.5 * k.dt * static_cast<double>(p.per_mass[2L * i + c / 3]) * widened<Real, Width>(f[c]);
        const D conserved = widened<Real, Width>(load<Width>(rates + c * Width)) + kick;
        const D v = widened<Real, Width>(load<Width>(p.v + (6L * i + c) * Width)) + k.beta_before * kick;
        numerical += 0.5 * p.mass[2L * i + c / 3] * (conserved * conserved - v * v);
      }
    if (p.top[i]) grip -= 0.5 * grip_moved * widened<Real, Width>(f[1]);
  }
};

template <int Width>
inline void add_to_account(double* chunk, Account which, Pack<double, Width> amount) {
  double* at = chunk + which * Width;
  store<Width>(at, load<Width>(at) + amount);
}

template <class Real, int Width>
inline double* chunk_of(const PartView<Real>& p, int i) {
  return p.account + static_cast<long>((i - p.begin) / chunk_size) * accounts * Width;
}

/// One step of Table 1 of the paper for the elements of a part. `v` holds the velocity after the first half
/// of the step that ends; with beta = 1 that is the rate (q_n - q_{n-1}) / dt.
/// Flattened: every function below is inlined whatever its size. What GCC left as calls (a beam's loads, four
/// positions) passed its numbers through the stack; one scenario in double is 1.28 times as fast without.
/// @tparam Balanced  with the energy balance of every step
/// @param[in,out] p  q [m, rad] and v [m/s, rad/s] of the elements, and their accounts [J]
template <template <class, int> class Form, class Real, int Width, bool Balanced>
[[gnu::flatten]] void advance(const ViewOf<Form, Real>& p, const StepConstants& k) {
  using F = Form<Real, Width>;
  using V = Pack<Real, Width>;
  const Real dt = static_cast<Real>(k.dt);
  const Real kick = static_cast<Real>(0.5 * k.dt);
  const Real both = Balanced ? static_cast<Real>(0.5 * k.dt * k.beta_before) : static_cast<Real>(k.dt);
  const Real begun = static_cast<Real>(0.5 * k.dt * k.beta_after);
  walk<Form, Real, Width>(p, [&](int i, V(&f)[6], int index) {  // f: balance of forces at q_n, eqs. (3)-(6)
    add_extra<Real, Width>(p, index, f);
    V q[F::numbers], v[6], rate[6];
    Real* at_q = p.q + static_cast<long>(F::numbers) * Width * i;
    Real* at_v = p.v + 6L * Width * i;
    load_row<F::numbers, Width>(at_q, q);
    load_row<6, Width>(at_v, v);
    const V per_mass[2] = {splat<V>(p.per_mass[2L * i]), splat<V>(p.per_mass[2L * i + 1])};
    if constexpr (Balanced) {
      StepEnergies<Real, Width> energies;
      energies.add(p, k, i, index, f, (k.grip_before + k.grip_after) * k.dt);
      double* chunk = chunk_of<Real, Width>(p, i);
      add_to_account<Width>(chunk, spent_damping, energies.damping);
      add_to_account<Width>(chunk, spent_contact, energies.contact);
      add_to_account<Width>(chunk, spent_numerical, energies.numerical);
      add_to_account<Width>(chunk, spent_grip, energies.grip);
      const auto keep = [&](const Real* force, Real* before) {
        if (!force || index < 0) return;
        for (long at = 6L * index * Width; at < 6L * (index + 1) * Width; ++at) before[at] = force[at];
      };
      keep(p.damping, p.damping_before);
      keep(p.contact, p.contact_before);
      for (int c = 0; c < 6; ++c) {
        const V a = per_mass[c / 3] * f[c];   // Newton's law
        v[c] = fma(splat<V>(both), a, v[c]);  // eq. (2), its second half
        rate[c] = fma(splat<V>(kick), a, v[c]);
        v[c] = fma(splat<V>(begun), a, v[c]);  // eq. (2), the first half of the next step
      }
      if (p.rate) store_row<6, Width>(p.rate + 6L * Width * i, rate);
    } else {
      for (int c = 0; c < 6; ++c)
        rate[c] = v[c] = fma(both * per_mass[c / 3], f[c], v[c]);  // both halves of eq. (2)
    }
    F::drift(q, rate, splat<V>(dt));  // eq. (1)
    store_row<F::numbers, Width>(at_q, q);
    store_row<6, Width>(at_v, v);
  });
}

/// The position of an element in double, whatever the state is.
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
  constexpr int numbers = beam_numbers<typename Form<Real, 1>::Row>;
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

/// Adds the energy that the faces hold to the accounts [J].
template <template <class, int> class Form, class Real, int Width>
inline void add_contact_energies(const ViewOf<Form, Real>& p) {
  using D = Form<double, Width>;
  using V = Pack<double, Width>;
  const auto wide = [](const Real* at) { return widened<Real, Width>(load<Width>(at)); };
  for (int b = 0; b < p.contacts; ++b) {
    const auto& row = p.contact_row[b];
    if (row.extra_i < 0) continue;  // the other part's
    const V parted = wide(p.in_contact) * (1.0 - wide(p.factor + static_cast<long>(row.k) * Width));
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

/// Adds the elastic energy of the beams to the accounts of their first elements' chunks [J].
template <template <class, int> class Form, class Real, int Width>
inline void add_beam_energies(const ViewOf<Form, Real>& p) {
  const auto* beam = p.intact + p.halo;
  for (int i = p.begin; i < p.end; ++i) {
    Pack<double, Width> sum{};
    for (int left = p.first[i - p.begin + 1] - p.first[i - p.begin]; left > 0; --left, ++beam)
      sum += wide_energy<Form, Real, Width>(p, beam->form, i, beam->j);
    add_to_account<Width>(chunk_of<Real, Width>(p, i), elastic, sum);
  }
  for (int b = 0; b < p.damageable_beams; ++b) {
    const auto& row = p.damageable[b];
    if (row.extra_i < 0) continue;  // the other part's
    const auto s = widened<Real, Width>(load<Width>(p.factor + static_cast<long>(row.k) * Width));
    add_to_account<Width>(chunk_of<Real, Width>(p, row.i), elastic,
                          s * wide_energy<Form, Real, Width>(p, row.form, row.i, row.j));
  }
}

/// Evaluates the energies at q_n and v_n, and those that the step that ends has yet to take; all to the
/// accounts [J].
template <template <class, int> class Form, class Real, int Width>
[[gnu::flatten]] void evaluate_energies(const ViewOf<Form, Real>& p, const StepConstants& k) {
  using V = Pack<Real, Width>;
  using D = Pack<double, Width>;
  for (int i = p.begin; i < p.end; i += chunk_size) clear(chunk_of<Real, Width>(p, i), spent_damping * Width);
  add_beam_energies<Form, Real, Width>(p);
  if (p.contact) add_contact_energies<Form, Real, Width>(p);
  walk<Form, Real, Width>(p, [&](int i, V(&f)[6], int index) {
    add_extra<Real, Width>(p, index, f);
    StepEnergies<Real, Width> energies;
    energies.add(p, k, i, index, f, k.grip_before * k.dt);
    D translation{}, rotation{}, correction{};
    for (int c = 0; c < 6; ++c) {
      const D force = widened<Real, Width>(f[c]);
      const double per_mass = static_cast<double>(p.per_mass[2L * i + c / 3]), m = p.mass[2L * i + c / 3];
      const D v = widened<Real, Width>(load<Width>(p.v + (6L * i + c) * Width)) +
                  0.5 * k.dt * k.beta_before * per_mass * force;
      if (p.velocity) store<Width>(p.velocity + (6L * i + c) * Width, v);
      if (per_mass == 0.0) continue;
      (c < 3 ? translation : rotation) += 0.5 * m * v * v;
      correction += 0.125 * k.dt * k.dt * per_mass * force * force;
    }
    double* chunk = chunk_of<Real, Width>(p, i);
    add_to_account<Width>(chunk, kinetic_translation, translation);
    add_to_account<Width>(chunk, kinetic_rotation, rotation);
    add_to_account<Width>(chunk, step_correction, correction);
    add_to_account<Width>(chunk, pending_damping, energies.damping);
    add_to_account<Width>(chunk, pending_contact, energies.contact);
    add_to_account<Width>(chunk, pending_numerical, energies.numerical);
    add_to_account<Width>(chunk, pending_grip, energies.grip);
  });
}

template <template <class, int> class Form, class Real, int Width>
constexpr Kernel<typename Form<Real, 1>::Row> kernel() {
  return {advance<Form, Real, Width, false>, advance<Form, Real, Width, true>,
          evaluate_energies<Form, Real, Width>};
}

}  // namespace rift::ensemble::RIFT_INSTRUCTIONS
