#pragma once

#include "engine/base/cache.hpp"
#include "engine/packing/packing.hpp"

namespace rift::packing {

/// Names all that a packing depends on.
std::string key_of(const PackingRequest& request);

/// The packing from the cache, or made and remembered. @param[out] from_cache  set where it was there
Packing cached_packing(const PackingRequest& request, base::Cache& cache, bool& from_cache,
                       const PackingProgress& progress = {}, int threads = 0);

}  // namespace rift::packing
