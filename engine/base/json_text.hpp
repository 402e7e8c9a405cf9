#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace rift::base {

/// The value as JSON text: valid UTF-8 without control characters whatever its strings hold. Bytes that are
/// no UTF-8 become U+FFFD, DEL and C1 characters \u00NN; a number that is not finite becomes null.
/// @param indent  spaces a level, on a line for each value; negative for all on one line
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& value, int indent = -1);
[[nodiscard]] std::string json_text(const nlohmann::json& value, int indent = -1);

}  // namespace rift::base
