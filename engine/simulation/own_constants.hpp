#pragma once

#include "engine/base/cache.hpp"
#include "engine/base/interrupted.hpp"
#include "engine/lattice/lattice.hpp"

#include <limits>
#include <optional>

namespace rift::simulation {

struct Prepared;

/// What the specimen shows of itself when it is pulled; its preset names the material's, from which a packing
/// of some thousand elements differs by some per cent.
struct OwnConstants {
  static constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
  double young_along = undefined, poisson_along = undefined;    // E [Pa], nu in the plane, pulled along x
  double young_across = undefined, poisson_across = undefined;  // along y
  double between_grips = undefined;                             // [m]

  /// Those of an isotropic plate that is as stiff as the specimen is along and across on average.
  double young_modulus() const { return 0.5 * (young_along + young_across); }
  double poisson_ratio() const { return 0.5 * (poisson_along + poisson_across); }
};

/// Distance of the mean centres of the two grips' elements along y [m]: what of the height is strained. The
/// elements are held at their centres, so that it is about two mean radii less than the height.
double between_grips(const lattice::Lattice& lattice);

/// The specimen that hangs together, not gripped, with the beams of `micro` in place of the lattice's.
lattice::Lattice free_plate(const Prepared& prepared, const lattice::MicroMaterial& micro, base::Cache& cache,
                            const base::ProgressCallback& told = {});

/// Measures the lattice's plate by two static pulls of its free body, or recalls them from the cache. The
/// beams are the lattice's; E goes with their modulus, as lanes in units of their own have it.
/// Throws StaticsError, Interrupted, PackingError where an end holds fewer than three elements.
OwnConstants own_constants(const Prepared& prepared, base::Cache& cache,
                           const base::ProgressCallback& told = {}, int threads = 0);

/// The same where the cache holds it; nothing is computed.
std::optional<OwnConstants> known_constants(const Prepared& prepared, base::Cache& cache);

}  // namespace rift::simulation
