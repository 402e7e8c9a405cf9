#pragma once

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

}  // namespace rift::lattice
