#pragma once

#include "engine/stability/suite.hpp"

/// The families of the suite, each adding its cases.
namespace rift::stability {

using Cases = std::vector<StabilityCase>;

void add_free_vibration(Cases& cases, const SuiteOptions& options);  // step, beta, drift
void add_small_lattices(Cases& cases);                       // one beam, chain, cut in two, rattlers only
void add_paths(Cases& cases);                                // along a row of beams, leaving, crossing itself
void add_forced_steps(Cases& cases);                         // refused at the limit, caught beyond it
void add_beams(Cases& cases);                                // E_mu, nu_mu, r_mu, density, an inclusion
void add_packings(Cases& cases);                             // ratio of the radii
void add_damping(Cases& cases);                              // alpha and its shrunken limit
void add_cracks(Cases& cases, const SuiteOptions& options);  // damage zone, velocity, pre-strain

}  // namespace rift::stability
