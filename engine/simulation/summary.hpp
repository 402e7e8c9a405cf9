#pragma once

#include "engine/results/lane_summary.hpp"
#include "engine/simulation/march.hpp"
#include "engine/simulation/record.hpp"

namespace rift::simulation {

/// The plateau and the rate curve of a lane's fracture phase.
struct Rates {
  fracture::Plateau plateau;
  std::vector<results::RatePoint> curve;
};
Rates rates_of(const Prepared& prepared, const RunResult& result, int lane = 0);

/// The journal's header, written before the first step: the preset as it is in effect, and what runs it.
nlohmann::ordered_json header_of(const Prepared& prepared, const BuildInfo& build);

/// summary.json: one object per lane under "scenarios", as results::to_json() has it.
/// @param[in] wall_total_s  that the run has taken, in all its calls
nlohmann::ordered_json summary_of(const Prepared& prepared, const RunResult& result,
                                  const std::vector<Rates>& rates, const BuildInfo& build,
                                  double wall_total_s);

/// The summary of one lane in it, which may be asked for as soon as that lane has ended.
results::LaneSummary lane_summary(const Prepared& prepared, const RunResult& result, int lane,
                                  const Rates& rates, const BuildInfo& build, double wall_total_s);

/// The lattice as a viewer needs it.
results::Geometry geometry_of(const Prepared& prepared);

/// The same in double precision with masses and stiffnesses, those of the first lane: to rebuild the run.
results::Mechanics mechanics_of(const Prepared& prepared);

}  // namespace rift::simulation
