#pragma once

#include "engine/scene/scene.hpp"

#include <span>

/// Memory and disk of runs and studies, before there is a lattice: THE model of them, which `rift check` asks
/// with a lattice's own numbers, `rift list` and dry runs of many scenarios with what is to be expected.
namespace rift::study {

/// How large a lattice is.
struct LatticeSize {
  double elements = 0, beams = 0;
};

/// N elements and three beams of each.
LatticeSize expected_size(const scene::Scene& scene);

/// How often a lane writes its fields and reads its energies.
struct Moments {
  double frames = 0, samples = 0;
};

/// As the scene asks for: samples of the ramp, of the crack, and those that mark the window.
Moments expected_moments(const scene::Scene& scene);

/// Bytes that the folder of a run holds at its end, at most: journal and archive each hold frames and samples
/// once, vectors as if they were not compressed.
double disk_bytes_of_run(const scene::Scene& scene, const LatticeSize& size, std::span<const Moments> lanes);

/// The same with what is to be expected, for lanes of one lattice.
double expected_disk_bytes(std::span<const scene::Scene> lanes);

/// Bytes that a scenario of a study leaves, which keeps no fields: its summary, its series, its share of the
/// report.
double disk_bytes_of_scenario(const scene::Scene& scene);

/// Bytes of memory at the peak of packing, static solution and march.
double expected_memory_bytes(const scene::Scene& scene);

}  // namespace rift::study
