#pragma once

#include "engine/base/interrupted.hpp"
#include "engine/lattice/forces.hpp"

namespace rift::lattice {

/// The limits of an explicit step on a lattice [s]; infinite where nothing can vibrate.
struct StableStep {
  double critical = 0;  // 2 / omega_max, by Lanczos iteration on the true lattice
  double element_bound =
      0;  // safe for certain: no lattice vibrates faster than its stiffest beam with its share of mass
};

/// 2 / omega_max of K x = omega^2 M x over the elements not gripped, all beams intact   [model.md §3].
/// Lanczos approaches omega_max from below; it goes on until 50 more rounds change it by less than 1e-5, and
/// the result keeps that margin. Cost about 200 force evaluations. Throws Interrupted.
/// @param[in] threads  0 for one per core; the bits do not depend on it
StableStep stable_step(const Lattice& lattice, const base::ProgressCallback& told = {}, int threads = 0);

/// The largest stable step with viscous damping [s]: dt = 2 / mu such that mu^2 = lambda_max(M^-1 (K + mu
/// C)), which is (2/omega)(sqrt(1 + zeta^2) - zeta) for a single mode   [model.md §3]. lambda_max is convex
/// in mu, so its chord from mu = 0 and a bound of its slope enclose mu; ends where they are 1e-5 apart, and
/// the result keeps that margin. Cost that of stable_step() with damping of some per mille of critical,
/// several times that with strong damping. Throws Interrupted.
/// @param[in] undamped  2 / omega_max [s];  @param[in] threads  0 for one per core
double damped_critical_step(const Lattice& lattice, const ViscousDamping& damping, double undamped,
                            const base::ProgressCallback& told = {}, int threads = 0);

}  // namespace rift::lattice
