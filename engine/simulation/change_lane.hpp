#pragma once

#include "engine/simulation/prepare.hpp"

#include <cstdint>
#include <string>

namespace rift {

/// Changes the plan of a lane whose crack runs, from the next step on: its scene, its scenario (the beams not
/// yet reached get the new law) and, with a new velocity, what of its schedule is to come.
/// @param[in] step  of the lane, now
/// @return why not (the plan is then as before), or empty
std::string change_lane(LanePlan& lane, const Change& change, const Prepared& prepared, std::int64_t step);

}  // namespace rift
