#pragma once

#include "engine/results/lane_summary.hpp"

#include <string>

namespace rift::studio {

/// The summary of a lane as a person reads it.
std::string run_table(const results::LaneSummary& lane, bool color);

}  // namespace rift::studio
