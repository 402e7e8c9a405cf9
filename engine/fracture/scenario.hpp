#pragma once

#include "engine/fracture/crack_history.hpp"
#include "engine/fracture/release.hpp"

namespace rift {

/// What distinguishes one lane of an ensemble from another.
struct LaneScenario {
  CrackHistory history;
  ReleaseLaw law;
  double alpha_at_surface = 0, alpha_elsewhere = 0;  // fractions of critical damping
};

}  // namespace rift
