#include "engine/stability/suite.hpp"

#include "engine/stability/families.hpp"

namespace rift::stability {

std::vector<StabilityCase> stability_cases(const SuiteOptions& options) {
  Cases cases;
  add_free_vibration(cases, options);
  add_forced_steps(cases);
  add_damping(cases);
  add_beams(cases);
  add_packings(cases);
  add_cracks(cases, options);
  add_paths(cases);
  add_small_lattices(cases);
  if (!options.only.empty())
    std::erase_if(
        cases, [&](const StabilityCase& one) { return one.family.find(options.only) == std::string::npos; });
  return cases;
}

}  // namespace rift::stability
