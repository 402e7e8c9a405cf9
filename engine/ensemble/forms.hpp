#pragma once

#include "engine/ensemble/pack.hpp"
#include "engine/ensemble/part.hpp"

namespace rift::ensemble::RIFT_INSTRUCTIONS {

/// What a beam does to its two elements: force on i (minus that on j), moment on i, moment on j.
template <class V>
struct EndLoads {
  Space<V> force, moment_i, moment_j;
};

/// How far the halves of a beam are apart in its middle, where that is from either end, and the stiffness of
/// faces there   [fracture/face_contact.hpp].
template <class V>
struct FaceGap {
  Space<V> gap, arm_i, arm_j;
  V stiffness;
};

/// Linear kinematics: axes fixed   [model.md §2; paper eqs. (3)-(6)]. Written in the sum and the difference
/// of the rotations, with d = u_j - u_i, across the axis:
///   S = 3/2 w (theta_i + theta_j - (2/l) n x d),   D = w/2 (theta_j - theta_i),   twist t = n.(theta_j -
///   theta_i) F_i = k_a (n.d) n - (2/l) S x n,   M_i = D - S + k_t t n,   M_j = - D - S - k_t t n
template <class Real, int Width>
struct Linear {
  using V = Pack<Real, Width>;
  using Row = LinearBeam<Real>;
  static constexpr int numbers = Row::position_numbers;

  /// Displacement and rotation of an element, from the base state.
  struct Position {
    Space<V> u, theta;
  };
  static Position position(const V* c) { return {{c[0], c[1], c[2]}, {c[3], c[4], c[5]}}; }

  struct Form {
    Space<V> n;
    V c, axial, bending, twist;
  };
  static Form form(const Row& b) {
    return {{splat<V>(b.nx), splat<V>(b.ny), splat<V>(b.nz)},
            splat<V>(b.two_per_length),
            splat<V>(b.stiffness.axial),
            splat<V>(b.stiffness.bending),
            splat<V>(b.stiffness.twist)};
  }
  static Form form(const V* p) { return {{p[0], p[1], p[2]}, p[3], p[4], p[5], p[6]}; }
  static Space<V> initial_axis(const Form& b) { return b.n; }

  /// What is left of a beam where all its stiffnesses are multiplied by `s`.
  static Form softened(Form b, V s) {
    b.axial *= s, b.bending *= s, b.twist *= s;
    return b;
  }

  /// theta_i + theta_j - (2/l) n x d across the axis, which is alpha_i + alpha_j
  static Space<V> bend(const Form& b, const Space<V>& d, const Space<V>& sum) {
    const Space<V> s = plus(sum, -b.c, cross(b.n, d));
    return plus(s, -dot(b.n, sum), b.n);
  }

  static EndLoads<V> loads(const Form& b, const Position& i, const Position& j) {
    const Space<V> d = j.u - i.u, sum = i.theta + j.theta, difference = j.theta - i.theta;
    const V t = dot(b.n, difference);
    const Space<V> s = bend(b, d, sum);
    const V half = V{} + Real(0.5) * b.bending;
    const Space<V> S = (Real(3) * half) * s;
    const Space<V> D = plus(half * difference, (b.twist - half) * t, b.n);
    const Space<V> pull = (b.axial * dot(b.n, d)) * b.n;
    return {plus(pull, -b.c, cross(S, b.n)), D - S, Space<V>{} - (D + S)};
  }

  /// U = 1/2 k_a (n.d)^2 + 1/2 k_t t^2 + w (3/4 s^2 + 1/4 (theta_j - theta_i)^2), both across the axis
  static V energy(const Form& b, const Position& i, const Position& j) {
    const Space<V> d = j.u - i.u, sum = i.theta + j.theta, difference = j.theta - i.theta;
    const V stretch = dot(b.n, d), t = dot(b.n, difference);
    const Space<V> s = bend(b, d, sum);
    const V bent = Real(0.75) * dot(s, s) + Real(0.25) * (dot(difference, difference) - t * t);
    return Real(0.5) * b.axial * stretch * stretch + Real(0.5) * b.twist * t * t + b.bending * bent;
  }

