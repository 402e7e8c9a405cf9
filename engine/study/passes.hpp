#pragma once

#include "engine/simulation/prepare.hpp"

#include <cstdint>
#include <vector>

namespace rift::study {

/// Positions of the scenarios that march together, the longest first so that none is left over at the end:
/// those of equal step, the damped apart from those that are not. After a ramp no lane can be filled again,
/// so that a pass then holds no more than march side by side.
std::vector<std::vector<std::size_t>> passes_of(const std::vector<simulation::LanePlan>& lanes);

/// How a queue of scenarios is done soonest.
struct Queue {
  int lanes = 1;    // side by side
  double time = 0;  // in steps of a kernel whose lanes fill half of 64 bytes
};

/// One long scenario beside many short ones wants few lanes, as the last steps are its own; many of a length
/// fill a register.
/// @param[in] steps  of each scenario
Queue soonest(const std::vector<std::int64_t>& steps, ensemble::Precision precision);

/// Lanes side by side where there is no end of scenarios.
int lanes_of_many(ensemble::Precision precision);

}  // namespace rift::study
