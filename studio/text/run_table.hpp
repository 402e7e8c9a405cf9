#pragma once

#include "engine/results/lane_summary.hpp"

#include <string>

namespace rift::studio {

/// "time of the measured history = time of the run − 31.18 µs".
/// @param clock_s  their difference, history_clock_s of a summary
std::string history_clock_text(double clock_s);

/// The summary of a lane as a person reads it.
std::string run_table(const results::LaneSummary& lane, bool color);

}  // namespace rift::studio
