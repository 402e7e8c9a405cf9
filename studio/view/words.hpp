#pragma once

#include "viz/order.hpp"
#include "viz/plan.hpp"

#include <string>
#include <vector>

/// What the viewer says below its picture.
namespace rift::studio {

/// "frame 12 of 120   t = 12.3 µs   tip 34.5 mm   v 0.50 c_R   uy 0 to 0.4 mm"; "frame 12 of 12 so far" where
/// the runs are not whole yet.
[[nodiscard]] std::string numbers_of(const viz::Answer& answer, const viz::Look& look, int moment,
                                     int moments, bool whole, double rayleigh_m_s);

/// The element or beam with its position, displacement, velocity, energy and damage, and what the nearest
/// gauge shows.
[[nodiscard]] std::string text_of(const viz::Picked& picked);

/// Between two that were asked for: unloaded, and as they are now.
[[nodiscard]] std::string distance_between(const viz::Picked& a, const viz::Picked& b);

/// The colour map that a look has: the one that it names, or that of its field.
[[nodiscard]] std::string colours_of(const viz::Look& look);

/// The arguments of the `rift render` that makes this picture, without the program's name and what is to be
/// written. @param lanes  that were asked for; none: all
[[nodiscard]] std::vector<std::string> render_arguments(const viz::Job& job, const std::vector<int>& lanes);

/// Words as a shell reads them.
[[nodiscard]] std::string shell_line(const std::vector<std::string>& words);

}  // namespace rift::studio
