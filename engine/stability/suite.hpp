#pragma once

#include "engine/stability/stability_case.hpp"

#include <functional>
#include <string_view>
#include <vector>

namespace rift::stability {

/// How a suite is run.
struct SuiteOptions {
  bool quick = false;  // the drift over 10,000 steps in place of a million, velocities from 0.01 c_r on
  std::string only;    // families whose name contains it; all where empty
};

/// All cases, in the order of their families. Nothing is computed yet.
std::vector<StabilityCase> stability_cases(const SuiteOptions& options);

/// Growth of the highest mode of a lattice over its step, seen and expected: where explicit integration ends.
struct GrowthCurve {
  double element_bound = 0;            // of the step, over the true critical one
  double iterated = 0;                 // the critical step that Lanczos iteration gives, over the true one
  std::vector<double> step;            // over the true critical step
  std::vector<double> seen, expected;  // per step
};
GrowthCurve growth_around_the_limit();

}  // namespace rift::stability
