#pragma once

#include "engine/lattice/lattice.hpp"

#include <vector>

namespace rift::lattice {

/// The size of a load that rises in proportion to time from its beginning on and then stays: a dead load,
/// whatever moves under it.
struct StepLoad {
  double size = 0;  // in units of the forces that it multiplies
  double rise = 0;  // [s]; 0: at once
};

inline double load_at(const StepLoad& load, double time) {
  if (time >= load.rise) return load.size;
  return time <= 0.0 ? 0.0 : load.size * (time / load.rise);
}

/// How deep under a face a traction acts, in radii of each element: so deep that none that hangs by one beam
/// bears a share of its own.
inline constexpr double traction_depth = 3.0;

/// Forces of opposite tractions of 1 Pa on the two faces across an axis, which pull them apart: on each face
/// its area in all, with the resultant in its middle, so that nothing turns; on the elements down to
/// traction_depth, in proportion to their numbers of beams as nearly as that allows.
/// @param[in] axis  0, 1, 2 for x, y, z
/// @return N forces and moments [N for 1 Pa]. Throws PackingError where a face has fewer than three elements.
std::vector<Vector6> opposite_tractions(const Lattice& lattice, int axis);

}  // namespace rift::lattice
