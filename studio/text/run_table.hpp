#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace rift::studio {

/// The results of one scenario of a summary.json as a person reads them.
std::string run_table(const nlohmann::ordered_json& scenario, bool color);

}  // namespace rift::studio
