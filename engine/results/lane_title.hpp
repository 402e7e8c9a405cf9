#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace rift::results {

/// A title for each lane from its scenario (a header's "scenarios"): what tells the lanes apart stands first,
/// where a narrow screen cuts it last, then what of technique and velocity they have in common.
[[nodiscard]] std::vector<std::string> lane_titles(const std::vector<nlohmann::ordered_json>& scenarios);

}  // namespace rift::results