  static FaceGap<V> face_gap(const Form& b, const Position& i, const Position& j) {
    const V half = Real(1) / b.c;
    const Space<V> arm = half * b.n;
    return {(j.u - i.u) - cross(i.theta + j.theta, arm), arm, arm, Real(1.5) * b.bending * b.c * b.c};
  }

  /// q(t + dt) = q + dt q'   [eq. (1); q' at the middle of the step]
  static void drift(V* q, const V* rate, V dt) {
    for (int c = 0; c < 6; ++c) q[c] = fma(dt, rate[c], q[c]);
  }
};

/// Corotational kinematics in directors: t = R n_0 is the beam's initial axis carried along by an element of
/// rotation R (a unit quaternion a, b), n the present axis, p = b a* the relative rotation   [model.md §2]:
///   alpha = n x t,   twist = 2 n.p,   U = 1/2 k_a (|D| - l)^2 + 1/2 k_t twist^2 + w (a_i^2 + a_i.a_j +
///   a_j^2)
/// and exact gradients of it: with g_i = w (2 alpha_i + alpha_j), g_j likewise,
///   M_i = - t_i x (g_i x n) + k_t twist (p_0 n - p x n),   M_j = - t_j x (g_j x n) - k_t twist (p_0 n + p x
///   n) h = t_i x g_i + t_j x g_j + 2 k_t twist p,   F_i = k_a (|D| - l) n + (h - n (n.h)) / |D|
template <class Real, int Width>
struct Corotational {
  using V = Pack<Real, Width>;
  using Row = CorotationalBeam<Real>;
  static constexpr int numbers = Row::position_numbers;

  /// Displacement from the base state; rotation from the unloaded one, as a unit quaternion.
  struct Position {
    Space<V> u;
    V scalar;
    Space<V> vector;
  };
  static Position position(const V* c) { return {{c[0], c[1], c[2]}, c[3], {c[4], c[5], c[6]}}; }
  /// The position of this moment, and the mean of those a step before and a step after.
  struct Positions {
    Position now, mean;
  };

  struct Form {
    Space<V> n0;
    V length;
    Space<V> base;
    V axial, bending, twist;
  };
  static Form form(const Row& b) {
    return {{splat<V>(b.nx), splat<V>(b.ny), splat<V>(b.nz)},
            splat<V>(b.length),
            {splat<V>(b.base_x), splat<V>(b.base_y), splat<V>(b.base_z)},
            splat<V>(b.stiffness.axial),
            splat<V>(b.stiffness.bending),
            splat<V>(b.stiffness.twist)};
  }
  static Form form(const V* p) { return {{p[0], p[1], p[2]}, p[3], {p[4], p[5], p[6]}, p[7], p[8], p[9]}; }
  static Space<V> initial_axis(const Form& b) { return b.n0; }

  struct Strain {
    Space<V> n, t_i, t_j, alpha_i, alpha_j, p;
    V p0, per_length, stretch, twist;
  };

  /// R n_0 - n_0, small and kept so: 2 q_0 (v x n_0) + 2 v x (v x n_0)
  static Space<V> turned(const Position& a, const Space<V>& n0) {
    const Space<V> x = cross(a.vector, n0);
    const Space<V> y = plus_cross(a.scalar * x, a.vector, x);
    return y + y;
  }

  static Strain strain(const Form& b, const Position& i, const Position& j) {
    const Space<V> du = b.base + (j.u - i.u);
    const Space<V> D = plus(du, b.length, b.n0);
    const V growth = dot(du, D + b.length * b.n0);  // |D|^2 - l^2
    const V now = root(fma(b.length, b.length, growth));
    Strain e;
    e.per_length = (V{} + Real(1)) / now;
    e.stretch = growth / (now + b.length);
    e.n = e.per_length * D;
    const Space<V> ti = turned(i, b.n0), tj = turned(j, b.n0);
    const Space<V> chord = e.per_length * cross(du, b.n0);  // n x n_0
    e.alpha_i = plus_cross(chord, e.n, ti);
    e.alpha_j = plus_cross(chord, e.n, tj);
    e.t_i = b.n0 + ti;
    e.t_j = b.n0 + tj;
    e.p0 = fma(i.scalar, j.scalar, dot(i.vector, j.vector));
    e.p = plus_cross(plus(i.scalar * j.vector, -j.scalar, i.vector), i.vector, j.vector);
    const V half_twist = dot(e.n, e.p);
    e.twist = half_twist + half_twist;
    return e;
  }

