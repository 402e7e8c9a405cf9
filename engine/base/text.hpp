#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace rift::base {

// Texts that come from outside: names of files, what a user wrote, what another program said.

/// The text as every terminal, table and page can show it: control characters (C0, DEL and C1) and bytes that
/// are no UTF-8 become \xNN, all else stays. Twice escaped is once escaped.
/// @param kept  control characters that stay, such as "\n\t"
[[nodiscard]] std::string escaped(std::string_view text, std::string_view kept = {});

/// The value as JSON text: valid UTF-8 without control characters whatever its strings hold. Bytes that are
/// no UTF-8 become U+FFFD, DEL and C1 characters \u00NN; a number that is not finite becomes null.
/// @param indent  spaces a level, on a line for each value; negative for all on one line
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& value, int indent = -1);
[[nodiscard]] std::string json_text(const nlohmann::json& value, int indent = -1);

}  // namespace rift::base
