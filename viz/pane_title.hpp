#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace rift::viz {

/// A title for each pane from its scenario (a header's "scenarios"): technique and velocity, and what else
/// tells them apart.
[[nodiscard]] std::vector<std::string> pane_titles(const std::vector<nlohmann::ordered_json>& scenarios);

}  // namespace rift::viz
