#pragma once

#include "engine/history/crack_history.hpp"
#include "engine/scene/scene.hpp"

#include <cstdint>
#include <vector>

namespace rift::simulation {

/// Which step does what; steps are counted from the start of the run, loading included.
struct Schedule {
  std::int64_t ramp = 0, hold = 0, fracture = 0;  // steps of each phase
  std::vector<std::int64_t> samples;  // steps after which the energies are read, ascending; 0 is the start
  std::vector<std::int64_t> frames;   // steps after which the fields are written, ascending
  std::int64_t crack_start() const { return ramp + hold; }
  std::int64_t total() const { return ramp + hold + fracture; }
};

/// More steps than any machine takes, and few enough to be counted exactly.
inline constexpr double most_steps = 1e12;

/// Steps of the crack from its start to `end` [m], whole or not: infinite, or NaN, where no number of them
/// brings it there.
double steps_of_crack(const history::CrackHistory& history, double dt, double end);

/// A crack that runs by itself is sampled and shown at even distances of its tip. Else samples over each
/// phase, a power of two of steps apart, and one at each end and sub-division of the window, where the tip is
/// nearest to it; even frames over the fracture phase, its first and last moment among them.
/// @param[in] end     tip position at which the run ends [m]
/// Asks for at most most_steps steps.
/// @param[in] window  tip positions [m]
Schedule make_schedule(const scene::Scene& scene, const history::CrackHistory& history, double dt, double end,
                       const std::array<double, 2>& window);

}  // namespace rift::simulation
