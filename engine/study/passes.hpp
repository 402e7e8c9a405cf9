#pragma once

#include "engine/simulation/prepare.hpp"

#include <cstdint>
#include <vector>

namespace rift {

/// Positions of the scenarios that march together, the longest first so that none is left over at the end:
/// those of equal step, the damped apart from those that are not. After a ramp no lane can be filled again, so that a
/// pass then holds no more than march side by side.
std::vector<std::vector<std::size_t>> passes_of(const std::vector<LanePlan>& lanes);

/// Lanes side by side with which a queue of scenarios is done soonest. One long scenario beside many short
/// ones wants few lanes, as the last steps are its own; many of a length fill a register.
/// @param[in] steps  of each scenario
int lanes_for_queue(const std::vector<std::int64_t>& steps, Precision precision);

}  // namespace rift
