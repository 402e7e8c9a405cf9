#pragma once

#include "engine/simulation/prepare.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace rift::simulation {

/// The axis of a change that only a crack that runs by itself makes: its tip rests from now on, and the lane
/// ends once nothing can come any more that would set it going again.
inline constexpr std::string_view tip_stops = "tip_stops";

/// Changes the plan of a lane whose crack runs, from the next step on: its scene, its scenario (the beams not
/// yet reached get the new law) and, with a new velocity, what of its schedule is to come.
/// @param[in] step  of the lane, now
/// @return why not (the plan is then as before), or empty
std::string change_lane(LanePlan& lane, const scene::Change& change, const Prepared& prepared,
                        std::int64_t step);

/// Throws InputError: the preset's change cannot be made.
[[noreturn]] void refuse_change(const Prepared& prepared, const scene::Change& change,
                                const std::string& why);

/// What the preset's [[steering]] says from step `now` of a lane on must come to pass: throws InputError
/// where the lane ends before. A new velocity changes how many steps there are: what comes after it is not
/// judged yet.
/// @param[in] lanes  as they are after the changes so far
void check_steering(const Prepared& prepared, const std::vector<LanePlan>& lanes, int lane, std::int64_t now);

}  // namespace rift::simulation
