#include "engine/packing/cached_packing.hpp"

#include <fmt/format.h>

namespace rift::packing {

std::string key_of(const PackingRequest& r) {
  constexpr int version = 3;  // rises whenever pack() gives other packings for the same request
  constexpr const char* shape[] = {"", "", " cylinder", " sphere", " periodic"};  // plates are thin blocks
  std::string key = fmt::format(
      "packing {} box {:a} {:a} {:a} elements {} spread {:a} coordination {:a} seed {}", version,
      r.box.length, r.box.height, r.box.thickness, r.elements, r.radius_spread, r.coordination, r.seed);
  key += shape[static_cast<int>(r.box.shape)];
  if (r.radii == Radii::log_normal) key += " log-normal";
  if (r.solid_fraction > 0.0) key += fmt::format(" solid fraction {:a}", r.solid_fraction);
  return key;
}

Packing cached_packing(const PackingRequest& request, base::Cache& cache, bool& from_cache,
                       const PackingProgress& progress, int threads) {
  Packing packing;
  const std::string key = key_of(request);
  if (const auto numbers = base::recall(cache, "packing", key);
      numbers && numbers->size() == 4UL * request.elements) {
    from_cache = true;
    for (std::size_t k = 0; k < numbers->size(); k += 4) {
      packing.centre.emplace_back((*numbers)[k], (*numbers)[k + 1], (*numbers)[k + 2]);
      packing.radius.push_back((*numbers)[k + 3]);
    }
    return packing;
  }
  packing = pack(request, progress, threads);
  std::vector<double> numbers;
  for (std::size_t i = 0; i < packing.radius.size(); ++i)
    numbers.insert(numbers.end(),
                   {packing.centre[i].x(), packing.centre[i].y(), packing.centre[i].z(), packing.radius[i]});
  base::remember(cache, "packing", key, numbers);
  return packing;
}

}  // namespace rift::packing
