#pragma once

#include "engine/scene/scene.hpp"

namespace rift {

/// Beam-steps that a scenario takes: elements x 3 x steps, with a critical step of 0.63 R / c_r (measured on
/// the quickstart plate). An estimate that needs no lattice, for bars and for asking before a long study.
double estimated_beam_steps(const Scene& scene);

/// The same for packing and pre-stress, in beam-steps that take as long.
double estimated_preparation(const Scene& scene);

}  // namespace rift
