#pragma once

#include "engine/validation/free_crack.hpp"

#include <Eigen/Core>

#include <vector>

namespace rift::validation {

/// A crack as the stripes across it show it: in each stripe of x the places where gone beams lie together.
struct CrackShape {
  double length = 0;     // [m] of all branches, from place to place
  int tips_at_edge = 0;  // branches that reach the last stripe
};

/// Stripes are 8 mean radii wide from the notch's tip to the far edge. Gone beams of a stripe whose y differ
/// by less than 4 mean radii lie together; fewer than three are no branch. A place is joined to the nearest
/// one of the stripe before, and their distance counts as crack; where none is within three widths of a
/// stripe one width counts. Cracks along y are not seen.
CrackShape shape_of(const FreeCrack& crack);

/// Slope of the line of least squares through the tip's position, at 200 equal times from when it is `margin`
/// beyond the notch until it is as near the far edge [m/s]; NaN where it does not get there or the way is
/// shorter than `least` [m].
double fitted_speed(const FreeCrack& crack, double margin, double least);

}  // namespace rift::validation
