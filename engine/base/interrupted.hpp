#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace rift::base {

/// The user asked to stop while `what` was going on, and nothing of it can be kept.
struct Interrupted : std::runtime_error {
  explicit Interrupted(const std::string& what) : std::runtime_error("stopped while " + what) {}
};

/// Told the fraction done in [0, 1] from time to time; answers false to give up (Interrupted is thrown then).
using ProgressCallback = std::function<bool(double)>;

/// Tells the fraction done; throws Interrupted(what) where the answer is to give up.
inline void tell_or_stop(const ProgressCallback& told, double done, const char* what) {
  if (told && !told(done)) throw Interrupted(what);
}

}  // namespace rift::base
