#pragma once

#include "engine/base/cache.hpp"
#include "engine/simulation/prepare.hpp"

namespace rift::simulation {

/// Micro modulus, pre-stress and G_I0. The modulus and G_I0 belong to the strip without its notch; the
/// modulus is that of small strains with either kinematics.
/// Asks for the specimen, the density and the path. Throws InputError where no beams fit the material,
/// StaticsError.
void build_prestress(Prepared& p, base::Cache& cache, const StageProgress& progress);

/// What the clamped strip of a continuum with the preset's E and nu would show [Pa].
double continuum_strip_modulus(const scene::Scene& scene);

}  // namespace rift::simulation