  static EndLoads<V> loads(const Form& b, const Position& i, const Position& j) {
    const Strain e = strain(b, i, j);
    return loads_along(b, e, e);
  }

  /// - k e . de/dq with the strains e of this moment and their derivatives at the mean of the positions a
  /// step before and a step after. Over these two steps the derivative there gives the change of the strains
  /// to third order, so that velocity Verlet keeps 1/2 M v^2 + 1/2 k e_n . e_(n+1), the energy by which
  /// damage is counted [model.md §3].
  static EndLoads<V> loads(const Form& b, const Positions& i, const Positions& j) {
    return loads_along(b, strain(b, i.now, j.now), strain(b, i.mean, j.mean));
  }

  /// Forces of the strains `e` in the directions of `d`.
  static EndLoads<V> loads_along(const Form& b, const Strain& e, const Strain& d) {
    const Space<V> sum = e.alpha_i + e.alpha_j;
    const Space<V> gi = b.bending * (sum + e.alpha_i), gj = b.bending * (sum + e.alpha_j);
    const V torque = b.twist * e.twist;
    const Space<V> across = torque * cross(d.p, d.n), along = (torque * d.p0) * d.n;
    const Space<V> mi = cross(d.t_i, cross(gi, d.n)), mj = cross(d.t_j, cross(gj, d.n));
    const Space<V> h = plus_cross(plus_cross((torque + torque) * d.p, d.t_i, gi), d.t_j, gj);
    const Space<V> shear = d.per_length * plus(h, -dot(d.n, h), d.n);
    return {plus(shear, b.axial * e.stretch, d.n), (along - across) - mi,
            Space<V>{} - ((along + across) + mj)};
  }

  static V energy(const Form& b, const Position& i, const Position& j) {
    const Strain e = strain(b, i, j);
    return bilinear_energy(b, e, e);
  }

  /// 1/2 a . k b: the energy where a = b, as bilinear_energy() of lattice/beam.hpp.
  static V bilinear_energy(const Form& b, const Strain& x, const Strain& y) {
    const V bend = dot(x.alpha_i, y.alpha_i) + dot(x.alpha_j, y.alpha_j) +
                   0.5 * (dot(x.alpha_i, y.alpha_j) + dot(x.alpha_j, y.alpha_i));
    return 0.5 * b.axial * x.stretch * y.stretch + 0.5 * b.twist * x.twist * y.twist + b.bending * bend;
  }

  static FaceGap<V> face_gap(const Form& b, const Position& i, const Position& j) {
    const V half = Real(0.5) * b.length;
    const Space<V> ti = turned(i, b.n0), tj = turned(j, b.n0);
    return {plus(b.base + (j.u - i.u), -half, ti + tj), half * (b.n0 + ti), half * (b.n0 + tj),
            Real(6) * b.bending / (b.length * b.length)};
  }

  /// Displacements as in linear kinematics; the rotation by dt omega about omega, as (1, dt omega / 2)
  /// normalised: reversible in time, of second order   [eqs. (1), (2) for quaternions].
  static void drift(V* q, const V* rate, V dt) {
    for (int c = 0; c < 3; ++c) q[c] = fma(dt, rate[c], q[c]);
    const V half = Real(0.5) * dt;
    const Space<V> w{half * rate[3], half * rate[4], half * rate[5]}, v{q[4], q[5], q[6]};
    const V scalar = q[3] - dot(w, v);
    const Space<V> vector = plus_cross(plus(v, q[3], w), w, v);
    const V square = fma(scalar, scalar, dot(vector, vector));
    const V shorten = fma(V{} - Real(0.5), square, V{} + Real(1.5));  // 1 / |.|, one Newton step from 1
    q[3] = shorten * scalar;
    q[4] = shorten * vector.x, q[5] = shorten * vector.y, q[6] = shorten * vector.z;
  }
};

}  // namespace rift::ensemble::RIFT_INSTRUCTIONS
