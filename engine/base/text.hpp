#pragma once

#include <string>
#include <string_view>

/// Texts that come from outside: names of files, what a user wrote, what another program said.
namespace rift::base {

/// The text as every terminal, table and page can show it: control characters (C0, DEL and C1) and bytes that
/// are no UTF-8 become \xNN, all else stays. Twice escaped is once escaped.
/// @param kept  control characters that stay, such as "\n\t"
[[nodiscard]] std::string escaped(std::string_view text, std::string_view kept = {});

}  // namespace rift::base
