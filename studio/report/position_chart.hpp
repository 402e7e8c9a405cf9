#pragma once

#include "engine/study/claims.hpp"
#include "studio/report/chart.hpp"

namespace rift::studio {

/// Release rate against tip position, a curve per velocity: the mean over 0.04 of the length and over the
/// specimens, without which a lattice ten elements to 0.01 of the length shows its noise; marked where a
/// boundary's first echo is back. False where there is nothing to draw.
bool draw_ratio_against_position(Chart& chart, const study::Evidence& evidence, study::Selection selection);

/// Fracture energy against tip position, of the first specimen.
bool draw_fracture_against_position(Chart& chart, const study::Evidence& evidence,
                                    study::Selection selection);

}  // namespace rift::studio
