#pragma once

#include "engine/base/cache.hpp"

#include <filesystem>
#include <string>

namespace rift {

/// A folder of the build tree in which all test processes keep what they pack and solve, so that a plate is
/// packed once for all of them. Linking a test program empties it: what is in it is of today's engine.
inline std::filesystem::path shared_cache_home() { return RIFT_TEST_CACHE; }

/// That folder as the engine takes it; `rift` finds the same files there by shared_cache_environment().
inline base::Cache& shared_cache() {
  static base::Cache cache{shared_cache_home() / "rift", {}};
  return cache;
}

/// The assignment that gives a command the shared cache.
inline std::string shared_cache_environment() {
  return "XDG_CACHE_HOME='" + shared_cache_home().string() + "'";
}

}  // namespace rift
