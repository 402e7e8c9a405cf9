#pragma once

#include "engine/packing/packing.hpp"
#include "tests/shared_cache.hpp"

namespace rift::packing {

/// What pack() gives, from the cache of all tests: for tests of what is built on a packing.
inline Packing packed_once(const PackingRequest& request) {
  bool from_cache = false;
  return cached_packing(request, shared_cache(), from_cache);
}

}  // namespace rift::packing
