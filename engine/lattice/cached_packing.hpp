#pragma once

#include "engine/cache.hpp"
#include "engine/lattice/packing.hpp"

namespace rift::lattice {

/// Names all that a packing depends on.
std::string key_of(const PackingRequest& request);

/// The packing from the cache, or made and remembered. @param[out] from_cache  set where it was there
Packing cached_packing(const PackingRequest& request, Cache& cache, bool& from_cache,
                       const PackingProgress& progress = {}, int threads = 0);

}  // namespace rift::lattice
