#pragma once

#include "viz/draw/annotation.hpp"

#include <nlohmann/json_fwd.hpp>

namespace rift::viz {

/// Draws around the plate how it is held and pulled, its measures and the way of the crack, as in the paper's
/// Fig. 3.
/// @param plate  where the plate is in the frame [px], unloaded
void add_boundaries(vtkRenderer& overlay, const Box& plate, int text_px,
                    const nlohmann::ordered_json& header);

}  // namespace rift::viz
