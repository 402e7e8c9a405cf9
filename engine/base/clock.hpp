#pragma once

#include <chrono>

namespace rift::base {

using Clock = std::chrono::steady_clock;

/// Wall time since then [s].
inline double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace rift::base
