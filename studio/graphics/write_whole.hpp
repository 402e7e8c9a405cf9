#pragma once

#include <chrono>
#include <string_view>

namespace rift::studio {

/// Writes to a terminal, however slow, and gives up when it has taken nothing for so long: one that was
/// stopped by Ctrl-S, say. @return whether all was written
[[nodiscard]] bool write_whole(int descriptor, std::string_view bytes, std::chrono::milliseconds patience);

}  // namespace rift::studio
