#pragma once

#include "engine/results/schema.hpp"

#include <cstdint>
#include <vector>

namespace rift::results {

/// What a viewer colours cells by, in its order of cells: the N vertices, then the B beams.
struct CellFields {
  std::vector<float> damage_factor;  // N + B; 1 for vertices and for beams that the path does not cross
  std::vector<std::uint8_t> broken;  // N + B; 1 where the damage factor is 0
};

/// Spreads the frame's factors, one per crossing beam, over all cells.
/// Asserts that the frame fits the geometry and has damage factors.
[[nodiscard]] CellFields cell_fields(const Geometry& geometry, const Frame& frame);

}  // namespace rift::results
