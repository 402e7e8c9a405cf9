#pragma once

#include "engine/fracture/crack_path.hpp"

namespace rift::fracture {

/// Whether a notch that ends at `notch_end` [m] has cut a beam from the beginning: one that is crossed at its
/// end, too. A notch without length cuts nothing; a beam that is crossed at exactly 0 is the crack's then.
inline bool in_notch(const Crossing& crossing, double notch_end) {
  return notch_end > 0.0 && crossing.position <= notch_end;
}

}  // namespace rift::fracture
