#pragma once

#include <optional>
#include <string>

namespace rift::studio {

/// The seconds of --budget, none for an empty text. A bare number is no time, as anywhere else: throws
/// InputError, in which `command` ("rift study") is named.
std::optional<double> read_budget(const std::string& command, const std::string& text);

}  // namespace rift::studio
