#pragma once

#include "engine/ensemble/walk.hpp"

namespace rift::ensemble::RIFT_INSTRUCTIONS {

template <template <class, int> class Form>
inline constexpr bool is_linear = Form<double, 1>::numbers == 6;

template <int Width>
inline void add_to_account(double* chunk, Account which, Pack<double, Width> amount) {
  double* at = chunk + which * Width;
  store<Width>(at, load<Width>(at) + amount);
}

template <class Real, int Width>
inline double* chunk_of(const PartView<Real>& p, int i) {
  return p.account + static_cast<long>((i - p.begin) / chunk_size) * accounts * Width;
}

/// The position of an element in double, whatever the state is.
template <template <class, int> class Form, class Real, int Width>
inline void load_wide_position(const PartView<Real>& p, long row,
                               Pack<double, Width> (&c)[Form<double, Width>::numbers]) {
  constexpr int numbers = Form<double, Width>::numbers;
  for (int k = 0; k < numbers; ++k) {
    c[k] = widened<Real, Width>(load<Width>(p.q + (row * numbers + k) * Width));
    if constexpr (numbers == 6) c[k] += p.base[row * 6 + k];  // the linear form's strains are of all
  }
}
template <template <class, int> class Form, class Real, int Width>
inline typename Form<double, Width>::Position wide_position(const PartView<Real>& p, long row) {
  using D = Form<double, Width>;
  Pack<double, Width> c[D::numbers];
  load_wide_position<Form, Real, Width>(p, row, c);
  return D::position(c);
}

/// The position that an element would have after `dt` [s] at the velocity of this moment, in double.
template <template <class, int> class Form, class Real, int Width>
inline typename Form<double, Width>::Position moved_position(const PartView<Real>& p, long row, double dt) {
  using D = Form<double, Width>;
  Pack<double, Width> c[D::numbers], v[6];
  load_wide_position<Form, Real, Width>(p, row, c);
  load_row<6, Width>(p.velocity + row * 6 * Width, v);
  D::drift(c, v, splat<Pack<double, Width>>(dt));
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

/// Adds what beams that break by themselves have lost of the energies that come out of the walk and of
/// State::base_energy(): with the loads L of the base state q_0, (1 - s) L . (q + 1/2 q_0)   [J].
template <class Real, int Width>
inline void add_softened_base_energies(const BeamView<LinearBeam<Real>>& p) {
  using D = Pack<double, Width>;
  for (int b = 0; b < p.softened_beams; ++b) {
    const auto& row = p.damageable[p.softened[b]];
    if (row.extra_i < 0) continue;  // the other part's
    const auto moved = [&](long element, int c) {
      return 0.5 * p.base[element * 6 + c] +
             widened<Real, Width>(load<Width>(p.q + (element * 6 + c) * Width));
    };
    D work{};
    for (int c = 0; c < 3; ++c)
      work += static_cast<double>(row.base[c]) * (moved(row.i, c) - moved(row.j, c)) +
              static_cast<double>(row.base[3 + c]) * moved(row.i, 3 + c) +
              static_cast<double>(row.base[6 + c]) * moved(row.j, 3 + c);
    const D lost = 1.0 - widened<Real, Width>(load<Width>(p.factor + static_cast<long>(row.k) * Width));
    add_to_account<Width>(chunk_of<Real, Width>(p, row.i), elastic, lost * work);
  }
}

/// Energy of a corotational beam [J], and what it adds to the step correction: dt^2/8 F . F / m alone is that
/// of forces which change in proportion to the motion; the directions of these change too,
///   - 1/2 k e . 1/2 (e(q + dt v) + e(q - dt v) - 2 e(q)) = - dt^2/4 v . K_g v,
/// K_g the stiffness that a beam has by the forces in it   [model.md §7].
template <class D>
struct BeamEnergy {
  D elastic{}, correction{};
};

template <template <class, int> class Form, class Real, int Width>
inline BeamEnergy<Pack<double, Width>> energy_of(const PartView<Real>& p,
                                                 const typename Form<Real, 1>::Row& beam, long i, long j,
                                                 double dt) {
  using D = Form<double, Width>;
  const auto form = wide_form<Form, Real, Width>(beam);
  const auto strain_after = [&](double time) {
    return D::strain(form, moved_position<Form, Real, Width>(p, i, time),
                     moved_position<Form, Real, Width>(p, j, time));
  };
  const auto now =
      D::strain(form, wide_position<Form, Real, Width>(p, i), wide_position<Form, Real, Width>(p, j));
  const auto elastic = D::bilinear_energy(form, now, now);
  const auto around =
      D::bilinear_energy(form, now, strain_after(dt)) + D::bilinear_energy(form, now, strain_after(-dt));
  return {elastic, elastic - 0.5 * around};
}

/// Adds what corotational beams hold to the accounts of their first elements' chunks [J]: after the walk, by
/// the velocities of this moment.
template <template <class, int> class Form, class Real, int Width>
inline void add_corotational_energies(const ViewOf<Form, Real>& p, const StepConstants& k) {
  using D = Pack<double, Width>;
  const auto add = [&](int i, const BeamEnergy<D>& e) {
    add_to_account<Width>(chunk_of<Real, Width>(p, i), elastic, e.elastic);
    add_to_account<Width>(chunk_of<Real, Width>(p, i), step_correction, e.correction);
  };
  const auto* beam = p.intact + p.halo;
  for (int i = p.begin; i < p.end; ++i) {
    BeamEnergy<D> sum;
    for (int left = p.first[i - p.begin + 1] - p.first[i - p.begin]; left > 0; --left, ++beam) {
      const BeamEnergy<D> e = energy_of<Form, Real, Width>(p, beam->form, i, beam->j, k.dt);
      sum.elastic += e.elastic, sum.correction += e.correction;
    }
    add(i, sum);
  }
  for (int b = 0; b < p.damageable_beams; ++b) {
    const auto& row = p.damageable[b];
    if (row.extra_i < 0) continue;  // the other part's
    const D left = widened<Real, Width>(load<Width>(p.factor + static_cast<long>(row.k) * Width));
    const BeamEnergy<D> e = energy_of<Form, Real, Width>(p, row.form, row.i, row.j, k.dt);
    add(row.i, {left * e.elastic, left * e.correction});
  }
}

/// Adds the elastic energy of damageable linear beams to the accounts of their first elements' chunks [J].
/// That of the intact ones comes out of the walk, but for what is the same for all (State::base_energy()):
/// their work against the base state's forces, which all beams balance, is that of the damageable ones with
/// the opposite sign.
template <template <class, int> class Form, class Real, int Width, bool Breaking>
inline void add_damageable_energies(const ViewOf<Form, Real>& p) {
  if constexpr (Breaking) {
    add_softened_base_energies<Real, Width>(p);
    return;
  }
  using D = Pack<double, Width>;
  for (int b = 0; b < p.damageable_beams; ++b) {
    const auto& row = p.damageable[b];
    if (row.extra_i < 0) continue;  // the other part's
    D sum = widened<Real, Width>(load<Width>(p.factor + static_cast<long>(row.k) * Width)) *
            wide_energy<Form, Real, Width>(p, row.form, row.i, row.j);
    const auto moved = [&](long element, int c) {
      return widened<Real, Width>(load<Width>(p.q + (element * 6 + c) * Width));
    };
    for (int c = 0; c < 3; ++c)
      sum += static_cast<double>(row.base[c]) * (moved(row.i, c) - moved(row.j, c)) +
             static_cast<double>(row.base[3 + c]) * moved(row.i, 3 + c) +
             static_cast<double>(row.base[6 + c]) * moved(row.j, 3 + c);
    add_to_account<Width>(chunk_of<Real, Width>(p, row.i), elastic, sum);
  }
}

/// Which accounts a step keeps: none, those of the step, or those and all energies of the moment before it.
enum class Balance { none, of_step, of_moment };

/// Energies of the elements of a chunk [J]. What an element has is summed in the precision of the state, over
/// the elements in double: the accounts of a step then cost a tenth of it.   [model.md §7]
template <class Real, int Width>
struct ChunkEnergies {
  using V = Pack<Real, Width>;
  using D = Pack<double, Width>;
  D elastic{}, translation{}, rotation{}, correction{};  // of this moment
  D damping{}, contact{}, numerical{}, pull{};           // of the step that ends; force on the moving grip

  /// Of an element that moves at `rate` with the forces now and before: viscous damping and the faces'
  /// contact take - 1/2 (F_n + F_{n+1}) . dq, in units of - dt / 2.
  static D work(const V (&now)[6], const Real* before, const V (&rate)[6]) {
    V sum{};
    for (int c = 0; c < 6; ++c) sum = fma(now[c] + load<Width>(before + c * Width), rate[c], sum);
    return widened<Real, Width>(sum);
  }

  /// What numerical damping takes: 1/2 M (v^2 at beta = 1 - v^2 at beta).
  void add_numerical(const PartView<Real>& p, const StepConstants& k, int i, const V (&f)[6], const V (&v)[6],
                     const V (&rate)[6]) {
    for (int c = 0; c < 6; ++c) {
      if (p.per_mass[6L * i + c] == 0) continue;  // a grip or a roller holds it
      const D kick = 0.5 * k.dt * static_cast<double>(p.per_mass[6L * i + c]) * widened<Real, Width>(f[c]);
      const D conserved = widened<Real, Width>(rate[c]) + kick;
      const D now = widened<Real, Width>(v[c]) + k.beta_before * kick;
      numerical += 0.5 * p.mass[2L * i + c / 3] * (conserved * conserved - now * now);
    }
  }

  /// Kinetic energies at the velocity v of this moment, and the step correction C of all forces f.
  void add_moment(const PartView<Real>& p, const StepConstants& k, int i, const V (&f)[6], const V (&v)[6]) {
    for (const int c : {0, 3}) {
      const Real* at = p.per_mass + 6L * i + c;
      const Real of_two = at[0] != 0 ? at[0] : at[1];  // a component that is held counts for nothing
      const Real largest = of_two != 0 ? of_two : at[2];
      if (largest == 0) continue;
      const double per_mass = static_cast<double>(largest);
      const auto moved = [&](int d) { return at[d] == 0 ? V{} : f[c + d]; };
      const V vv = fma(v[c + 2], v[c + 2], fma(v[c + 1], v[c + 1], v[c] * v[c]));
      const V ff = fma(moved(2), moved(2), fma(moved(1), moved(1), moved(0) * moved(0)));
      (c == 0 ? translation : rotation) += 0.5 * p.mass[2L * i + c / 3] * widened<Real, Width>(vv);
      correction += 0.125 * k.dt * k.dt * per_mass * widened<Real, Width>(ff);
    }
  }

  /// Closes the accounts of a chunk, whose next elements begin anew.
  template <Balance balance>
  void close(double* chunk, const StepConstants& k) {
    const bool spent = balance == Balance::of_step;
    const auto put = [&](Account which, D amount) { add_to_account<Width>(chunk, which, amount); };
    put(spent ? spent_damping : pending_damping, -0.5 * k.dt * damping);
    put(spent ? spent_contact : pending_contact, -0.5 * k.dt * contact);
    put(spent ? spent_numerical : pending_numerical, numerical);
    put(spent ? spent_grip : coming_grip, -0.5 * ((k.grip_before + k.grip_after) * k.dt) * pull);
    if constexpr (balance == Balance::of_moment) {
      put(pending_grip, -0.5 * (k.grip_before * k.dt) * pull);
      put(Account::elastic, -0.5 * elastic);
      put(kinetic_translation, translation);
      put(kinetic_rotation, rotation);
      put(step_correction, correction);
    }
    *this = {};
  }
};

/// The mean of each element's positions a step before and a step after this moment: its position now and half
/// of dt^2 times its acceleration, of the forces that this moment's directions give. Dampers, which are weak
/// beside the beams, are left out of it.
/// @param[out] p  mean_q [m, rad] of the elements
template <template <class, int> class Form, class Real, int Width>
[[gnu::flatten]] void find_means(const ViewOf<Form, Real>& p, const StepConstants& k) {
  using F = Form<Real, Width>;
  using V = Pack<Real, Width>;
  const V one = splat<V>(Real(1)), half_square = splat<V>(static_cast<Real>(0.5 * k.dt * k.dt));
  walk<Form, Real, Width, false, Directions::of_moment, false>(
      p, [&](int i, V(&f)[6], int extra, int, V(&)[6]) {
        V q[F::numbers], bend[6];
        load_row<F::numbers, Width>(p.q + static_cast<long>(F::numbers) * Width * i, q);
        for (int c = 0; c < 6; ++c) {
          if (extra >= 0) f[c] += load<Width>(p.extra + (6L * extra + c) * Width);
          if (extra >= 0 && p.contact) f[c] += load<Width>(p.contact + (6L * extra + c) * Width);
          bend[c] = half_square * splat<V>(p.per_mass[6L * i + c]) * f[c];
        }
        F::drift(q, bend, one);
        store_row<F::numbers, Width>(p.mean_q + static_cast<long>(F::numbers) * Width * i, q);
      });
}

/// One step of Table 1 of the paper for the elements of a part. `v` holds the velocity after the first half
/// of the step that ends; with beta = 1 that is the rate (q_n - q_{n-1}) / dt.
///
/// Energies of the moment are evaluated on the way, since a step needs the forces of this moment in any case:
/// in linear kinematics the elastic energy of the change is - 1/2 sum f . q. Such a step leaves the state as
/// it is and writes the next one beside it, for the step that comes to take up.
///
/// Flattened: every function below is inlined whatever its size. What GCC left as calls (a beam's loads, four
/// positions) passed its numbers through the stack; one scenario in double is 1.28 times as fast without.
/// @param[in,out] p  q [m, rad] and v [m/s, rad/s] of the elements, and their accounts [J]
template <template <class, int> class Form, class Real, int Width, Balance balance, bool Breaking>
[[gnu::flatten]] void advance(const ViewOf<Form, Real>& p, const StepConstants& k) {
  using F = Form<Real, Width>;
  using V = Pack<Real, Width>;
  constexpr bool balanced = balance != Balance::none, of_moment = balance == Balance::of_moment;
  constexpr Directions directions = is_linear<Form> ? Directions::of_moment : Directions::of_mean;
  const V dt = splat<V>(static_cast<Real>(k.dt)), kick = splat<V>(static_cast<Real>(0.5 * k.dt)),
          ended = splat<V>(static_cast<Real>(0.5 * k.dt * k.beta_before)),
          begun = splat<V>(static_cast<Real>(0.5 * k.dt * k.beta_after));
  if constexpr (of_moment) {
    for (int i = p.begin; i < p.end; i += chunk_size)
      clear(chunk_of<Real, Width>(p, i), spent_damping * Width);
    if constexpr (is_linear<Form>) add_damageable_energies<Form, Real, Width, Breaking>(p);
    if (p.contact) add_contact_energies<Form, Real, Width>(p);
  }
  ChunkEnergies<Real, Width> energies;
  // f: balance of forces at q_n, eqs. (3)-(6); d: of it, that of the dampers, eq. (8)
  walk<Form, Real, Width, balanced, directions, Breaking>(
      p, [&](int i, V(&f)[6], int extra, int damped, V(&d)[6]) {
        V q[F::numbers], v[6], rate[6];
        load_row<F::numbers, Width>(p.q + static_cast<long>(F::numbers) * Width * i, q);
        load_row<6, Width>(p.v + 6L * Width * i, v);
        if constexpr (of_moment && is_linear<Form>) {
          V work{};
          for (int c = 0; c < 6; ++c) work = fma(f[c], q[c], work);
          energies.elastic += widened<Real, Width>(work);
        }
        const auto add = [&](const Real* rows, V(&to)[6]) {
          for (int c = 0; c < 6; ++c) to[c] += load<Width>(rows + (6L * extra + c) * Width);
        };
        if (extra >= 0) add(p.extra, f);
        const bool with_accounts = balanced && (!of_moment || k.balanced);
        if (with_accounts) {
          rates_at<Width>(p, i, rate);
          if (p.top[i])
            rate[1] = splat<V>(static_cast<Real>(k.grip_before));  // v is that of the step that begins
          if (extra >= 0 && p.contact) {
            V contact[6];
            const long at = 6L * Width * extra;
            load_row<6, Width>(p.contact + at, contact);
            energies.contact += energies.work(contact, p.contact_before + at, rate);
            store_row<6, Width>(p.next_contact_before + at, contact);
            for (int c = 0; c < 6; ++c) f[c] += contact[c];
          }
          if (damped >= 0) {
            if (extra >= 0) add(p.damping, d);
            const long at = 6L * Width * damped;
            energies.damping += energies.work(d, p.damping_before + at, rate);
            store_row<6, Width>(p.next_damping_before + at, d);
            for (int c = 0; c < 6; ++c) f[c] += d[c];
          }
          if (p.rate) energies.add_numerical(p, k, i, f, v, rate);
          if (p.top[i]) energies.pull += widened<Real, Width>(f[1]);
        }
        V per_mass[6];
        for (int c = 0; c < 6; ++c) per_mass[c] = splat<V>(p.per_mass[6L * i + c]);
        if constexpr (of_moment) {
          V now[6];
          for (int c = 0; c < 6; ++c) now[c] = fma(ended * per_mass[c], f[c], v[c]);
          if (p.velocity)
            for (int c = 0; c < 6; ++c)
              store<Width>(p.velocity + (6L * i + c) * Width, widened<Real, Width>(now[c]));
          energies.add_moment(p, k, i, f, now);
        }
        if (with_accounts) {
          for (int c = 0; c < 6; ++c) {
            const V a = per_mass[c] * f[c];  // Newton's law
            v[c] = fma(ended, a, v[c]);      // eq. (2), its second half
            rate[c] = fma(kick, a, v[c]);
            v[c] = fma(begun, a, v[c]);  // eq. (2), the first half of the next step
          }
          if (p.rate) store_row<6, Width>(p.next_rate + 6L * Width * i, rate);
        } else {
          for (int c = 0; c < 6; ++c)
            rate[c] = v[c] = fma(dt * per_mass[c], f[c], v[c]);  // both halves of eq. (2)
        }
        F::drift(q, rate, dt);  // eq. (1)
        store_row<F::numbers, Width>(p.next_q + static_cast<long>(F::numbers) * Width * i, q);
        store_row<6, Width>(p.next_v + 6L * Width * i, v);
        if (balanced && ((i + 1) % chunk_size == 0 || i + 1 == p.end))
          energies.template close<balance>(chunk_of<Real, Width>(p, i), k);
      });
}

template <template <class, int> class Form, class Real, int Width, bool Breaking>
constexpr Kernel<typename Form<Real, 1>::Row> kernel() {
  Kernel<typename Form<Real, 1>::Row> k{
      .advance = advance<Form, Real, Width, Balance::none, Breaking>,
      .advance_with_balance = advance<Form, Real, Width, Balance::of_step, Breaking>,
      .evaluate_energies = advance<Form, Real, Width, Balance::of_moment, Breaking>,
      .group_size = group_size<Form, Real>};
  if constexpr (!is_linear<Form>)
    k.find_means = find_means<Form, Real, Width>,
    k.add_beam_energies = add_corotational_energies<Form, Real, Width>;
  return k;
}

}  // namespace rift::ensemble::RIFT_INSTRUCTIONS
