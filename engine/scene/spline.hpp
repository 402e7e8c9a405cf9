#pragma once

#include <array>
#include <vector>

namespace rift::scene {

/// Points on the centripetal Catmull-Rom spline through the given ones, these among them: it has no cusps and
/// no loops of its own (Yuksel, Schaefer and Keyser 2011). The ends go on as the points next to them do.
/// @param[in] point   at least two, no two neighbours at one place [m]
/// @param[in] pieces  straight ones from each point to the next
std::vector<std::array<double, 2>> spline_through(const std::vector<std::array<double, 2>>& point,
                                                  int pieces);

}  // namespace rift::scene
