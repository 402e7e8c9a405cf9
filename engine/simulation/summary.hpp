#pragma once

#include "engine/simulation/march.hpp"
#include "engine/simulation/record.hpp"

#include <nlohmann/json_fwd.hpp>

namespace rift::simulation {

/// The plateau and the rate curve of a lane's fracture phase.
struct Rates {
  fracture::Plateau plateau;
  std::vector<results::RatePoint> curve;
};
Rates rates_of(const Prepared& prepared, const RunResult& result, int lane = 0);

/// What the journal says of a run before its first step: the preset as it is in effect, and what runs it.
nlohmann::ordered_json header_of(const Prepared& prepared, const BuildInfo& build);

/// summary.json: one object per lane under "scenarios", names as in docs/results-format.md; what is undefined
/// is null.
/// @param[in] wall_total_s  that the run has taken, in all its calls
nlohmann::ordered_json summary_of(const Prepared& prepared, const RunResult& result,
                                  const std::vector<Rates>& rates, const BuildInfo& build,
                                  double wall_total_s);

/// The object of one lane in it, which may be asked for as soon as that lane has ended.
nlohmann::ordered_json lane_summary(const Prepared& prepared, const RunResult& result, int lane,
                                    const Rates& rates, const BuildInfo& build, double wall_total_s);

/// The lattice as a viewer needs it.
results::Geometry geometry_of(const Prepared& prepared);

}  // namespace rift::simulation
