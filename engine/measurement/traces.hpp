#pragma once

#include "engine/measurement/instruments.hpp"
#include "engine/scene/units.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rift::measurement {

/// What one instrument recorded, in the measurement's clock.
struct Trace {
  std::string name;  // "grip_force", "k_i", "gauge0_strain_yy", ...
  scene::Dimension dimension = scene::Dimension::none;
  std::vector<double> time, value;  // SI; NaN where nothing was recorded
};

/// Of the grip's load cell and of each gauge, then K_I, K_II and G of the fitted fields against time.
std::vector<Trace> traces_of(const Instruments& seen);

/// Curves of a CSV file with a column "time [us]" and others that are named as traces are, in SI. Throws
/// InputError with each defect's line: times that do not grow, a name or a unit that is unknown, nothing but
/// times.
std::vector<Trace> read_traces(const std::filesystem::path& file, const std::vector<Trace>& known);

/// How far a trace is from a measured one, at the times of the measured one that it covers.
struct TraceDistance {
  int points = 0;
  double rms = 0, largest = 0;  // of the differences
  double span = 0;              // of what was measured there, from its least to its largest
};

/// Nothing where the trace covers none of its times.
std::optional<TraceDistance> distance_between(const Trace& trace, const Trace& measured);

}  // namespace rift::measurement
