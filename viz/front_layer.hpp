#pragma once

#include "engine/results/schema.hpp"

#include <cstdint>
#include <vector>

namespace rift::viz {

/// The elements that are seen from the front (from large z) of the unloaded plate, and those beside the
/// crack, whose opening bares them: the rest is hidden, and need not be drawn. Ascending. Cost O(elements).
[[nodiscard]] std::vector<std::int32_t> front_layer(const results::Geometry& geometry);

}  // namespace rift::viz
