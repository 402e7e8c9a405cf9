#pragma once

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <vector>

namespace rift::results {

/// The polyline that the crack follows in the x-y plane [m], as the run's header has it.
[[nodiscard]] std::vector<std::array<double, 2>> path_of(const nlohmann::ordered_json& header);

/// Where the tips are [m]. @param tip_m  arc length of the tip; with two tips the half length of the crack
[[nodiscard]] std::vector<std::array<double, 2>> tips_at(const nlohmann::ordered_json& header, double tip_m);

}  // namespace rift::results
