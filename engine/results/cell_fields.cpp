#include "engine/results/cell_fields.hpp"

#include <cassert>

namespace rift::results {

CellFields cell_fields(const Geometry& geometry, const Frame& frame) {
  assert(frame.damage_factor.size() == geometry.crossing.size());
  const std::size_t elements = geometry.position.size();
  CellFields fields{std::vector<float>(elements + geometry.beam.size(), 1.0F),
                    std::vector<std::uint8_t>(elements + geometry.beam.size(), 0)};
  for (std::size_t i = 0; i < frame.damage_factor.size(); ++i) {
    const std::size_t cell = elements + static_cast<std::size_t>(geometry.crossing[i]);
    fields.damage_factor[cell] = frame.damage_factor[i];
    fields.broken[cell] = frame.damage_factor[i] == 0.0F;
  }
  return fields;
}

}  // namespace rift::results
