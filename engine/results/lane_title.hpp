#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace rift::results {

/// A title for each lane from its scenario (a header's "scenarios"): technique and velocity, and what else
/// tells them apart.
[[nodiscard]] std::vector<std::string> lane_titles(const std::vector<nlohmann::ordered_json>& scenarios);

}  // namespace rift::results
