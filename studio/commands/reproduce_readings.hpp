#pragma once

#include "studio/commands/session.hpp"

#include <string>

namespace rift::studio {

/// The name under which `rift reproduce` judges all claims under all readings.
inline constexpr const char* readings_name = "readings";

/// Computes what is missing of the readings' scenarios in the folder, judges them, and writes readings.html and
/// readings.md there.
ExitCode reproduce_readings(const SessionOptions& options, const std::string& folder);

}  // namespace rift::studio
