#pragma once

#include <stdexcept>
#include <string>

namespace rift {

/// The user asked to stop while `what` was going on, and nothing of it can be kept.
struct Interrupted : std::runtime_error {
  explicit Interrupted(const std::string& what) : std::runtime_error("stopped while " + what) {}
};

}  // namespace rift
