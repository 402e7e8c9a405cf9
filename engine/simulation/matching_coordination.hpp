#pragma once

#include "engine/simulation/prepare.hpp"

#include <span>

namespace rift::simulation {

/// The coordination of a plate, and how stiff it is with bulk beams.
struct MatchedCoordination {
  double coordination = 0;    // 2 contacts / N
  double strip_modulus = 0;   // mean over the seeds [Pa]
  double wanted = 0;          // E / (1 - nu^2) of the preset's material [Pa]
  int packings = 0;           // that were made to find it
};

/// The coordination at which the plate, clamped and pulled as a strip, is with bulk beams as stiff as the material
/// that these were calibrated to in cylinders: at 6 a thin plate is half as stiff again or more, because its
/// beams lie in its plane more than a solid's do. By secants on the mean of the seeds' packings, to one per cent.
/// Cost: a packing and a pre-stress for each seed and trial, kept in the cache. Throws as prepare() does, and
/// InputError where no coordination in [4.4, 6] will do.
MatchedCoordination matching_coordination(const scene::Preset& preset, std::span<const int> seeds,
                                          base::Cache& cache, const StageProgress& progress = {});

}  // namespace rift::simulation
